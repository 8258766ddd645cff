#pragma once

#include <optional>
#include <string>

#include "core/document/commands.h"
#include "core/mesh/files/mesh_format.h"
#include "core/world/rigid_body.h"
#include "core/world/world.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/viewport.h"
#include "ui/render/view/camera.h"
#include "ui/window/number_text.h"

namespace kerf {

// Snap target of a move: whole steps, or a vertex for the pivot of the piece.
struct MoveSnap {
  double step = 0.01;  // in file units, > 0
  std::optional<Vec3> vertex;
  static constexpr double kDegrees = 5;  // angle step of a turn
};

// Returns a centimetre for files in metres or centimetres, a millimetre for files in millimetres, else a
// tenth of an inch; in file units.
double snap_step(FileUnit unit);

// Returns the visible vertex nearest to the pointer (screen coordinates), except of the moved piece, if it
// lies within about the height of the text. Traverses the tree of each body.
std::optional<Vec3> vertex_near(const World& world, const ViewState& view, Vec2 pointer,
                                const PieceId& moved);

// Moves or turns a piece by pointer, keys and numbers, as a preview. The world is changed once, on
// confirmation.
class PieceMove {
 public:
  enum class Kind { kMove, kTurn };
  enum class Axis { kX, kY, kZ };

  // Begins at the placement of the body of the piece. `pivot` [m, world]: fixed point of a turn. `pointer`:
  // as in CameraView::ray.
  PieceMove(Kind kind, const PieceId& piece, const Placement& from, const Vec3& pivot, const CameraView& view,
            Vec2 pointer);

  // Follows the pointer, unless an amount was typed. If the view has changed since the last call, the piece
  // stays in place and follows the pointer from there.
  void point(const CameraView& view, Vec2 pointer);
  // Handles a key (GLFW_KEY_*): X, Y and Z constrain the move to a world axis or release it; digits, point,
  // minus and Backspace edit the amount. Returns true if the key was handled.
  bool key(int key);
  // Snaps subsequent pointer motion, or not if nullopt. Typed amounts are exact.
  void snap(const std::optional<MoveSnap>& to) { snap_ = to; }
  const std::optional<MoveSnap>& snap() const { return snap_; }
  void constrain(Axis axis) { axis_ = axis; }

  Kind kind() const { return kind_; }
  const PieceId& piece() const { return piece_; }
  const Vec3& pivot() const { return pivot_; }
  std::optional<Axis> axis() const { return axis_; }

  // Returns true if the previewed placement differs from the initial one.
  bool moves() const { return placement() != from_; }
  Placement placement() const;
  // The previewed placement relative to the initial one: maps a point p of the world to turn * p + offset.
  struct Look {
    glm::dquat turn;
    Vec3 offset;
  };
  Look look() const;
  // Describes the move: "Move along X: 0.25 mm". `unit`: of lengths.
  std::string words(const char* unit) const;

 private:
  void resume_from(const CameraView& view, Vec2 pointer);
  Vec3 pointed_shift() const;
  Vec3 snapped_shift() const;
  Vec3 shift() const;
  double angle() const;  // [radians]
  Vec3 turning_axis() const;
  bool sees_axis_from_behind() const;
  std::optional<double> typed_amount() const;

  Kind kind_;
  PieceId piece_;
  Placement from_;
  Vec3 pivot_;
  Vec3 facing_;  // unit direction to the eye at the beginning
  CameraView view_;
  Vec2 began_, now_;  // places of the pointer
  std::optional<Axis> axis_;
  Vec3 carried_{0};    // by the pointer before the view changed [m]
  double turned_ = 0;  // by the pointer [radians, counterclockwise in the view], not limited to a full turn
  std::string typed_;
  std::optional<MoveSnap> snap_;
};

Vec3 direction_of(PieceMove::Axis axis);

// Returns the centre of area of a piece in the world, its pivot. Precondition: the body has this label.
Vec3 pivot_of(const Body& body, uint32_t label);

// Returns why no piece can be moved, as a sentence, or null. Exactly one must be selected.
const char* move_disabled_reason(const PieceMap& looks);

// Interactive move of the selected piece, previewed until confirmed. Places of the pointer are in the
// window, in screen coordinates.
class Moving {
 public:
  // The view must outlive it.
  explicit Moving(ViewState& view) : view_(view) {}

  bool moves() const { return move_.has_value(); }
  const std::optional<PieceMove>& now() const { return move_; }
  // Precondition of all functions except begin() and forget(): moves().
  const PieceMove& move() const;

  // Begins to move the selected piece; resets an exploded view first. Precondition: move_disabled_reason()
  // returns null.
  void begin(const World& world, PieceMove::Kind kind, Vec2 pointer);
  // Handles a key (see PieceMove::key).
  bool key(int key);
  void constrain(PieceMove::Axis axis);
  // Updates the preview. With `snaps`, pointer motion snaps to a vertex near the pointer or to whole steps
  // (see MoveSnap).
  void follow(const World& world, Vec2 pointer, bool snaps);
  // Ends the move and shows the piece at its place in the world.
  void end();
  // Like end(), and returns the command that moves the piece; nullopt if it does not move.
  std::optional<Command> confirm();
  // Ends the move if its piece does not exist or is not the only selected one, as after it was hidden.
  void drop_if_lost(const World& world);
  // Discards the move because another document was opened.
  void forget() { move_.reset(); }

 private:
  ViewState& view_;
  std::optional<PieceMove> move_;
};

// A handle of the selected piece, shown with the Select tool: an arrow along each world axis that moves the
// piece, and a ring about each that turns it. Landmarks: "move X", "turn Y".
struct PieceHandle : GizmoHandle {
  PieceMove::Kind kind = PieceMove::Kind::kMove;
  PieceMove::Axis axis = PieceMove::Axis::kX;
};

// Returns the pivot of the moved piece or, with the Select tool (`picks`), of the selected one. Returns
// nullopt unless exactly one piece is selected, or if the pivot lies behind the eye.
std::optional<Vec3> pivot_shown(const ViewState& view, const std::optional<PieceMove>& move, bool picks,
                                const World& world);

// Returns the handles around a pivot; none without one.
std::vector<PieceHandle> piece_handles(const ViewState& view, const std::optional<Vec3>& pivot);

// Draws the handles, with the one at `pointer` highlighted; during a move draws the locked axis and a
// description instead.
void draw_piece_handles(const ViewState& view, const std::optional<Vec3>& pivot,
                        const std::optional<PieceMove>& move, Vec2 pointer, ImDrawList& list);

// Converts to and from angles in degrees: the orientation turns about the world axes X, then Y, then Z. The
// angle about Y is in [-90, 90]. At its ends, where X and Z turn about the same axis, the angle about Z is 0.
Vec3 angles_of(const glm::dquat& orientation);
glm::dquat orientation_of(const Vec3& angles);

// Fields for the placement of the selected piece: its centre of area in file units, and its angles about
// this centre.
class PlacementRows {
 public:
  // Unless exactly one piece is selected, the fields are empty, so that rows below keep their place. Returns
  // the command when a field is confirmed by Enter or left.
  std::optional<Command> draw(const World& world, const ViewState& view);

 private:
  std::optional<Command> draw_fields(const World& world, const ViewState& view, const PieceId& piece);
  void draw_empty(const char* why);

  NumberFields fields_;
  std::optional<PieceId> edited_;  // whose placement is shown
};

}  // namespace kerf
