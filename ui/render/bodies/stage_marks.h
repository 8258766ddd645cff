#pragma once

#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/mesh.h"

namespace kerf {

// What a stage of a cut did, to be drawn over the picture. All places are in the frames of the bodies, in
// metres.
struct StageMarks {
  enum class Kind {
    kSwept,    // the volume that the beam sweeps
    kHit,      // a face that the beam touches
    kBorn,     // a face that a split made
    kRemoved,  // a face that was removed
    // Boxes that a query of the tree visited; see TouchedWalk::Outcome.
    kEntered,
    kCulled,
    kMissed,
    kTouched,
    kLast,  // the one that was visited last
  };
  struct Fill {
    Triangle corners;
    uint32_t piece = 0;  // moves with this piece, if it is drawn elsewhere
    Kind kind = Kind::kHit;
  };
  struct Line {
    Vec3 from{0}, to{0};
    uint32_t piece = 0;
    Kind kind = Kind::kHit;
  };
  struct OfBody {
    BodyId body;
    std::vector<Fill> fills;
    std::vector<Line> lines;
  };
  std::vector<OfBody> bodies;
  // The sets of a separation, which are drawn in two colours: the pieces that came off, and those that they
  // came off.
  std::vector<PieceId> came_off, stayed;
};

}  // namespace kerf
