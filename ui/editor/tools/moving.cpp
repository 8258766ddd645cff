#include "ui/editor/tools/moving.h"

#include <GLFW/glfw3.h>

#include "core/base/assert.h"
#include "core/document/commands/edit_piece.h"
#include "ui/editor/view/piece_set.h"
#include "ui/render/spread.h"

namespace kerf {

namespace {

// The pointer as CameraView::ray takes it, in the half that shows the open document.
Vec2 in_first(const ViewState& view, Vec2 at) {
  const Vec2 p = (at - view.layout.first.at) / view.layout.first.size;
  return {2 * p.x - 1, 1 - 2 * p.y};
}

void show_at(ViewState& view, const PieceId& piece, const PieceMove::Look& at) {
  PieceLook& look = view.look.pieces[piece];
  look.turn = at.turn;
  look.offset = at.offset;
  view.picture_old = true;
}

void end_move(Hand& hand, ViewState& view) {
  show_at(view, hand.move->piece(), {{1, 0, 0, 0}, Vec3(0)});
  drop_plain(view.look.pieces);
  hand.move.reset();
  hand.moves_copy = false;
  if (hand.drag == Drag::kPiece) hand.drag = Drag::kNone;
}

}  // namespace

const char* why_no_move(const PieceMap& looks) {
  if (const char* why = why_none_chosen(looks)) return why;
  return chosen_pieces(looks) > 1 ? "Several pieces are chosen: choose one alone to move it." : nullptr;
}

void begin_move(Hand& hand, ViewState& view, const World& world, PieceMove::Kind kind) {
  KERF_ASSERT(why_no_move(view.look.pieces) == nullptr);
  const PieceId piece = *first_chosen(view.look.pieces);
  if (view.spread != 0) {
    view.spread = 0;
    spread_pieces(world, 0, view.look);
  }
  const Body& body = world.body(piece.body);
  hand.move.emplace(kind, piece, body.placement, pivot_of(body, piece.label), view.seen_first(),
                    in_first(view, hand.pointer));
}

void follow_move(Hand& hand, ViewState& view) {
  KERF_ASSERT(hand.move);
  hand.move->point(view.seen_first(), in_first(view, hand.pointer));
  show_at(view, hand.move->piece(), hand.move->look());
}

bool cancel_move(Hand& hand, ViewState& view, Requests& requests) {
  if (!hand.move) return false;
  if (hand.moves_copy) requests.undo = true;
  end_move(hand, view);
  return true;
}

void confirm_move(Hand& hand, ViewState& view, Requests& requests) {
  KERF_ASSERT(hand.move);
  if (hand.move->moves())
    requests.commands.emplace_back(MovePiece{hand.move->piece(), hand.move->placement()});
  end_move(hand, view);
}

void drop_lost_move(Hand& hand, ViewState& view, const World& world) {
  if (hand.move && !has_faces(world, hand.move->piece())) end_move(hand, view);
}

void move_key(Hand& hand, ViewState& view, const World& world, Requests& requests, int key) {
  KERF_ASSERT(hand.move);
  switch (key) {
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      return confirm_move(hand, view, requests);
    case GLFW_KEY_ESCAPE:
      cancel_move(hand, view, requests);
      return;
    case GLFW_KEY_G:
    case GLFW_KEY_R:
      begin_move(hand, view, world, key == GLFW_KEY_G ? PieceMove::Kind::kMove : PieceMove::Kind::kTurn);
      break;
    default:
      if (!hand.move->key(key)) return;
      break;
  }
  follow_move(hand, view);
}

void grab_copy(Hand& hand, ViewState& view, const World& world) {
  const std::optional<BodyId> newest_before = std::exchange(hand.newest_before_copy, std::nullopt);
  const std::vector<BodyId> ids = world.ids();
  if (!newest_before || ids.empty() || ids.back() == *newest_before) return;
  const Records<Piece>& pieces = world.body(ids.back()).pieces;
  choose_none(view.look.pieces);
  for (uint32_t label = 0; label < pieces.size(); ++label) {
    if (pieces[label].faces > 0) view.look.pieces[{ids.back(), label}].selected = true;
  }
  begin_move(hand, view, world, PieceMove::Kind::kMove);
  hand.moves_copy = true;
  view.picture_old = true;
}

}  // namespace kerf
