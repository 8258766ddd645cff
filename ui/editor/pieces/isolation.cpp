#include "ui/editor/pieces/isolation.h"

#include <algorithm>

#include "ui/editor/shared/long_change.h"
#include "ui/editor/shared/pieces/piece_set.h"

namespace kerf {

namespace {

std::vector<BodyId> hidden_bodies(const World& world) {
  std::vector<BodyId> hidden;
  for (const BodyId id : world.ids()) {
    if (world.body(id).hidden) hidden.push_back(id);
  }
  return hidden;
}

}  // namespace

std::vector<PieceId> Isolation::to_show_again() const {
  std::vector<PieceId> pieces;
  for (const PieceId& piece : hidden_pieces(on_.view.look.pieces)) {
    const auto found = std::find(isolated_from_.begin(), isolated_from_.end(), piece.body);
    if (on_.world().contains(piece.body) && found != isolated_from_.end()) pieces.push_back(piece);
  }
  return pieces;
}

const char* Isolation::why_not() const {
  if (!to_show_again().empty()) return nullptr;
  if (const char* why = why_none_chosen(on_.view.look.pieces)) return why;
  return other_pieces(on_.world(), on_.view.look.pieces).empty() ? "All pieces are chosen." : nullptr;
}

void Isolation::change() {
  std::vector<PieceId> pieces = to_show_again();
  const bool hide = pieces.empty();
  if (hide) {
    pieces = other_pieces(on_.world(), on_.view.look.pieces);
    hidden_before_ = hidden_bodies(on_.world());
  }
  cancel_stroke(on_);
  on_.changes.change(hide ? "Isolate pieces" : "Show the other pieces", is_small(on_.work.document),
                     edit_all(std::move(pieces), [hide](const PieceId& piece) {
                       return HidePiece{piece, hide};
                     }));
}

void Isolation::follow() {
  if (!hidden_before_) return;
  isolated_from_ = hidden_bodies(on_.world());
  std::erase_if(isolated_from_, [&](const BodyId& id) {
    return std::find(hidden_before_->begin(), hidden_before_->end(), id) != hidden_before_->end();
  });
  hidden_before_.reset();
}

}  // namespace kerf
