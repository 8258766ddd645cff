#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/mesh/openmesh/subdivide.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

class Fields;

// Subdivides every face of a piece once (see subdivide). It becomes a body of its own (see remake_piece).
struct SubdividePiece {
  PieceId piece;
  Subdivision scheme = Subdivision::kLoop;

  static constexpr const char* kName = "subdivide";
  std::string words() const;
  size_t weight() const { return 0; }
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SubdividePiece& c);

}  // namespace kerf
