#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/mesh/openmesh/smooth.h"
#include "core/mesh/openmesh/subdivide.h"
#include "core/mesh/remesh/simplify_target.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

class Fields;

// Commands that give a piece another mesh. It becomes a body of its own (see remake_piece). run() does the
// command (see HappensAtOnce).

// Simplifies a piece to a number of faces or to an error in metres (see simplify).
struct SimplifyPiece {
  PieceId piece;
  SimplifyTarget target;

  static constexpr const char* kName = "simplify-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SimplifyPiece& c);

// Subdivides every face of a piece once (see subdivide).
struct SubdividePiece {
  PieceId piece;
  Subdivision scheme = Subdivision::kLoop;

  static constexpr const char* kName = "subdivide-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SubdividePiece& c);

// Smooths a piece (see smooth).
struct SmoothPiece {
  PieceId piece;
  size_t times = 1;

  static constexpr const char* kName = "smooth-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SmoothPiece& c);

// Turns the closed parts of a piece that lie in others and overlap with them (see turn_shells).
struct TurnShells {
  PieceId piece;

  static constexpr const char* kName = "turn-shells";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, TurnShells& c);

}  // namespace kerf
