#include "core/mesh/weld.h"

#include <bit>

#include "core/base/hash.h"

namespace kerf {

namespace {

uint64_t position_hash(const Vec3& p) {
  return hash_combine(hash_combine(mix64(number_bits(p.x)), number_bits(p.y)), number_bits(p.z));
}

}  // namespace

Result<std::vector<uint32_t>> weld_positions(std::span<const Vec3> positions, const Progress* progress) {
  constexpr uint32_t kFree = 0xffffffffu;
  const size_t slots = std::bit_ceil(2 * positions.size() + 1);
  std::vector<uint32_t> table(slots, kFree);
  std::vector<uint32_t> first(positions.size());
  Pace pace(progress, positions.size());
  for (uint32_t i = 0; i < positions.size(); ++i) {
    if (!pace.step()) return cancelled();
    size_t slot = position_hash(positions[i]) & (slots - 1);
    // A NaN compares unequal to itself, so such a position never joins another.
    while (table[slot] != kFree && positions[table[slot]] != positions[i]) slot = (slot + 1) & (slots - 1);
    if (table[slot] == kFree) table[slot] = i;
    first[i] = table[slot];
  }
  return first;
}

std::vector<uint32_t> weld_positions(std::span<const Vec3> positions) {
  return std::move(*weld_positions(positions, nullptr));
}

}  // namespace kerf
