#include "ui/editor/pieces/press_on_pieces.h"

#include <GLFW/glfw3.h>

#include "ui/editor/pieces/rubber_band.h"
#include "ui/editor/shared/picture/click.h"
#include "ui/editor/shared/pieces/piece_set.h"
#include "ui/editor/shared/selection.h"

namespace kerf {

namespace {

class PressOnPieces : public Interaction {
 public:
  explicit PressOnPieces(Workspace& on) : on_(on), pressed_at_(on.pointer) {}

  void move(const InputEvent&) override {
    boxes_ = boxes_ || glm::length(on_.pointer - pressed_at_) > kClickReach;
  }
  void release(const InputEvent& event) override {
    const bool add = (event.mods & GLFW_MOD_SHIFT) != 0;
    if (boxes_) {
      choose_in_box(add);
    } else {
      choose_under_pointer(on_, add);
    }
  }
  bool cancel() override { return boxes_; }
  const char* words() const override {
    return boxes_ ? "Choosing what lies wholly in the box; from right to left: what it touches" : nullptr;
  }
  void draw(ImDrawList& list) const override {
    if (boxes_) draw_rubber_band({pressed_at_, on_.pointer}, list);
  }

 private:
  void choose_in_box(bool add) {
    if (on_.view.in_second) return on_.message.say("Pieces are chosen in the left half.", true);
    PieceMap& looks = on_.view.look.pieces;
    if (!add) choose_none(looks);
    const RubberBand band{on_.view.in_picture(pressed_at_), on_.view.in_picture(on_.pointer)};
    for (const PieceId& id : pieces_in(band, on_.world(), on_.view.look, on_.view.seen()))
      looks[id].selected = true;
    on_.view.picture_old = true;
  }

  Workspace& on_;
  Vec2 pressed_at_;
  bool boxes_ = false;
};

}  // namespace

std::unique_ptr<Interaction> press_on_pieces(Workspace& on) { return std::make_unique<PressOnPieces>(on); }

}  // namespace kerf
