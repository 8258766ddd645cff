#pragma once

#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/files/soup.h"
#include "core/mesh/mesh.h"
#include "core/tree/swept_cylinder.h"
#include "tests/bench/peer.h"

namespace kerf::bench {

// A mesh to compare on, and the rays through it.
struct Subject {
  std::string name;
  Mesh mesh;
  Vec3 centre{0};
  double radius = 0;  // of the sphere around the centre that holds the mesh
  TriangleArrays arrays;

  double reach() const { return 4 * radius; }
  double steps_apart() const { return 0.004 * radius; }  // of the rays of a step
};

// A torus with knobs, of about this many faces.
Soup knobbly_torus(size_t faces);

// A tube along a trefoil knot.
struct TrefoilKnot {
  static constexpr double radius = 0.2;  // m

  Vec3 middle(double u) const;    // u: 0 .. 2 pi, once along the knot
  Soup soup(size_t faces) const;  // of about this many faces
};

Vec3 random_direction(Random& random);

// The bunny and its refinement of a million faces, where KERF_TEST_MESHES has them, and a mesh made here.
// With `tiny` only a small one made here.
std::vector<std::string> subject_names(bool tiny);
Subject make_subject(const std::string& name);

// Four parallel rays a step, all through the whole mesh: the beam follows a Lissajous curve and tilts slowly.
std::vector<Pose> sweep_rays(const Subject& subject, int steps);
// Chords of the sphere around the mesh.
std::vector<Pose> random_chords(const Subject& subject, int count);
// The slit that the edits cut: a narrow band of the sweep, `share` of the way of it.
Pose slit_pose(const Subject& subject, double share);

}  // namespace kerf::bench
