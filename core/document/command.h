#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>

#include "core/base/ids.h"
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

// Adds a body to the world from a mesh file.
struct AddMesh {
  std::filesystem::path file;
  std::string name;
};
// A piece that is named by one of these becomes a body of its own first, where it is not one already (see
// detach); the command of the journal still names it by the body that it was part of.
struct MovePiece {
  PieceId piece;
  Placement to;
};
struct HidePiece {
  PieceId piece;
  bool hidden = true;
};
struct DeletePiece {
  PieceId piece;
};
struct RenamePiece {
  PieceId piece;
  std::string name;
};

// Back and forth in the history of the commands above; a stroke with all its moves is one step there.
struct Undo {};
struct Redo {};

using Command = std::variant<BeginStroke, MoveStroke, EndStroke, Recut, AddMesh, MovePiece, HidePiece,
                             DeletePiece, RenamePiece, Undo, Redo>;

}  // namespace kerf
