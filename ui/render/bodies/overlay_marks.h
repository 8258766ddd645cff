#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/mesh.h"
#include "core/physics/physics.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// The state of a world's physics, drawn as an overlay.
struct BodyMarks {
  // A contact of two bodies, or of a body and the ground; in the world.
  struct ContactMark {
    Vec3 at{0};
    Vec3 normal{0};       // unit, towards the first body
    double distance = 0;  // m, minus the skins
    double share = 0;     // of the largest impulse, 0 to 1
  };
  // The points and chords of a body, in the frame of the body.
  struct ColliderMarks {
    BodyId body;
    std::vector<Vec3> points;
    std::vector<std::pair<Vec3, Vec3>> chords;
  };
  struct CentreMark {
    enum class State { kAwake, kAsleep, kPinned };
    Vec3 centre{0};     // m, of mass, in the world
    double radius = 0;  // m, of a disc with the area of the body
    State state = State::kAwake;
  };

  struct JointMark {
    Joint::Kind kind = Joint::Kind::kWeld;
    Vec3 anchor{0};  // m, in the world
    Vec3 axis{0};    // unit, in the world; undefined for a weld
  };

  std::vector<ContactMark> contacts;
  std::vector<ColliderMarks> colliders;
  std::vector<CentreMark> centres;
  std::vector<JointMark> joints;
};

// Gathers the marks that the switches enable: contacts and colliders as of the last tick in which bodies
// moved. Null if none is enabled. Linear in the result.
std::shared_ptr<const BodyMarks> gather_body_marks(const World& world, const Physics& physics,
                                                   const ShowOptions& show);

// Gathers the marks of a world in which no time has passed: contacts are those that the next tick would
// find with all bodies awake. Copies the world.
std::shared_ptr<const BodyMarks> body_marks_ahead(const World& world, const ShowOptions& show);

// The effect of a stage of a cut, drawn as an overlay. All positions are in the frames of the bodies [m].
struct StageMarks {
  enum class Kind {
    kSwept,    // volume swept by the beam
    kHit,      // face touched by the beam
    kAdded,    // face created by a split
    kRemoved,  // removed face
    // Boxes that a tree query visited; see TouchedWalk::Outcome.
    kEntered,
    kCulled,
    kMissed,
    kTouched,
    kLast,  // last visited box
  };
  struct Fill {
    Triangle corners;
    uint32_t piece = 0;  // moves with this piece if it is displaced
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
  // The sets of a separation, drawn in two colours: the separated pieces, and those they were attached to.
  std::vector<PieceId> came_off, stayed;
};

}  // namespace kerf
