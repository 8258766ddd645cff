#pragma once

#include <optional>
#include <string>

#include "core/document/commands.h"
#include "core/mesh/files/mesh_format.h"
#include "core/world/rigid_body.h"
#include "core/world/world.h"
#include "ui/editor/shared/viewport.h"
#include "ui/render/view/camera.h"

namespace kerf {

// What a move snaps to: whole steps, or a vertex to which the pivot of the piece goes.
struct MoveSnap {
  double step = 0.01;  // in the numbers of the file, > 0
  std::optional<Vec3> vertex;
  static constexpr double kDegrees = 5;  // of a turn
};

// A centimetre where the file has metres or centimetres, a millimetre where it has millimetres, else a tenth
// of an inch.
double snap_step(FileUnit unit);

// The vertex of what is seen under the pointer (screen coordinates), without the piece that is moved, if one
// is seen within about the height of the text. Costs a traversal of each body's tree.
std::optional<Vec3> vertex_near(const World& world, const ViewState& view, Vec2 pointer,
                                const PieceId& moved);

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

// The sentence why no piece can be moved, or null: exactly one has to be chosen.
const char* why_no_move(const PieceMap& looks);

// The chosen piece while it is moved or turned, on the picture alone until that is confirmed. Places of the
// pointer are of the window (screen coordinates).
class Moving {
 public:
  // The view must outlive it.
  explicit Moving(ViewState& view) : view_(view) {}

  bool moves() const { return move_.has_value(); }
  const std::optional<PieceMove>& now() const { return move_; }
  // Precondition of all but begin() and forget(): moves().
  const PieceMove& move() const;

  // Begins with the chosen piece. Precondition: why_no_move() gives no reason. Pieces that are drawn apart
  // stand together before.
  void begin(const World& world, PieceMove::Kind kind, Vec2 pointer);
  // Takes a key (see PieceMove::key).
  bool key(int key);
  void constrain(PieceMove::Axis axis);
  // Shows the piece where the pointer and the keys have it so far. With `snaps`, what follows the pointer
  // goes to a vertex near it or by whole steps (see MoveSnap).
  void follow(const World& world, Vec2 pointer, bool snaps);
  // Ends it, and shows the piece where it stands in the world.
  void end();
  // The same, and returns the command that moves the piece; nothing where it goes nowhere.
  std::optional<Command> confirm();
  // Ends a move whose piece is gone.
  void drop_if_lost(const World& world);
  // Another document is open.
  void forget() { move_.reset(); }

 private:
  ViewState& view_;
  std::optional<PieceMove> move_;
};

}  // namespace kerf
