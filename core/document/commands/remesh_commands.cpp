#include "core/document/commands/remesh_commands.h"

#include <cmath>

#include "core/document/commands/edit_piece.h"
#include "core/document/commands/remake_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/world_fields.h"
#include "core/mesh/remesh/simplify.h"
#include "core/mesh/remesh/turn_shells.h"

namespace kerf {

std::string SimplifyPiece::words(const std::string& piece_name) const { return "Simplify " + piece_name; }

void describe(Fields& f, SimplifyPiece& c) {
  piece_field(f, c.piece);
  if (f.present("error", std::isfinite(c.target.error))) {
    f.number("error", c.target.error, kPositive);
    f.present("faces", false);
  } else {
    f.whole("faces", c.target.faces, 1, FaceId::kNone);
  }
}

Result<Delta> SimplifyPiece::run(World& world, uint32_t generation, const Progress* progress) const {
  return remake_piece(
      world, piece, generation,
      [&](const Mesh& mesh, const HeededFaces& heeded, const Progress* working) {
        return simplify(mesh, target, heeded.kept, working, heeded.warm);
      },
      progress);
}

std::string SubdividePiece::words(const std::string& piece_name) const { return "Subdivide " + piece_name; }

void describe(Fields& f, SubdividePiece& c) {
  piece_field(f, c.piece);
  f.choice("scheme", c.scheme, kSubdivisionNames);
}

Result<Delta> SubdividePiece::run(World& world, uint32_t generation, const Progress* progress) const {
  if (has_faces(world, piece) && world.body(piece.body).pieces[piece.label].faces > kMostToSubdivide)
    return bad_input(piece_words(piece) + " has too many faces to be subdivided");
  return remake_piece(
      world, piece, generation,
      [&](const Mesh& mesh, const HeededFaces& heeded, const Progress* working) {
        return subdivide(mesh, scheme, heeded.kept, working);
      },
      progress);
}

std::string SmoothPiece::words(const std::string& piece_name) const {
  return "Smooth " + piece_name + (times == 1 ? "" : ", " + std::to_string(times) + " times");
}

void describe(Fields& f, SmoothPiece& c) {
  piece_field(f, c.piece);
  f.whole("times", c.times, 1, kMostSmoothing);
}

Result<Delta> SmoothPiece::run(World& world, uint32_t generation, const Progress* progress) const {
  return remake_piece(
      world, piece, generation,
      [&](const Mesh& mesh, const HeededFaces& heeded, const Progress* working) {
        return smooth(mesh, times, heeded.kept, working);
      },
      progress);
}

std::string TurnShells::words(const std::string& piece_name) const {
  return "Turn inner shells of " + piece_name;
}

void describe(Fields& f, TurnShells& c) { piece_field(f, c.piece); }

Result<Delta> TurnShells::run(World& world, uint32_t generation, const Progress* progress) const {
  return remake_piece(
      world, piece, generation,
      [](const Mesh& mesh, const HeededFaces&, const Progress* working) {
        return turn_shells(mesh, working);
      },
      progress);
}

}  // namespace kerf
