#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/document/command.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// The command with the id of the piece that it names made whole where a journal gave the number of the body
// alone: the id of the body that has this number in `world`. A command that names no piece, or one of a body
// that is not there, is returned as it is.
Command with_whole_id(const World& world, Command command);

// Applies an AddMesh, MovePiece, HidePiece, DeletePiece or RenamePiece; the delta is empty where there is
// nothing to do. A piece that does not stand alone in its body is detached from it first. A body that the
// command makes gets this generation (see BodyId). On failure the world is as it was.
Result<Delta> run_at_once(World& world, const Command& command, uint32_t generation,
                          const Progress* progress = nullptr);

}  // namespace kerf
