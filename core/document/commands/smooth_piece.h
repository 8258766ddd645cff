#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/mesh/openmesh/smooth.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

class Fields;

// Smooths a piece (see smooth). It becomes a body of its own (see remake_piece).
struct SmoothPiece {
  PieceId piece;
  size_t times = 1;

  static constexpr const char* kName = "smooth";
  std::string words() const;
  size_t weight() const { return 0; }
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SmoothPiece& c);

}  // namespace kerf
