#pragma once

#include <cstddef>
#include <vector>

#include "core/base/ids.h"

namespace kerf {

// Where a move of the beam was left, so that a later step goes on with it: in which body, with what of it,
// and the faces that are still to be looked at there. Made anew it stands at the beginning of a move. Between
// two steps it holds for the world as the first of them left it and for nothing else; whoever changes the
// world drops it, and what the move has cut until then stays cut.
struct UnfinishedMove {
  enum class Stage { kFind, kRefine, kFindAgain, kRemove, kSeparate };

  size_t bodies = 0;           // that the move is through
  Stage stage = Stage::kFind;  // of the next one
  std::vector<FaceId> hit;     // faces there that the beam touches, each once
  std::vector<FaceId>
      to_split;            // those and their parts, as far as they were not looked at; the next one last
  size_t removed = 0;      // of those that were hit, from the first
  bool has_split = false;  // so the faces that were hit are to be found again
};

}  // namespace kerf
