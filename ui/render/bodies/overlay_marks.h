#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/mesh.h"
#include "core/physics/physics.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// What the physics of a world works with, to be drawn over the picture.
struct BodyMarks {
  // Where two bodies, or a body and the ground, touch; in the world.
  struct ContactMark {
    Vec3 at{0};
    Vec3 normal{0};       // unit, towards the first body
    double distance = 0;  // m, less the skins
    double share = 0;     // of the largest impulse, from 0 to 1
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
    double radius = 0;  // m, of a sheet with the area of the body, laid out as a disc
    State state = State::kAwake;
  };

  struct JointMark {
    Joint::Kind kind = Joint::Kind::kWeld;
    Vec3 anchor{0};  // m, in the world
    Vec3 axis{0};    // unit, in the world; of a weld without meaning
  };

  std::vector<ContactMark> contacts;
  std::vector<ColliderMarks> colliders;
  std::vector<CentreMark> centres;
  std::vector<JointMark> joints;
};

// Gathers what the switches ask for: contacts and colliders as of the last tick in which bodies moved. Null
// if they ask for nothing. Linear in what is gathered.
std::shared_ptr<const BodyMarks> gather_body_marks(const World& world, const Physics& physics,
                                                   const ShowOptions& show);

// Gathers the marks of a world in which no time has passed: contacts are those that the next tick would find
// with all bodies awake. Copies the world.
std::shared_ptr<const BodyMarks> body_marks_ahead(const World& world, const ShowOptions& show);

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
