#pragma once

#include <optional>
#include <string>

#include "core/world/placement.h"
#include "core/world/world.h"
#include "ui/editor/moving/move_snap.h"
#include "ui/render/view/camera.h"

namespace kerf {

// Moving or turning a piece by the pointer, by keys and by numbers, while the picture shows where it would
// stand. The world is changed once, when the user confirms it.
class PieceMove {
 public:
  enum class Kind { kMove, kTurn };
  enum class Axis { kX, kY, kZ };

  // Begins at the placement of the piece's body. `pivot` (m, world) is the point that stays where it is in a
  // turn; `pointer` as in CameraView::ray.
  PieceMove(Kind kind, const PieceId& piece, const Placement& from, const Vec3& pivot, const CameraView& view,
            Vec2 pointer);

  // Follows the pointer, unless an amount was typed. Where the view has changed since, the piece stays where
  // it is and follows the pointer from there.
  void point(const CameraView& view, Vec2 pointer);
  // Takes a key (GLFW_KEY_*): X, Y and Z constrain it to an axis of the world or set it free again; digits,
  // point, minus and Backspace edit the amount. Returns whether it was one of these.
  bool key(int key);
  // Snaps what follows the pointer from now on, or lets it go freely. Amounts that are typed are exact.
  void snap(const std::optional<MoveSnap>& to) { snap_ = to; }
  const std::optional<MoveSnap>& snap() const { return snap_; }
  // Constrains it to an axis.
  void constrain(Axis axis) { axis_ = axis; }

  Kind kind() const { return kind_; }
  const PieceId& piece() const { return piece_; }
  const Vec3& pivot() const { return pivot_; }
  std::optional<Axis> axis() const { return axis_; }

  // Whether the piece would stand elsewhere.
  bool moves() const { return placement() != from_; }
  // Where the piece would stand.
  Placement placement() const;
  // That placement relative to the one at the beginning: a point p of the world goes to turn * p + offset.
  struct Look {
    glm::dquat turn;
    Vec3 offset;
  };
  Look look() const;
  // What it does in words: "Move along X: 0.25 mm". `unit` is that of lengths.
  std::string words(const char* unit) const;

 private:
  void go_on_from(const CameraView& view, Vec2 pointer);
  Vec3 pointed_shift() const;
  Vec3 snapped_shift() const;
  Vec3 shift() const;
  double angle() const;  // radians
  Vec3 turning_axis() const;
  std::optional<double> typed_amount() const;

  Kind kind_;
  PieceId piece_;
  Placement from_;
  Vec3 pivot_;
  CameraView view_;
  Vec2 began_, now_;  // of the pointer
  std::optional<Axis> axis_;
  Vec3 carried_{0};    // m, by the pointer before the view changed
  double turned_ = 0;  // radians, by the pointer; the angle grows beyond full turns
  std::string typed_;
  std::optional<MoveSnap> snap_;
};

// The unit vector of an axis.
Vec3 direction_of(PieceMove::Axis axis);

// The centre of area of a piece in the world, about which it turns. Precondition: the body has this label.
Vec3 pivot_of(const Body& body, uint32_t label);

}  // namespace kerf
