#include "core/mesh/weld.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/random.h"

namespace kerf {

namespace {

uint64_t position_hash(const Vec3& p) {
  return hash_combine(hash_combine(mix64(number_bits(p.x)), number_bits(p.y)), number_bits(p.z));
}

// Prefetches the hash table slots of the next positions, because nearly every one of them is a cache miss.
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

namespace {

constexpr size_t kTrianglesOfRange = 1 << 12;

bool is_finite(const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

class Choice {
 public:
  Choice(const Soup& soup, std::span<const uint32_t> welded)
      : soup_(soup),
        welded_(welded),
        all_finite_(std::all_of(soup.positions.begin(), soup.positions.end(), is_finite)) {}

  Result<UsableTriangles> run(const Progress* progress) {
    ProgressShares shares(progress);
    const Progress counting = shares.next(0.5), copying = shares.next(0.5);
    counts_.resize(range_count(soup_.triangles.size(), kTrianglesOfRange) + 1);
    const auto count = [&](size_t t, size_t end) {
      count_usable(t, end, counts_[t / kTrianglesOfRange + 1]);
    };
    if (!for_each_range(soup_.triangles.size(), kTrianglesOfRange, &counting, count)) return cancelled();
    for (size_t r = 1; r < counts_.size(); ++r) {
      counts_[r].usable += counts_[r - 1].usable;
      usable_.degenerate += counts_[r].degenerate;
      usable_.non_finite += counts_[r].non_finite;
    }
    usable_.triangles.resize(counts_.back().usable);
    if (!soup_.materials.empty()) usable_.materials.resize(counts_.back().usable);
    if (counts_.back().usable < soup_.triangles.size()) usable_.sources.resize(counts_.back().usable);
    const auto copy = [&](size_t t, size_t end) {
      copy_usable(t, end, counts_[t / kTrianglesOfRange].usable);
    };
    if (!for_each_range(soup_.triangles.size(), kTrianglesOfRange, &copying, copy)) return cancelled();
    copy_parts();
    return std::move(usable_);
  }

 private:
  struct Counts {
    size_t usable = 0, degenerate = 0, non_finite = 0;
  };

  Soup::Triangle corners(size_t t) const {
    const auto& [a, b, c] = soup_.triangles[t];
    assert(std::max({a, b, c}) < welded_.size());
    return {welded_[a], welded_[b], welded_[c]};
  }
  bool has_finite_corners(const Soup::Triangle& w) const {
    const auto finite = [&](uint32_t p) { return is_finite(soup_.positions[p]); };
    return all_finite_ || std::all_of(w.begin(), w.end(), finite);
  }
  static bool has_equal_corners(const Soup::Triangle& w) {
    return w[0] == w[1] || w[1] == w[2] || w[2] == w[0];
  }
  bool is_usable(size_t t) const {
    const Soup::Triangle w = corners(t);
    return has_finite_corners(w) && !has_equal_corners(w);
  }

  void count_usable(size_t t, size_t end, Counts& counts) const {
    for (; t < end; ++t) {
      const Soup::Triangle w = corners(t);
      if (!has_finite_corners(w))
        ++counts.non_finite;
      else if (has_equal_corners(w))
        ++counts.degenerate;
      else
        ++counts.usable;
    }
  }

  void copy_usable(size_t t, size_t end, size_t to) {
    for (; t < end; ++t) {
      if (!is_usable(t)) continue;
      usable_.triangles[to] = corners(t);
      if (!soup_.materials.empty()) usable_.materials[to] = soup_.materials[t];
      if (!usable_.sources.empty()) usable_.sources[to] = static_cast<uint32_t>(t);
      ++to;
    }
  }

  // Returns the number of usable triangles before triangle t of the soup.
  uint32_t usable_before(uint32_t t) const {
    if (counts_.back().usable == soup_.triangles.size()) return t;
    const size_t range = t / kTrianglesOfRange;
    size_t count = counts_[range].usable;
    for (size_t i = range * kTrianglesOfRange; i < t; ++i) count += is_usable(i);
    return static_cast<uint32_t>(count);
  }

  void copy_parts() {
    for (const MeshPart& part : soup_.parts) {
      const uint32_t first = usable_before(part.first), last = usable_before(part.last);
      if (first < last) usable_.parts.push_back({part.name, first, last});
    }
  }

  const Soup& soup_;
  std::span<const uint32_t> welded_;
  bool all_finite_;
  std::vector<Counts> counts_;  // by range, from 1 on; later `usable` is the total of all ranges before
  UsableTriangles usable_;
};

}  // namespace

Result<UsableTriangles> usable_triangles(const Soup& soup, std::span<const uint32_t> welded,
                                         const Progress* progress) {
  assert(welded.size() == soup.positions.size());
  return Choice(soup, welded).run(progress);
}

}  // namespace kerf
