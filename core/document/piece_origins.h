#pragma once

#include <optional>
#include <vector>

#include "core/document/document.h"

namespace kerf {

// Where a piece comes from.
struct PieceOrigin {
  PieceId piece;
  // The piece from which it came off, as it is named after the last step of the history, and the step that
  // did it. Nothing for what is left of a body, and where it is not known (see HistoryStep::came_off).
  std::optional<PieceId> came_off;
  size_t step = 0;
};

// The origins of all pieces that have faces, ascending by piece. O(p log p) in the pieces of the world and
// those that came off in the history, for each step that follows.
std::vector<PieceOrigin> piece_origins(const Document& document);

}  // namespace kerf
