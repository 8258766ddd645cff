#include "core/document/commands/pull.h"

#include "core/document/commands/edit_piece.h"

namespace kerf {

std::string Pull::words() const { return "Pull " + piece_words(piece); }

void Pull::write(CommandWriter& line) const {
  line.piece(piece);
  line.point("at", at);
  line.point("to", to);
}

Result<Pull> Pull::read(const CommandReader& line) {
  const auto piece = line.piece();
  if (!piece) return piece.error();
  const auto at = line.point("at");
  if (!at) return at.error();
  const auto to = line.point("to");
  if (!to) return to.error();
  return Pull{*piece, *at, *to};
}

}  // namespace kerf
