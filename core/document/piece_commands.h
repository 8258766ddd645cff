#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/document/command.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Does an AddMesh, MovePiece, HidePiece, DeletePiece or RenamePiece; an empty delta where there is nothing to
// do. On failure the world is as it was. A piece that does not stand alone in its body is detached from it
// first.
Result<Delta> run_at_once(World& world, const Command& command, const Progress* progress = nullptr);

}  // namespace kerf
