#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/document/history/document.h"
#include "core/mesh/openmesh/subdivide.h"
#include "ui/editor/shared/pieces/piece_set.h"

namespace kerf {

// What the Prepare panel does to the chosen pieces, or to all if none is chosen.
struct Preparation {
  enum class Tool { kSimplifyToFaces, kSimplifyToError, kSubdivide, kSmooth, kTurnShells };
  Tool tool = Tool::kSimplifyToFaces;
  size_t faces = 0;  // that are left of all of them; 0: half of what there is
  double error = 0;  // m; 0: a thousandth of the size of the world
  Subdivision scheme = Subdivision::kLoop;
  size_t times = 1;  // that faces are subdivided, or vertices move
  friend bool operator==(const Preparation&, const Preparation&) = default;
};

// The chosen pieces, or all pieces if none is chosen.
std::vector<PieceRow> pieces_to_prepare(const World& world, const PieceMap& looks);

// The number of faces that these pieces have, and that they will have as far as it is known: a simplification
// to an error says only afterwards.
struct FaceForecast {
  size_t before = 0;
  std::optional<size_t> after;
};
FaceForecast forecast(std::span<const PieceRow> pieces, const Preparation& preparation);

// From more faces on a preparation takes longer than a part of a frame.
inline constexpr size_t kQuickToPrepare = 2000;

// What happens, for the user: "Simplifying".
const char* preparation_title(Preparation::Tool tool);

// Why these pieces cannot be prepared so, in one sentence, or null if they can.
const char* why_no_preparation(std::span<const PieceRow> pieces, const Preparation& preparation);

// Applies the commands of a preparation to the pieces, one after the other; of a number of faces each gets
// its share. Where one fails or is stopped, those before it are undone. `progress` may be null. Precondition:
// why_no_preparation() gives no reason.
Outcome prepare_pieces(Document& document, std::span<const PieceRow> pieces, const Preparation& preparation,
                       const Progress* progress);

}  // namespace kerf
