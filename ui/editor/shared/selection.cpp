#include "ui/editor/shared/selection.h"

#include "ui/editor/shared/pieces/piece_set.h"
#include "ui/render/bodies/pick.h"

namespace kerf {

void choose_under_pointer(Workspace& on, bool add) {
  if (on.view.in_second) return on.message.say("Pieces are chosen in the left half.", true);
  const Vec2 p = on.view.in_picture(on.pointer);
  const std::optional<Pick> seen = pick(on.world(), on.view.look, on.view.seen().ray(p.x, p.y));
  if (seen) {
    const uint32_t label = on.world().body(seen->body).mesh.data(seen->face).piece;
    choose_piece(on.view.look.pieces, {seen->body, label}, add);
  } else if (!add) {
    choose_none(on.view.look.pieces);
  }
  on.view.picture_old = true;
}

std::vector<PieceId> chosen_ids(const PieceMap& looks) {
  std::vector<PieceId> chosen;
  for (const auto& [id, look] : looks) {
    if (look.selected) chosen.push_back(id);
  }
  return chosen;
}

}  // namespace kerf
