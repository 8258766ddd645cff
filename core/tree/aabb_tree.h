#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"
#include "core/mesh/refinement.h"
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
// is built once and then edited. The parts of a split face take its place in its block, and a full block is
// split in two; a removed face leaves its block, and the boxes above shrink. The cost of an edit depends on
// the number of faces edited and on the depth of the tree, not on the size of the mesh.
//
// Boxes and corners are stored as floats of (x - origin) times a power of two, and boxes are rounded outward.
// They only cull; the decision is made with the mesh's doubles. Every query and edit takes the mesh that the
// tree was built over, and every edit of that mesh must be followed by replace, remove, refit or update.
//
// The tree is a cache: which faces a query finds depends on the mesh alone, never on the shape of the tree,
// the history of its edits or the instruction set. Queries change nothing and may run on several threads.
class AabbTree {
 public:
  AabbTree() = default;

  // Builds the tree top-down with the surface area heuristic; see build_tree. O(n log n).
  explicit AabbTree(const Mesh& mesh, Simd simd = best_simd());

  // Builds the same tree, or fails with cancelled() when stopped. `progress` may be null.
  static Result<AabbTree> build(const Mesh& mesh, const Progress* progress);

  // Appends every face that meets the closed volume exactly once, in no particular order, and to `near`,
  // unless it is null, every face whose box may meet the volume. The volume is in the frame of the mesh.
  QueryCounts touched(const Mesh& mesh, const SweptCylinder& beam, std::vector<FaceId>& out,
                      std::vector<FaceId>* near = nullptr) const;

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

  // Replaces the leaves of the faces `gone` by leaves of the faces `born`; a face may be in both lists.
  // Replacements may be reported late, after the mesh was edited further, as long as their order is kept.
  // Preconditions: neither list is empty, all faces of `gone` are in the tree, and `born` lies within the
  // bounding box of `gone`, but for what enlarge_bounds() was told.
  void replace(const Mesh& mesh, std::span<const FaceId> gone, std::span<const FaceId> born);
  // Makes all replacements in their order; faster than one call for each.
  void replace(const Mesh& mesh, std::span<const Replacement> all);

  // Adds leaves for faces wherever they lie, each where the boxes above grow least, and enlarges these boxes.
  // Precondition: the faces are not in the tree, and it is not empty. O(depth) for each.
  void add(const Mesh& mesh, std::span<const FaceId> faces);

  // Removes the leaf of a face. Precondition: the face is in the tree.
  void remove(FaceId f);

  // Fits the leaves of faces whose corners have moved and enlarges the boxes above where necessary.
  // Precondition: the faces are in the tree.
  void refit(const Mesh& mesh, std::span<const FaceId> faces);

  // Makes the leaves of these faces agree with the mesh, whatever has happened to them: adds, refits and
  // removes. Faces may be listed more than once. O(depth) for each; rebuilds the tree where that is quicker.
  // Their boxes are those of a tree that was built over the mesh as it was first, and edited since.
  void update(const Mesh& mesh, std::vector<FaceId> faces);

  // A box of the tree, for display, in metres in the frame of the mesh.
  struct Box {
    Vec3 min, max;
    int depth = 0;      // 0 at the root
    bool leaf = false;  // the box of one face
    bool hit = false;   // it contains a face with FaceData::hit
  };
  // Visits all boxes, parents before children. A block of one face is visited once, as the box of that face.
  // O(n).
  void for_each_box(const Mesh& mesh, const std::function<void(const Box&)>& visit) const;

  size_t leaf_count() const { return leaf_count_; }
  // The number of boxes that for_each_box visits. O(1).
  size_t box_count() const;

  // The bounds of the corners of all faces, exact to the bit; zero for an empty tree. fit_bounds() makes them
  // so again after remove() and refit(), by a search that takes O(depth) where another face reaches as far.
  const Bounds& bounds() const { return bounds_; }
  void fit_bounds(const Mesh& mesh);
  // Includes a corner of a face that a later replace() adds.
  void enlarge_bounds(const Vec3& corner);

  // Rebuilds the tree in another shape now and then where choices are varied (see Shuffle); otherwise does
  // nothing.
  void vary(const Mesh& mesh);

  // Memory allocated, in bytes.
  size_t bytes() const { return store_.bytes(); }

 private:
  friend class TouchedTrace;

  Box box_of(const FloatBox& box, int depth, bool leaf, bool hit) const;
  void rebuild(const Mesh& mesh, TreeFrame frame);
  void set_bounds(const Bounds& bounds);
  void loosen_bounds(FaceId f);
  const FaceBlock& any_block() const;

  TreeStore store_;
  size_t leaf_count_ = 0;
  Bounds bounds_;
  unsigned loose_ =
      0;  // sides of the bounds that a removed or moved face may have reached, as in Bounds::side
  const Walks* walks_ = &walks_for(best_simd());
};

}  // namespace kerf
