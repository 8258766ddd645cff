#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/cut/cut_step.h"
#include "core/laser/laser.h"
#include "core/world/world.h"

namespace kerf {

// A plane in world coordinates: the points x with dot(normal, x) = distance.
struct KnifePlane {
  Vec3 normal{0, 1, 0};  // finite and not zero, of any length
  double distance = 0;   // m, times the length of the normal
  friend bool operator==(const KnifePlane&, const KnifePlane&) = default;
};

// Pegs that join the two sides of a cut of a solid: cylinders on the side that the normal of the plane points
// away from, and holes for them in the other side.
struct Pegs {
  static constexpr int kMaxCount = 1000;
  int count = 0;         // in the section of a body, at most; 0: none
  double diameter = 0;   // m, > 0
  double depth = 0;      // m, > 0, from the plane
  double tolerance = 0;  // m, the gap around a peg and at its end
  friend bool operator==(const Pegs&, const Pegs&) = default;
};

// Cuts bodies along a plane by a cut of no width. Faces are split exactly where the plane crosses them, and
// nothing is refined or removed. Faces on different sides of the plane are then disconnected, so that each
// side becomes pieces of its own, and both sides of a solid body are closed by the same section of walls.
// Works on open and non-manifold meshes; a solid body with an open section is left open and listed in the
// delta.
//
// A vertex whose distance cannot be distinguished from zero in double precision (see kOnKnife) lies on the
// plane; it is not moved. A face in the plane belongs to the side that it faces away from, as in a solid. A
// crossed edge gets one vertex, whose position depends only on the ends of the edge, so that the pieces fit
// to the bit.
//
// Pegs are prisms of kPegSides sides, spread over the section with half a radius of material around them and
// their holes. Fewer than `count` are made where there is no room; SolidChange counts those made.
//
// Fails with cancelled() if `progress` stops it, or if a body would exceed `max_faces`; the world is
// unchanged then. Preconditions: the bodies are contained, and is_settled(world). O(faces of the bodies).
Result<StepResult> cut_with_plane(World& world, const KnifePlane& plane, std::span<const BodyId> bodies,
                                  size_t max_faces = CutSettings::kMaxFaces,
                                  const Progress* progress = nullptr, const Pegs& pegs = {});

// The surface that a beam without radius sweeps, in world coordinates: between two poses the origin moves on
// the straight line, and the direction along the shorter arc.
struct KnifePath {
  std::vector<Pose> poses;  // at least two; directions are unit vectors and no two in a row are opposite
  Interval range;           // m along the beam
};

// Returns the index of the first pose whose strip from the pose before is not planar, i.e. at which the beam
// turns out of the plane; nullopt if all strips are planar. O(poses).
std::optional<size_t> first_pose_off_plane(const KnifePath& path);

// Cuts bodies along the surface of a path by a cut of no width. Faces that it meets are split along the
// planes of its strips, which may continue across the rest of such a face. Parts that the surface passes
// right through become pieces, and those of solids are closed by walls in the surface. The rest keeps the new
// edges and stays connected; the delta then lists the body in left_open.
//
// Fails like cut_with_plane(), and with bad input if a strip between two poses is not planar (see
// first_pose_off_plane()). Same preconditions. O(faces + poses * log(faces) + faces met).
Result<StepResult> cut_with_path(World& world, const KnifePath& path, std::span<const BodyId> bodies,
                                 size_t max_faces = CutSettings::kMaxFaces,
                                 const Progress* progress = nullptr);

}  // namespace kerf
