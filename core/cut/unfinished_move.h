#pragma once

#include <cstddef>
#include <vector>

#include "core/base/ids.h"

namespace kerf {

// The state of a move of the beam that a step left unfinished, so that a later step can continue it: the
// body, the stage, and the faces to be processed there. A default-constructed one is at the start of a move.
// It is valid only for the world as the step left it; any other change of the world invalidates it, and what
// the move has cut stays cut.
struct UnfinishedMove {
  enum class Stage { kFind, kRefine, kFindAgain, kRemove, kSeparate };

  size_t bodies = 0;             // bodies that the move has completed
  Stage stage = Stage::kFind;    // of the next body
  std::vector<FaceId> hit;       // faces that the beam touches, each once
  std::vector<FaceId> to_split;  // faces and parts of faces still to be refined; the next one is last
  std::vector<FaceId> beside;    // neighbours of faces that were removed; only where heat is left beside them
  size_t removed = 0;            // number of faces of `hit` that are processed
  bool has_split = false;        // a face was split, so that `hit` has to be found again
};

}  // namespace kerf
