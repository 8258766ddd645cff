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

// A point of a face, and its squared distance from the query point [m^2].
struct PointOnFace {
  FaceId face;
  Vec3 point{0};
  double distance2 = 0;
};

// Numbers of boxes and faces tested by a query.
struct QueryCounts {
  size_t boxes = 0;
  size_t faces = 0;
};

// A bounding volume hierarchy of axis-aligned boxes over the live faces of a mesh: nodes of up to eight
// children (I. Wald, C. Benthin, S. Boulos: Getting rid of packets, 2008) over blocks of up to four faces. It
// is built once and then edited: the parts of a split face replace it in its block, an overflowing block is
// divided, and boxes above a removed face shrink. The cost of an edit depends on the number of faces edited
// and on the depth of the tree, not on the size of the mesh.
//
// Boxes and corners are stored as floats of (x - origin) times a power of two, and boxes are rounded outward.
// They only cull; exact tests use the mesh's doubles. Every query and edit takes the mesh over which the tree
// was built; every edit of that mesh must be followed by replace, add, remove, refit or update.
//
// The tree is a cache: query results depend on the mesh alone, never on the shape of the tree, the history of
// its edits or the instruction set. Queries are read-only and may run on several threads.
class AabbTree {
 public:
  AabbTree() = default;

  // Builds the tree top-down with the surface area heuristic; see build_tree. O(n log n).
  explicit AabbTree(const Mesh& mesh, Simd simd = selected_simd());

  // Builds the same tree; fails with cancelled() when stopped. `progress` may be null.
  static Result<AabbTree> build(const Mesh& mesh, const Progress* progress);

  // Appends to `out` each face that intersects the closed volume, once, in unspecified order. Unless `near`
  // is null, appends to it each face whose box may intersect the volume. The volume is in the frame of the
  // mesh.
  QueryCounts touched(const Mesh& mesh, const SweptCylinder& beam, std::vector<FaceId>& out,
                      std::vector<FaceId>* near = nullptr) const;

  // Appends all faces that the ray crosses at lengths within the closed range, nearest first. Each surface is
  // crossed once: at an edge or a corner, a fixed rule selects one of the adjacent faces (see ShearedRay).
  // Faces parallel to the ray are not crossed. Precondition: the direction is a unit vector.
  void crossings(const Mesh& mesh, const Pose& ray, Interval range, std::vector<RayHit>& out) const;

  // Likewise for several rays; appends the crossings of rays[i] to out[i]. Up to four rays of equal direction
  // cost about as much as one if they are closer together than the size of a face. Precondition: `out` has as
  // many elements as `rays`.
  void crossings(const Mesh& mesh, std::span<const Pose> rays, Interval range,
                 std::span<std::vector<RayHit>> out) const;

  // Returns the nearest crossing; nullopt on a miss. Precondition: the direction is a unit vector.
  std::optional<RayHit> nearest(const Mesh& mesh, const Pose& ray, Interval range) const;

  // Returns the point of the surface nearest to `at`, in a tie that on the face with the lowest id; nullopt
  // if there is no face. Visits boxes best-first (N. Roussopoulos, S. Kelley, F. Vincent: Nearest neighbor
  // queries, 1995). O(log n) near an evenly divided surface.
  std::optional<PointOnFace> nearest_point(const Mesh& mesh, const Vec3& at) const;
  // Appends, for each face within a distance [m], its nearest point; sorted by distance, then by face id.
  void points_within(const Mesh& mesh, const Vec3& at, double distance, std::vector<PointOnFace>& out) const;

  // Applies replacements in order: the leaves of some faces give way to those of others; a face may be in
  // both sets. May be called late, after further edits of the mesh, and is faster for many replacements than
  // for one. Preconditions: neither set is empty, the removed faces are in the tree, and the added ones lie
  // within the bounding box of the removed ones, extended by the corners passed to enlarge_bounds().
  void replace(const Mesh& mesh, std::span<const Replacement> all);

  // Adds leaves for faces at any position. Inserts each where the boxes on the way down grow least, and
  // enlarges these boxes. Preconditions: the faces are not in the tree, and the tree is not empty.
  // O(depth) per face.
  void add(const Mesh& mesh, std::span<const FaceId> faces);

  // Removes the leaf of a face. Precondition: the face is in the tree.
  void remove(FaceId f);

  // Updates the leaves of faces whose corners have moved, and enlarges the boxes above where necessary.
  // Precondition: the faces are in the tree.
  void refit(const Mesh& mesh, std::span<const FaceId> faces);

  // Adds, refits or removes the leaves of these faces so that the tree matches the mesh after any edits.
  // Faces may be repeated. O(depth) per face; rebuilds the tree if that is faster. The boxes equal those of a
  // tree that was built over the original mesh and edited since.
  void update(const Mesh& mesh, std::vector<FaceId> faces);

  // A box of the tree, for display, in metres in the frame of the mesh.
  struct Box {
    Vec3 min, max;
    int depth = 0;        // 0 at the root
    bool leaf = false;    // the box of one face
    bool hit = false;     // it contains a face with FaceData::hit
    bool edited = false;  // the box of a face that was split, or added since the tree was built
  };
  // Visits all boxes, parents before children. Visits a block of a single face once, as the box of that face.
  // O(n).
  void for_each_box(const Mesh& mesh, const std::function<void(const Box&)>& visit) const;

  // Returns the boxes from the root to a face, each within the one before; empty if the face is not in the
  // tree. O(depth).
  std::vector<Box> path_to(const Mesh& mesh, FaceId f) const;

  size_t leaf_count() const { return leaf_count_; }
  // Number of boxes that for_each_box visits. O(1).
  size_t box_count() const;

  // Bounds of the corners of all faces, exact to the bit; zero for an empty tree. After remove() and refit(),
  // fit_bounds() restores exactness, in O(depth) if another face reaches as far.
  const Bounds& bounds() const { return bounds_; }
  void fit_bounds(const Mesh& mesh);
  // Enlarges the bounds to include a corner of a face that a later replace() adds.
  void enlarge_bounds(const Vec3& corner);

  // Rebuilds the tree in another shape at random moments in tests that vary choices (see Shuffle); otherwise
  // a no-op.
  void vary(const Mesh& mesh);

  size_t bytes() const { return store_.bytes(); }

 private:
  friend class TouchedTrace;

  bool is_edited(const Mesh& mesh, FaceId f) const {
    return f.index >= built_slots_ || mesh.data(f).halvings > 0;
  }
  Box box_of(const FloatBox& box, int depth, bool leaf, bool hit) const;
  void rebuild(const Mesh& mesh, TreeFrame frame);
  void set_bounds(const Bounds& bounds);
  void loosen_bounds(FaceId f);
  // Follows a face that the tree still holds with its former corners.
  void move_bounds(const Mesh& mesh, FaceId f);
  const FaceBlock& any_block() const;

  TreeStore store_;
  size_t leaf_count_ = 0;
  uint32_t built_slots_ = 0;  // face slots of the mesh when the tree was built
  Bounds bounds_;
  unsigned loose_ =
      0;  // sides of the bounds that a removed or moved face may have reached, as in Bounds::side
  const Walks* walks_ = &walks_for(selected_simd());
};

}  // namespace kerf
