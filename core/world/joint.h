#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/ids.h"
#include "core/base/interval.h"
#include "core/base/vec3.h"

namespace kerf {

// One of the two sides of a joint: the faces that carry it, which are those parts of some base faces that are
// within a distance of a point. All are of one connected component.
struct JointSide {
  std::vector<uint32_t> faces;  // base faces of the body as loaded, ascending and not empty
  bool carries(FaceId loaded) const { return std::ranges::binary_search(faces, loaded.index); }
  uint32_t component = 0;                                   // of LoadedComponents
  Vec3 point{0};                                            // m, in the frame of the body
  double radius = std::numeric_limits<double>::infinity();  // m
  // Of a hinge: how near to its anchor the faces are that hold the pin, m. A beam that burns away what is
  // within this distance has cut the hinge, although it has passed between the faces of both sides.
  double reaches_pin = std::numeric_limits<double>::infinity();
};

// A joint holds two parts of a mesh together that are not connected, or not any more once they are cut apart.
//
// A joint holds as long as, of each side, faces are left, all of these hang together, and those of a hinge
// reach its pin. That follows from the faces alone (see held_joints in core/joints), so that undo and replay
// need no state of joints.
struct Joint {
  enum class Kind : uint8_t {
    kWeld,   // the parts are one
    kHinge,  // they turn about the axis, within limits
    kHub,    // they turn about the axis freely, as a wheel does
  };
  Kind kind = Kind::kWeld;
  BodyId body;  // as which the parts were loaded (Body::loaded_as)
  std::array<JointSide, 2> sides;
  Vec3 anchor{0};                  // m, a point of the axis, in the frame of the body
  Vec3 axis{0, 1, 0};              // unit, in the frame of the body
  std::optional<Interval> limits;  // rad, by which the second part turns about the axis against the first
};

// All joints of a world; they stay what they are while it is cut.
struct Joints {
  std::vector<Joint> all;

  // Both sides of each joint of a body.
  std::vector<const JointSide*> sides_of(BodyId body) const {
    std::vector<const JointSide*> sides;
    for (const Joint& joint : all) {
      if (joint.body == body) sides.insert(sides.end(), {&joint.sides[0], &joint.sides[1]});
    }
    return sides;
  }
};

}  // namespace kerf
