#include "core/walls/patch_check.h"

#include <algorithm>
#include <map>

#include "core/base/assert.h"
#include "core/base/union_find.h"

namespace kerf {

std::optional<PatchFault> fault_of(const WallPatch& patch, std::span<const PatchSide> rim) {
  std::vector<PatchSide> sides, at_rim(rim.begin(), rim.end());
  for (const auto& f : patch.faces) {
    for (size_t i = 0; i < 3; ++i) sides.emplace_back(f[i], f[(i + 1) % 3]);
  }
  std::sort(sides.begin(), sides.end());
  std::sort(at_rim.begin(), at_rim.end());
  const auto contains = [](const std::vector<PatchSide>& list, const PatchSide& side) {
    return std::binary_search(list.begin(), list.end(), side);
  };
  if (const auto twice = std::adjacent_find(sides.begin(), sides.end()); twice != sides.end())
    return PatchFault{"two walls meet in one edge", twice->first};
  if (const auto twice = std::adjacent_find(at_rim.begin(), at_rim.end()); twice != at_rim.end())
    return PatchFault{"the rim runs along one edge twice", twice->first};
  for (const PatchSide& s : at_rim) {
    if (!contains(sides, s)) return PatchFault{"a part of the rim belongs to no wall", s.first};
  }
  for (const PatchSide& s : sides) {
    if (contains(at_rim, s) == contains(sides, {s.second, s.first}))
      return PatchFault{"a wall ends in the part", s.first};
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
