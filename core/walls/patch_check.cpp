#include "core/walls/patch_check.h"

#include <map>
#include <set>

#include "core/base/assert.h"
#include "core/base/union_find.h"

namespace kerf {

std::optional<PatchFault> fault_of(const WallPatch& patch, std::span<const PatchSide> rim) {
  std::set<PatchSide> sides;
  for (const auto& f : patch.faces) {
    for (size_t i = 0; i < 3; ++i) {
      if (!sides.insert({f[i], f[(i + 1) % 3]}).second) return PatchFault{"two walls meet in one edge", f[i]};
    }
  }
  std::set<PatchSide> at_rim;
  for (const PatchSide& s : rim) {
    if (!at_rim.insert(s).second) return PatchFault{"the rim runs along one edge twice", s.first};
    if (!sides.contains(s)) return PatchFault{"a part of the rim belongs to no wall", s.first};
  }
  for (const auto& [from, to] : sides) {
    if (at_rim.contains({from, to}) == sides.contains({to, from}))
      return PatchFault{"a wall ends in the part", from};
  }
  return std::nullopt;
}

void tell_walls_apart(WallPatch& patch, std::span<const PatchSide> rim, std::span<const RimSide> sides) {
  KERF_ASSERT(rim.size() == sides.size());
  UnionFind together(patch.rim.size() + patch.added.size());
  for (const auto& f : patch.faces) {
    together.unite(f[0], f[1]);
    together.unite(f[1], f[2]);
  }
  std::map<uint32_t, uint32_t> number;
  for (size_t i = 0; i < sides.size(); ++i) {
    const auto [at, is_new] =
        number.try_emplace(together.find(rim[i].first), static_cast<uint32_t>(patch.beside_wall.size()));
    if (is_new) patch.beside_wall.push_back(sides[i].face);
    patch.wall_of_side.push_back(at->second);
  }
  for (const auto& f : patch.faces) patch.wall_of_face.push_back(number.at(together.find(f[0])));
}

}  // namespace kerf
