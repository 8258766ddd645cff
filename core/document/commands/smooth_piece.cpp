#include "core/document/commands/smooth_piece.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/commands/remake_piece.h"

namespace kerf {

std::string SmoothPiece::words() const {
  return "Smooth " + piece_words(piece) + (times == 1 ? "" : ", " + std::to_string(times) + " times");
}

void SmoothPiece::write(CommandWriter& line) const {
  line.piece(piece);
  line.whole_number("times", times);
}

Result<SmoothPiece> SmoothPiece::read(const CommandReader& line) {
  const auto piece = line.piece();
  if (!piece) return piece.error();
  const auto times = line.whole_number("times", 1, kMostSmoothing);
  if (!times) return times.error();
  return SmoothPiece{*piece, *times};
}

Result<Delta> SmoothPiece::run(World& world, uint32_t generation, const Progress* progress) const {
  return remake_piece(
      world, piece, generation,
      [&](const Mesh& mesh, const HeededFaces& heeded, const Progress* working) {
        return smooth(mesh, times, heeded.kept, working);
      },
      progress);
}

}  // namespace kerf
