#include "ui/editor/moving/moving_feature.h"

#include <GLFW/glfw3.h>

#include "core/base/assert.h"
#include "core/document/commands/edit_piece.h"
#include "ui/editor/moving/moving.h"
#include "ui/editor/moving/piece_handles.h"
#include "ui/editor/moving/placement_rows.h"
#include "ui/editor/shared/picture/distance_mark.h"
#include "ui/editor/shared/pieces/piece_set.h"
#include "ui/editor/shared/selection.h"

namespace kerf {

namespace {

class MovingFeature : public Feature {
 public:
  explicit MovingFeature(Workspace& on) : on_(on) {}

  std::vector<Panel> panels() override {
    return {{"Pieces", Tab::kCut, 601, true, [this] { draw_placement(); }}};
  }
  std::vector<ActionGroup> actions() override {
    return {{240,
             "Edit",
             {move_action("Move the chosen", "G", PieceMove::Kind::kMove),
              move_action("Rotate the chosen", "R", PieceMove::Kind::kTurn), duplicate_action()}}};
  }
  std::vector<Gesture> gestures() const override {
    return {{40, "Left drag on an arrow or a ring",
             "Move or turn the chosen piece, with the tool that picks; Ctrl snaps to steps and vertices"}};
  }

  bool takes(const InputEvent& event, bool in_picture) override;
  std::unique_ptr<Interaction> claim(const Press& press) override;
  const char* hint() const override {
    if (!moving_.moves()) return nullptr;
    return moving_.move().kind() == PieceMove::Kind::kMove ? "Moving a piece" : "Turning a piece";
  }

  void advance(double) override {
    moving_.drop_if_lost(on_.world());
    if (!on_.changes.is_pending()) grab_copy();
  }
  void forget() override { moving_.forget(); }

  void draw_marks(ImDrawList& list) override {
    if (on_.cutting()) return;
    draw_piece_handles(on_.view, pivot(), moving_.now(), on_.pointer_over_picture(), list);
    const std::optional<MoveSnap> snap = moving_.moves() ? moving_.move().snap() : std::nullopt;
    if (snap && snap->vertex) draw_measured_point(on_.view, *snap->vertex, list);
  }
  void mark(Landmarks& landmarks) const override {
    mark_handles(piece_handles(on_.view, pivot()), landmarks);
  }

 private:
  // A drag by one of the handles.
  class DragOfPiece : public Interaction {
   public:
    explicit DragOfPiece(MovingFeature& feature) : feature_(feature) {}
    void move(const InputEvent& event) override {
      if (!over()) feature_.follow_pointer(event);
    }
    void release(const InputEvent&) override {
      if (!over()) feature_.confirm();
    }
    bool over() const override { return !feature_.moving_.moves(); }

   private:
    MovingFeature& feature_;
  };

  std::optional<Vec3> pivot() const {
    return pivot_shown(on_.view, moving_.now(), on_.tool == kPickTool, on_.world());
  }
  UserAction move_action(const char* name, const char* key, PieceMove::Kind kind);
  UserAction duplicate_action();
  void draw_placement();

  void follow_pointer(const InputEvent& event) {
    moving_.follow(on_.world(), event.at, (event.mods & GLFW_MOD_CONTROL) != 0);
  }
  void take_key(int key);
  void confirm() {
    if (const auto command = moving_.confirm()) on_.changes.ask(*command);
  }
  // A copy that was moved is taken back by undo.
  void cancel() {
    if (moves_copy_) on_.changes.ask("Undo", [this] { on_.changes.step_through_history(true); });
    moving_.end();
  }
  void duplicate();
  void grab_copy();

