#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

class Fields;

// Commands that change a piece as a whole. But for DuplicatePiece, the piece becomes a body of its own first,
// where it is not one already (see edit_piece). run() does the command (see HappensAtOnce).

// Puts a piece at a placement.
struct MovePiece {
  PieceId piece;
  Placement to;

  static constexpr const char* kName = "move-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, MovePiece& c);

// Adds a copy of a piece as a body of its own, at a placement. The piece itself is not changed.
struct DuplicatePiece {
  PieceId piece;
  Placement to;

  static constexpr const char* kName = "duplicate-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, DuplicatePiece& c);

// Hides a piece, or shows it again.
struct HidePiece {
  PieceId piece;
  bool hidden = true;

  static constexpr const char* kName = "hide-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, HidePiece& c);

// Removes a piece from the world.
struct DeletePiece {
  PieceId piece;

  static constexpr const char* kName = "delete-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, DeletePiece& c);

// Gives a piece a name. Once it is a body of its own, pieces that come off it are named after it.
struct RenamePiece {
  PieceId piece;
  std::string name;

  static constexpr const char* kName = "rename-piece";
  std::string words(const std::string& piece_name) const;
  size_t weight() const { return name.size(); }
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, RenamePiece& c);

// Pins a piece where it is, so that nothing moves it while bodies move, or lets it move again.
struct PinPiece {
  PieceId piece;
  bool pinned = true;

  static constexpr const char* kName = "pin-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, PinPiece& c);

// Says what the sheet of a piece is: its thickness, its density and the constants of its material. Its faces
// keep their energy.
struct SetSheetProperties {
  PieceId piece;
  Sheet sheet;

  static constexpr const char* kName = "set-sheet-properties";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SetSheetProperties& c);

// Says whether the faces of a piece enclose a volume, which strokes with a smooth rim close again by walls
// and which then has the mass of a solid, or are a sheet.
struct SetSolid {
  PieceId piece;
  bool solid = true;

  static constexpr const char* kName = "set-solid";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SetSolid& c);

}  // namespace kerf
