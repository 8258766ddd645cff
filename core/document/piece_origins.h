#pragma once

#include <optional>
#include <vector>

#include "core/document/document.h"

namespace kerf {

// Where a piece comes from.
struct PieceOrigin {
  PieceId piece;
  // The label of the piece of the same body from which it came off, and the step of the history that did it.
  // Nothing for what is left of a body, and where the faces that were removed around the piece are not kept.
  std::optional<uint32_t> came_off;
  size_t step = 0;
};

// The origins of all pieces that have faces, ascending by piece. A piece came off in the last step that
// removed a face beside it which had another label then; that label is the one it came off. Linear in the
// faces that the strokes of the history removed and are kept (see HistoryStep::cut_faces).
std::vector<PieceOrigin> piece_origins(const Document& document);

}  // namespace kerf
