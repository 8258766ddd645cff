#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/world/world.h"

namespace kerf {

// A joint in a scene file, between two parts of one mesh, each named as the mesh file names it (see
// MeshPart). In the list "joints" of a body:
//
//   {"kind": "hinge", "parts": ["door", "frame"], "anchor": [..], "axis": [..], "limits": [0, 70],
//    "near": [[..], [..]], "radius": 0.08}
//
// Only "kind", "parts" and "anchor" are required, and "axis" for hinges and hubs. The first part turns about
// the axis against the second one, by the right-hand rule.
struct SceneJoint {
  Joint::Kind kind = Joint::Kind::kWeld;
  std::array<std::string, 2> parts;
  Vec3 anchor{0};                           // m, in the frame of the body
  Vec3 axis{0, 1, 0};                       // not zero; of a hinge or a hub
  std::optional<Interval> limits;           // degrees, from -180 to 180 and containing 0; of a hinge
  std::optional<std::array<Vec3, 2>> near;  // m, a point of each part; the anchor if they are not given
  // m, the distance from its point up to which the faces of a part carry the joint. If it is not given, all
  // faces of the part do that hang together with the nearest one.
  std::optional<double> radius;
};

// The joint for a body as loaded, which has the id `id`. Fails if the mesh names no such part, if none of its
// faces is within the radius, if a face would carry both sides, or if the anchor is more than a hundred times
// the size of the mesh away from it. O(faces of the body).
Result<Joint> make_joint(const SceneJoint& joint, BodyId id, const Body& body);

}  // namespace kerf
