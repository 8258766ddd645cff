#pragma once

#include <optional>
#include <vector>

#include "core/world/world.h"

namespace kerf {

// The reason why a piece stays where it is and in one.
enum class Holder {
  kNothing,  // the piece came off: it only stays until it is moved or time passes
  kItself,   // a body in one part, on which nothing else acts
  kBody,     // several parts that are not connected; they move together because they are one body
  kPin,      // the body is pinned
};

// "nothing", "itself", "body" or "pin".
const char* name_of(Holder holder);

// A node of the graph of pieces.
struct PieceNode {
  PieceId piece;
  // The piece from which it came off, as it is named at the position of the history, and the step that did
  // it. Nothing for what is left of a body, and where it is not known (see HistoryStep::came_off).
  std::optional<PieceId> came_off;
  size_t step = 0;
  Holder held_by = Holder::kNothing;
  size_t parts = 1;   // components of its faces
  size_t beside = 0;  // other pieces of the same body that have faces
};

// The pieces that have faces, ascending by piece, without what they came off. O(pieces + loaded components).
std::vector<PieceNode> piece_nodes(const World& world);

}  // namespace kerf
