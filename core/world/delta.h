#pragma once

#include <cstdint>
#include <vector>

#include "core/base/ids.h"

namespace kerf {

// What a step changed in one body. Slots that only existed within the step are among `gone`.
struct BodyDelta {
  BodyId body;
  std::vector<FaceId> born;          // live slots whose corners are new, ascending
  std::vector<FaceId> gone;          // slots that are dead now, ascending
  std::vector<FaceId> relabelled;    // live slots whose piece changed, ascending
  std::vector<uint32_t> new_pieces;  // labels that this step made
};

// What a step changed. Renderer, statistics and everything else that follows the world live on this.
struct Delta {
  std::vector<BodyDelta> bodies;  // those that changed
  size_t removed_faces = 0;
  // Area that the bodies have lost (m^2): that of the removed faces, and what the faces around moved vertices
  // lost (or, negative, gained) by the moves. The removed area and the area that is left sum up to the area
  // before the step.
  double removed_area = 0;
  bool anew = false;  // bodies came, went, moved or hid: whoever follows must look at all of the world
  bool empty() const { return bodies.empty() && !anew; }

  // Makes this the delta of this step and the next one together.
  void append(Delta later);
};

}  // namespace kerf