  Workspace& on_;
  Moving moving_{on_.view};
  bool moves_copy_ = false;                   // the piece is a copy that was made for the move
  std::optional<BodyId> newest_before_copy_;  // the body that was the newest when a copy was asked for
  PlacementRows placement_;
};

// While a piece is moved by keys it follows the pointer without a button; a click ends that.
bool MovingFeature::takes(const InputEvent& event, bool in_picture) {
  if (!moving_.moves()) return false;
  if (event.kind == InputEvent::Kind::kKey) {
    take_key(event.button);
    return true;
  }
  if (on_.held) return false;
  if (event.kind == InputEvent::Kind::kMove) follow_pointer(event);
  const bool left = event.button == GLFW_MOUSE_BUTTON_LEFT, right = event.button == GLFW_MOUSE_BUTTON_RIGHT;
  if (event.kind != InputEvent::Kind::kPress || (!left && !right)) return false;
  if (left && in_picture) {
    confirm();
  } else {
    cancel();
  }
  return in_picture;
}

// Enter confirms, Esc cancels, G and R change what is done, the others go to PieceMove::key.
void MovingFeature::take_key(int key) {
  switch (key) {
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      return confirm();
    case GLFW_KEY_ESCAPE:
      return cancel();
    case GLFW_KEY_G:
    case GLFW_KEY_R:
      moving_.begin(on_.world(), key == GLFW_KEY_G ? PieceMove::Kind::kMove : PieceMove::Kind::kTurn,
                    on_.pointer);
      break;
    default:
      if (!moving_.key(key)) return;
      break;
  }
  moving_.follow(on_.world(), on_.pointer, false);
}

std::unique_ptr<Interaction> MovingFeature::claim(const Press& press) {
  if (!picks(on_, press)) return nullptr;
  const auto handle = handle_under(piece_handles(on_.view, pivot()), on_.pointer);
  if (!handle) return nullptr;
  moving_.begin(on_.world(), handle->kind, on_.pointer);
  moving_.constrain(handle->axis);
  moves_copy_ = false;
  return std::make_unique<DragOfPiece>(*this);
}

// The key has its usual meaning unless the tool that picks is in hand and a piece is chosen.
UserAction MovingFeature::move_action(const char* name, const char* key, PieceMove::Kind kind) {
  return {
      .name = name,
      .shortcut = key,
      .tip =
          "The chosen piece follows the pointer: X, Y and Z keep it to an axis, digits give the "
          "amount, Enter or a click ends it, Esc takes it back. The key does it with the tool that "
          "picks in hand.",
      .run =
          [this, kind] {
            cancel_stroke(on_);
            moving_.begin(on_.world(), kind, on_.pointer);
            moves_copy_ = false;
          },
      .why_not = [this] { return why_no_move(on_.view.look.pieces); },
      .has_key_when = [this] { return on_.tool == kPickTool && chosen_pieces(on_.view.look.pieces) > 0; }};
}

UserAction MovingFeature::duplicate_action() {
  return {.name = "Duplicate the chosen",
          .shortcut = "Shift+D",
          .tip = "Adds a copy of the chosen piece, which the pointer then moves.",
          .run = [this] { on_.changes.ask("Duplicate the chosen", [this] { duplicate(); }); },
          .why_not = [this] { return why_no_move(on_.view.look.pieces); }};
}

// A piece that was hidden meanwhile is not chosen any more.
void MovingFeature::duplicate() {
  const auto piece = first_chosen(on_.view.look.pieces);
  if (!piece) return;
  newest_before_copy_ = on_.world().ids().back();
  on_.changes.apply(DuplicatePiece{*piece, on_.world().body(piece->body).placement});
}

// Chooses the copy that was made since it was asked for, if it is there, and begins to move it.
void MovingFeature::grab_copy() {
  const std::optional<BodyId> newest_before = std::exchange(newest_before_copy_, std::nullopt);
  const std::vector<BodyId> ids = on_.world().ids();
  if (!newest_before || ids.empty() || ids.back() == *newest_before) return;
  const Records<Piece>& pieces = on_.world().body(ids.back()).pieces;
  choose_none(on_.view.look.pieces);
  for (uint32_t label = 0; label < pieces.size(); ++label) {
    if (pieces[label].faces > 0) on_.view.look.pieces[{ids.back(), label}].selected = true;
  }
  moving_.begin(on_.world(), PieceMove::Kind::kMove, on_.pointer);
  moves_copy_ = true;
  on_.view.picture_old = true;
}

void MovingFeature::draw_placement() {
  if (const auto command = placement_.draw(on_.world(), on_.view)) on_.changes.ask(*command);
}

}  // namespace

std::unique_ptr<Feature> moving_feature(Workspace& on) { return std::make_unique<MovingFeature>(on); }

}  // namespace kerf
