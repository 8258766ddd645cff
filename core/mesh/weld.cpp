#include "core/mesh/weld.h"

#include <array>
#include <bit>

#include "core/base/hash.h"

namespace kerf {

namespace {

uint64_t position_hash(const Vec3& p) {
  return hash_combine(hash_combine(mix64(number_bits(p.x)), number_bits(p.y)), number_bits(p.z));
}

// The slots of a hash table in which the next positions are looked up first. They are prefetched, because
// nearly every one of them is a cache miss.
class SlotsAhead {
 public:
  SlotsAhead(std::span<const Vec3> positions, const std::vector<uint32_t>& table)
      : positions_(positions), table_(table) {
    for (uint32_t i = 0; i < kAhead; ++i) look_at(i);
  }
  size_t next(uint32_t i) {
    const size_t slot = slots_[i % kAhead];
    look_at(i + kAhead);
    return slot;
  }

 private:
  static constexpr uint32_t kAhead = 16;

  void look_at(uint32_t i) {
    if (i >= positions_.size()) return;
    size_t& slot = slots_[i % kAhead] = position_hash(positions_[i]) & (table_.size() - 1);
    __builtin_prefetch(&table_[slot]);
  }

  std::span<const Vec3> positions_;
  const std::vector<uint32_t>& table_;
  std::array<size_t, kAhead> slots_;
};

}  // namespace

Result<std::vector<uint32_t>> weld_positions(std::span<const Vec3> positions, const Progress* progress) {
  constexpr uint32_t kFree = 0xffffffffu;
  const size_t slots = std::bit_ceil(2 * positions.size() + 1);
  std::vector<uint32_t> table(slots, kFree);
  std::vector<uint32_t> first(positions.size());
  SlotsAhead ahead(positions, table);
  Pace pace(progress, positions.size());
  for (uint32_t i = 0; i < positions.size(); ++i) {
    if (!pace.step()) return cancelled();
    size_t slot = ahead.next(i);
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
