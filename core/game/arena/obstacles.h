#pragma once

#include <optional>
#include <vector>

#include "core/game/arena/arena.h"

namespace kerf {

// The steep faces of an arena that stand fast, against which vehicles drive.
class Obstacles {
 public:
  Obstacles() = default;
  // O(faces).
  explicit Obstacles(const Arena& arena);

  struct Touch {
    Vec3 at{0};           // m, the nearest point of a steep face
    double distance = 0;  // m, from it to the centre of the ball, above 0
  };
  // Where a ball touches a steep face from the side, the deepest place. What lies below the centre by more
  // than the slope on which vehicles drive does not count. Constant time as a rule.
  std::optional<Touch> touched_by(const Vec3& centre, double radius) const;

 private:
  static constexpr double kCell = 2;  // m
  int column(double x) const { return static_cast<int>((x + half_.x) / kCell); }
  int row(double z) const { return static_cast<int>((z + half_.y) / kCell); }
  struct Cells {
    int left, right, low, high;
  };
  // The cells that an interval along x and one along z meet.
  Cells cells_between(const Vec3& low, const Vec3& high) const;

  Vec2 half_{0};  // m, of the arena
  int columns_ = 0, rows_ = 0;
  std::vector<Triangle> faces_;
  std::vector<std::vector<uint32_t>> in_cell_;  // indices of faces, ascending
};

}  // namespace kerf
