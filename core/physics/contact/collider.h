#pragma once

#include <vector>

#include "core/mesh/mesh.h"
#include "core/physics/contact/bounding_volumes.h"

namespace kerf {

// Contact features of a body besides its faces: points and straight chords of its sheet, in its frame (m).
struct Collider {
  struct Point {
    Vec3 at{0};
    Vec3 normal{0};   // unit, of the faces around it; zero if they cancel
    Vec3 outward{0};  // on a rim: unit, in the plane of the sheet and away from it; otherwise zero
  };
  // A straight piece of a rim or a crease.
  struct Chord {
    Vec3 from{0}, to{0};
  };

  std::vector<Point> points;
  std::vector<Chord> chords;
  // Used only to detect that the body gets through another one: further points, numbered after `points`,
  // and all chords; equal to `chords` if these are all.
  std::vector<Point> guards;
  std::vector<Chord> fine_chords;
  // Clusters of the items of each list.
  Clusters point_clusters, chord_clusters, guard_clusters, fine_chord_clusters;
  Box bounds;       // of all vertices
  Occupancy space;  // cells of faces and chords
  // Points that can touch a plane: all vertices except those amid flat faces.
  std::vector<Vec3> corners;
};

// Limits of the number of features.
struct ColliderSettings {
  size_t max_points = 96;
  size_t max_chords = 192;
  size_t max_guards = 512, max_fine_chords = 2048;
  // Max distance of a chord from its rim [m]; larger if there would be too many chords.
  double chord_error = 0.001;
};

// Makes the collider of all live faces of a mesh. Points: the ends of chords, extreme vertices, then those
// of rims and all others as far apart as possible (T. Gonzalez: Clustering to minimize the maximum
// intercluster distance, 1985). Chords: rims and creases of more than 40 degrees as polygons (D. Douglas,
// T. Peucker, 1973). Guards: the other vertices, or some of them, evenly over their order. Deterministic.
// About O(faces log faces).
Collider make_collider(const Mesh& mesh, const ColliderSettings& settings = {});

}  // namespace kerf
