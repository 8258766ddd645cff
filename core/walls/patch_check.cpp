#include "core/walls/patch_check.h"

#include <algorithm>
#include <map>

#include "core/base/assert.h"
#include "core/base/union_find.h"
#include "core/walls/side_index.h"

namespace kerf {

Resumable<std::optional<PatchFault>> fault_of(const WallPatch& patch, std::span<const PatchSide> rim) {
  const size_t vertices = patch.rim.size() + patch.added.size();
  const SideIndex sides(patch.faces, vertices);
  co_await worked(patch.faces.size() / 16);
  std::vector<PatchSide> at_rim(rim.begin(), rim.end());
  std::sort(at_rim.begin(), at_rim.end());
  if (const auto twice = std::adjacent_find(at_rim.begin(), at_rim.end()); twice != at_rim.end())
    co_return PatchFault{"the rim runs along one edge twice", twice->first};
  co_await worked(rim.size() / 8);
  for (const PatchSide& s : at_rim) {
    if (!sides.find(s.first, s.second)) co_return PatchFault{"a part of the rim belongs to no wall", s.first};
  }
  for (uint32_t v = 0; v < vertices; ++v) {
    for (const SideIndex::Side& s : sides.from(v)) {
      if (sides.find(v, s.to) != &s) co_return PatchFault{"two walls meet in one edge", v};
      const bool is_inner = sides.find(s.to, v) != nullptr;
      const bool is_at_rim = v < patch.rim.size() && s.to < patch.rim.size() &&
                             std::binary_search(at_rim.begin(), at_rim.end(), PatchSide{v, s.to});
      if (is_at_rim == is_inner) co_return PatchFault{"a wall ends in the part", v};
    }
    co_await worked(1);
  }
  co_return std::nullopt;
}

Resumable<Done> tell_walls_apart(WallPatch& patch, std::span<const PatchSide> rim,
                                 std::span<const RimSide> sides) {
  KERF_ASSERT(rim.size() == sides.size());
  UnionFind together(patch.rim.size() + patch.added.size());
  for (const auto& f : patch.faces) {
    together.unite(f[0], f[1]);
    together.unite(f[1], f[2]);
    co_await worked(1);
  }
  std::map<uint32_t, uint32_t> number;
  for (size_t i = 0; i < sides.size(); ++i) {
    const auto [at, is_new] =
        number.try_emplace(together.find(rim[i].first), static_cast<uint32_t>(patch.beside_wall.size()));
    if (is_new) patch.beside_wall.push_back(sides[i].face);
    patch.wall_of_side.push_back(at->second);
    co_await worked(1);
  }
  for (const auto& f : patch.faces) {
    patch.wall_of_face.push_back(number.at(together.find(f[0])));
    co_await worked(1);
  }
  co_return Done{};
}

}  // namespace kerf
