#include "core/document/history/specks.h"

#include "core/base/angle.h"
#include "core/document/commands/edit_piece.h"

namespace kerf {

bool is_speck(double area, double radius) { return area < kSpeckShare * kPi * radius * radius; }

std::set<PieceId> new_specks(const World& world, const Delta& delta, double radius) {
  std::set<PieceId> found;
  for (const BodyDelta& b : delta.bodies) {
    for (const uint32_t label : b.new_pieces) {
      PieceId piece{b.body, label};
      for (const Detached& d : delta.detached) {
        if (piece == PieceId{d.from, d.label}) piece.body = d.to;
      }
      if (has_faces(world, piece) && is_speck(world.body(piece.body).pieces[label].area, radius))
        found.insert(piece);
    }
  }
  return found;
}

std::set<PieceId> specks(const Document& document) {
  const History& history = document.history();
  std::set<PieceId> all;
  for (size_t i = 0; i < history.position(); ++i) {
    const HistoryStep& step = history.step(i);
    for (const Detached& d : step.detached()) {
      if (all.erase({d.from, d.label}) > 0) all.insert({d.to, d.label});
    }
    if (!history.is_cut_again(i)) all.insert(step.specks().begin(), step.specks().end());
  }
  std::erase_if(all, [&](const PieceId& id) { return !has_faces(document.world(), id); });
  return all;
}

}  // namespace kerf
