#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"
#include "core/mesh/replacement.h"
#include "core/tree/swept_cylinder.h"
#include "core/tree/tree_store.h"

namespace kerf {

// A point where a ray meets a face, `length` metres from the ray's origin.
struct RayHit {
  FaceId face;
  double length = 0;
  friend bool operator==(const RayHit&, const RayHit&) = default;
};

// The numbers of boxes and of faces that a query tested.
struct QueryCounts {
  size_t boxes = 0;
  size_t faces = 0;
};

// A bounding volume hierarchy of axis-aligned boxes over the live faces of a mesh: nodes of up to eight
// children (I. Wald, C. Benthin, S. Boulos: Getting rid of packets, 2008) over blocks of up to four faces. It
// is built once and never rebuilt. The parts of a split face take its place in its block, and a full block is
// split in two; a removed face leaves its block, and the boxes above shrink. The cost of an edit depends on
// the number of faces edited and on the depth of the tree, not on the size of the mesh.
//
// Boxes and corners are stored as floats of (x - origin) times a power of two, and boxes are rounded outward.
// They only cull; the decision is made with the mesh's doubles. Every query and edit takes the mesh that the
// tree was built over, and every edit of that mesh must be followed by replace, remove or refit.
//
// All results are the same to the bit and in the same order for every Simd.
class AabbTree {
 public:
  AabbTree() = default;

  // Builds the tree top-down with the surface area heuristic; see build_tree. O(n log n).
  explicit AabbTree(const Mesh& mesh, Simd simd = best_simd());

  // Builds the same tree, or fails with cancelled() when stopped. `progress` may be null.
  static Result<AabbTree> build(const Mesh& mesh, const Progress* progress);

  // Appends every face that meets the closed volume exactly once, in an order that depends on the tree alone,
  // and marks every box that the volume meets as hit. The volume is in the frame of the mesh.
  QueryCounts touched(const Mesh& mesh, const SweptCylinder& beam, std::vector<FaceId>& out);

  // Appends all faces that the ray crosses at lengths within the closed range, nearest first. Each surface is
  // crossed once: where the ray goes through an edge or a corner, a fixed rule chooses one of the faces there
  // (see ShearedRay). Faces parallel to the ray are not crossed. Precondition: the direction is a unit
  // vector.
  void crossings(const Mesh& mesh, const Pose& ray, Interval range, std::vector<RayHit>& out) const;

  // Finds the crossings of several rays; out[i] receives those of rays[i]. Up to four rays of equal direction
  // cost about as much as one if the distance between them is smaller than a face. Precondition: `out` has as
  // many elements as `rays`.
  void crossings(const Mesh& mesh, std::span<const Pose> rays, Interval range,
                 std::span<std::vector<RayHit>> out) const;

  // The first of the crossings, or nothing if there is none. Same precondition.
  std::optional<RayHit> nearest(const Mesh& mesh, const Pose& ray, Interval range) const;

  // Replaces the leaves of the faces `gone` by leaves of the faces `born`; a face may be in both lists. Boxes
  // above keep their hit marks, new leaves have none. Replacements may be reported late, after the mesh was
  // edited further, as long as their order is kept. Preconditions: neither list is empty, all faces of `gone`
  // are in the tree, and `born` lies within the bounding box of `gone`.
  void replace(const Mesh& mesh, std::span<const FaceId> gone, std::span<const FaceId> born);
  // Makes all replacements in their order; faster than one call for each.
  void replace(const Mesh& mesh, std::span<const Replacement> all);

  // Adds leaves for faces wherever they lie, each where the boxes above grow least, and enlarges these boxes.
  // Precondition: the faces are not in the tree, and it is not empty. O(depth) for each.
  void add(const Mesh& mesh, std::span<const FaceId> faces);

  // Removes the leaf of a face. Precondition: the face is in the tree.
  void remove(FaceId f);

  // Fits the leaves of faces whose corners have moved and enlarges the boxes above where necessary. Hit marks
  // stay. Precondition: the faces are in the tree.
  void refit(const Mesh& mesh, std::span<const FaceId> faces);

  // A box of the tree, for display, in metres in the frame of the mesh.
  struct Box {
    Vec3 min, max;
    int depth = 0;      // 0 at the root
    bool leaf = false;  // the box of one face
    bool hit = false;   // the beam is or was inside it
  };
  // Visits all boxes, parents before children. A block of one face is visited once, as the box of that face.
  // O(n).
  void for_each_box(const std::function<void(const Box&)>& visit) const;

  size_t leaf_count() const { return leaf_count_; }
  // The number of boxes that for_each_box visits. O(1).
  size_t box_count() const;
  // A box that holds all leaves, slightly enlarged by rounding; zero for an empty tree.
  Box bounds() const;

  // Memory allocated, in bytes.
  size_t bytes() const { return store_.bytes(); }

  // The boxes and hit marks before a command; see ChangeOf. Precondition: it is exchanged and restored
  // together with the change of the mesh.
  class Change;

 private:
  friend class ChangeOfParts<AabbTree>;
  friend class TouchedTrace;
  template <typename Self>
  static auto parts(Self& self) {
    return std::tie(self.store_, self.leaf_count_);
  }

  Box box_of(const FloatBox& box, int depth, bool leaf, bool hit) const;

  TreeStore store_;
  size_t leaf_count_ = 0;
  const Walks* walks_ = &walks_for(best_simd());
};

class AabbTree::Change : public ChangeOfParts<AabbTree> {};

}  // namespace kerf
