#include "ui/editor/moving/moving.h"

#include "core/base/assert.h"
#include "core/document/commands/edit_piece.h"
#include "ui/editor/shared/pieces/piece_set.h"
#include "ui/render/view/spread.h"

namespace kerf {

namespace {

void show_at(ViewState& view, const PieceId& piece, const PieceMove::Look& at) {
  PieceLook& look = view.look.pieces[piece];
  look.turn = at.turn;
  look.offset = at.offset;
  view.picture_old = true;
}

}  // namespace

const char* why_no_move(const PieceMap& looks) {
  if (const char* why = why_none_chosen(looks)) return why;
  return chosen_pieces(looks) > 1 ? "Several pieces are chosen: choose one alone to move it." : nullptr;
}

const PieceMove& Moving::move() const {
  KERF_ASSERT(move_);
  return *move_;
}

void Moving::begin(const World& world, PieceMove::Kind kind, Vec2 pointer) {
  KERF_ASSERT(why_no_move(view_.look.pieces) == nullptr);
  const PieceId piece = *first_chosen(view_.look.pieces);
  if (view_.spread != 0) {
    view_.spread = 0;
    spread_pieces(world, 0, view_.look);
  }
  const Body& body = world.body(piece.body);
  move_.emplace(kind, piece, body.placement, pivot_of(body, piece.label), view_.seen_first(),
                view_.in_first(pointer));
}

bool Moving::key(int key) {
  KERF_ASSERT(move_);
  return move_->key(key);
}

void Moving::constrain(PieceMove::Axis axis) {
  KERF_ASSERT(move_);
  move_->constrain(axis);
}

void Moving::follow(const World& world, Vec2 pointer, bool snaps) {
  KERF_ASSERT(move_);
  std::optional<MoveSnap> snap;
  if (snaps) snap = MoveSnap{snap_step(view_.frame.unit), std::nullopt};
  if (snaps && move_->kind() == PieceMove::Kind::kMove)
    snap->vertex = vertex_near(world, view_, pointer, move_->piece());
  move_->snap(snap);
  move_->point(view_.seen_first(), view_.in_first(pointer));
  show_at(view_, move_->piece(), move_->look());
}

void Moving::end() {
  show_at(view_, move().piece(), {{1, 0, 0, 0}, Vec3(0)});
  drop_plain(view_.look.pieces);
  move_.reset();
}

std::optional<Command> Moving::confirm() {
  std::optional<Command> command;
  if (move().moves()) command = MovePiece{move_->piece(), move_->placement()};
  end();
  return command;
}

void Moving::drop_if_lost(const World& world) {
  if (move_ && !has_faces(world, move_->piece())) end();
}

}  // namespace kerf
