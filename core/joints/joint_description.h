#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/world/world.h"

namespace kerf {

// A joint to be made between two parts of one mesh. The first part turns about the axis relative to the
// second one, by the right-hand rule.
struct JointDescription {
  Joint::Kind kind = Joint::Kind::kWeld;
  // Names as in the mesh file (see MeshPart); an empty name stands for all faces of the mesh.
  std::array<std::string, 2> parts;
  Vec3 anchor{0};                           // m, in the frame of the body
  Vec3 axis{0, 1, 0};                       // of a hinge or a hub; not zero
  std::optional<Interval> limits;           // of a hinge; degrees, from -180 to 180 and containing 0
  std::optional<std::array<Vec3, 2>> near;  // m, a point of each part; default: the anchor
  // Faces of a part carry the joint up to this distance from its point [m]; default: all faces of the part
  // that are connected with the nearest one.
  std::optional<double> radius;
};

// Creates a joint for a loaded body with the id `id`, all of whose faces are as loaded. Fails if the mesh has
// no such part, if none of its faces is within the radius, if a face would carry both sides, or if the
// distance of the anchor from the mesh exceeds a hundred times its size. O(faces of the body).
Result<Joint> make_joint(const JointDescription& joint, BodyId id, const Body& body);

}  // namespace kerf
