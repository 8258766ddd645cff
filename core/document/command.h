#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>

#include "core/cut/cut_step.h"
#include "core/world/placement.h"

namespace kerf {

// Everything that changes the world is one of these. A stroke is its beginning, poses in world coordinates
// and its end, never pixels, so the journal of commands gives the same world wherever it is replayed.
struct BeginStroke {
  CutSettings settings;
  Pose pose;  // unit direction
};
struct MoveStroke {
  Pose pose;  // unit direction, not opposite to the last one
};
struct EndStroke {};

// Takes the last stroke back and cuts it again with other settings.
struct Recut {
  CutSettings settings;
};

// A piece of the world: the slot of its body and its label there.
struct PieceRef {
  uint32_t body = 0;
  uint32_t label = 0;
  friend bool operator==(const PieceRef&, const PieceRef&) = default;
};

// Adds a body to the world from a mesh file.
struct AddMesh {
  std::filesystem::path file;
  std::string name;
};
// A piece that moves, or hides, for the first time becomes a body of its own (see detach).
struct MovePiece {
  PieceRef piece;
  Placement to;
};
struct HidePiece {
  PieceRef piece;
  bool hidden = true;
};
struct DeletePiece {
  PieceRef piece;
};
struct RenamePiece {
  PieceRef piece;
  std::string name;
};

// Back and forth in the history of the commands above; a stroke with all its moves is one step there.
struct Undo {};
struct Redo {};

using Command = std::variant<BeginStroke, MoveStroke, EndStroke, Recut, AddMesh, MovePiece, HidePiece,
                             DeletePiece, RenamePiece, Undo, Redo>;

}  // namespace kerf
