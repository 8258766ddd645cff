#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/mesh/openmesh/simplify.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

class Fields;

// Simplifies a piece to a number of faces or to an error in metres (see simplify). It becomes a body of its
// own (see remake_piece).
struct SimplifyPiece {
  PieceId piece;
  SimplifyTarget target;

  static constexpr const char* kName = "simplify";
  std::string words() const;
  size_t weight() const { return 0; }
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SimplifyPiece& c);

}  // namespace kerf
