#include "core/mesh/vertex_fans.h"

#include <algorithm>
#include <cassert>

#include "core/base/parallel.h"

namespace kerf {

namespace {

constexpr size_t kPositionsOfRange = 1 << 14;  // or triangles

uint32_t next_side(uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
uint32_t previous_side(uint32_t side) { return side % 3 == 0 ? side + 2 : side - 1; }

class FanFinder {
 public:
  FanFinder(std::vector<std::array<uint32_t, 3>>& triangles, size_t positions,
            std::span<const uint32_t> partner)
      : triangles_(triangles), partner_(partner), at_(positions) {}

  Result<VertexFans> run(const Progress* progress) {
    ProgressShares shares(progress);
    const Progress counting = shares.next(0.2), walking = shares.next(0.5), naming = shares.next(0.3);
    count_sides();
    if (!counting.report(1)) return cancelled();
    const auto walk = [&](size_t p, size_t end) {
      for (; p < end; ++p) at_[p].fans = fans_at(static_cast<uint32_t>(p));
    };
    if (!for_each_range(at_.size(), kPositionsOfRange, &walking, walk)) return cancelled();
    number_fans_of_shared_positions();
    number_vertices();
    const auto rename = [&](size_t t, size_t end) {
      for (; t < end; ++t) rename_corners(t);
    };
    if (!for_each_range(triangles_.size(), kPositionsOfRange, &naming, rename)) return cancelled();
    return std::move(vertices_);
  }

 private:
  // `fans` of a position with several, until they are numbered.
  static constexpr uint32_t kSeveral = 0xffffffffu;

  // The sides that start at a position, and then its vertices.
  struct Position {
    uint32_t sides = 0;
    uint32_t first_side = kNoSide, last_side = 0;
    uint32_t fans = 0;
    uint32_t first_vertex = 0;
  };

  uint32_t tail(uint32_t side) const { return triangles_[side / 3][side % 3]; }

  void count_sides() {
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      Position& p = at_[tail(s)];
      ++p.sides;
      if (p.first_side == kNoSide) p.first_side = s;
      p.last_side = s;
    }
  }

  // Calls visit(side) for each side of the fan of `start`.
  template <typename Visit>
  void walk_fan(uint32_t start, Visit visit) const {
    uint32_t s = start;
    do {
      visit(s);
      if (partner_[s] == kNoSide) break;
      s = next_side(partner_[s]);
    } while (s != start);
    if (partner_[s] != kNoSide) return;  // the fan is closed
    for (s = partner_[previous_side(start)]; s != kNoSide; s = partner_[previous_side(s)]) visit(s);
  }

  uint32_t fans_at(uint32_t p) const {
    const Position& position = at_[p];
    if (position.sides == 0) return 0;
    uint32_t sides = 0;
    walk_fan(position.first_side, [&](uint32_t) { ++sides; });
    return sides == position.sides ? 1 : kSeveral;
  }

  // Numbers the fans at each position that has several from 0, in the order of their lowest sides.
  void number_fans_of_shared_positions() {
    shared_at_.assign(at_.size(), kNoSide);
    for (uint32_t p = 0; p < at_.size(); ++p) {
      if (at_[p].fans != kSeveral) continue;
      shared_at_[p] = static_cast<uint32_t>(shared_.size());
      shared_.push_back({p, {}});
      at_[p].fans = 0;
    }
    if (shared_.empty()) return;
    fan_of_.assign(partner_.size(), kNoSide);
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      if (shared_at_[tail(s)] != kNoSide && fan_of_[s] == kNoSide) number_fan(s);
    }
  }
  void number_fan(uint32_t lowest_side) {
    Shared& here = shared_[shared_at_[tail(lowest_side)]];
    const uint32_t fan = at_[here.position].fans++;
    uint32_t last = lowest_side;
    walk_fan(lowest_side, [&](uint32_t side) {
      fan_of_[side] = fan;
      last = std::max(last, side);
    });
    here.last_sides.push_back(last);
  }

  void number_vertices() {
    uint32_t vertices = 0;
    for (Position& p : at_) {
      p.first_vertex = vertices;
      vertices += p.fans;
    }
    vertices_.position.resize(vertices);
    vertices_.last_side.resize(vertices);
    for_each_range(at_.size(), kPositionsOfRange, [&](size_t p, size_t end) {
      for (; p < end; ++p) {
        for (uint32_t v = 0; v < at_[p].fans; ++v) {
          vertices_.position[at_[p].first_vertex + v] = static_cast<uint32_t>(p);
          vertices_.last_side[at_[p].first_vertex + v] = at_[p].last_side;
        }
      }
    });
    for (const Shared& s : shared_) {
      std::copy(s.last_sides.begin(), s.last_sides.end(),
                vertices_.last_side.begin() + at_[s.position].first_vertex);
    }
  }

  void rename_corners(size_t t) {
    for (uint32_t i = 0; i < 3; ++i) {
      uint32_t& corner = triangles_[t][i];
      const Position& p = at_[corner];
      corner = p.first_vertex + (p.fans > 1 ? fan_of_[3 * t + i] : 0);
    }
  }

  std::vector<std::array<uint32_t, 3>>& triangles_;
  std::span<const uint32_t> partner_;
  std::vector<Position> at_;
  struct Shared {
    uint32_t position;
    std::vector<uint32_t> last_sides;  // by fan
  };
  std::vector<Shared> shared_;       // the positions with several fans, ascending
  std::vector<uint32_t> shared_at_;  // by position: its number in shared_, or kNoSide
  std::vector<uint32_t> fan_of_;     // by side that starts at such a position: its fan there; empty without
  VertexFans vertices_;
};

}  // namespace

Result<VertexFans> name_vertices(std::vector<std::array<uint32_t, 3>>& triangles, size_t positions,
                                 std::span<const uint32_t> partner, const Progress* progress) {
  assert(partner.size() == 3 * triangles.size());
  return FanFinder(triangles, positions, partner).run(progress);
}

}  // namespace kerf
