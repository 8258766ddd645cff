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
#include "core/tree/simd.h"
#include "core/tree/swept_cylinder.h"
#include "core/tree/tree_store.h"

namespace kerf {

// A point where a ray meets a face, `length` metres from the ray's origin.
struct RayHit {
  FaceId face;
  double length = 0;
  friend bool operator==(const RayHit&, const RayHit&) = default;
};

// What a query looked at: boxes, and faces one by one.
struct QueryCounts {
  size_t boxes = 0;
  size_t faces = 0;
};

// A tree of axis-aligned bounding boxes over the live faces of a mesh: nodes of up to eight children (I.
// Wald, C. Benthin, S. Boulos: Getting rid of packets, 2008) over blocks of up to four faces. It is built
// once and never rebuilt: the parts of a split face take its place in its block, which parts when it is full;
// a removed face goes and the boxes above it shrink. An edit costs what the bite costs.
//
// Boxes and corners are floats of (x - origin) times a power of two, boxes rounded outward, so they only
// cull; the doubles of the mesh decide. What the mesh has at a face may change only with replace, remove and
// refit.
//
// All answers are the same to the bit and in the same order for every Simd.
class AabbTree {
 public:
  AabbTree() = default;

  // The surface area heuristic, top-down. O(n log n).
  explicit AabbTree(const Mesh& mesh, Simd simd = best_simd());

  // The same tree, or that it was stopped. `progress` may be null.
  static Result<AabbTree> build(const Mesh& mesh, const Progress* progress);

  // Appends every face that meets the closed volume, none missed, each once, in an order that depends on the
  // tree alone. Remembers in every box that the volume meets that the beam was there.
  QueryCounts touched(const Mesh& mesh, const SweptCylinder& beam, std::vector<FaceId>& out);

  // Appends all faces that the ray crosses at lengths within the range, nearest first, each surface once:
  // where the ray goes through an edge or a corner, one of the faces there is chosen by rule. Faces edge-on
  // are not crossed. The direction is a unit vector.
  void crossings(const Mesh& mesh, const Pose& ray, Interval range, std::vector<RayHit>& out) const;

  // The same for several rays, each with a list of its own in `out`. Rays that run side by side, of equal
  // direction, cost about as much as one where they are nearer to one another than a face is wide.
  void crossings(const Mesh& mesh, std::span<const Pose> rays, Interval range,
                 std::span<std::vector<RayHit>> out) const;

  // The first of the crossings of the ray.
  std::optional<RayHit> nearest(const Mesh& mesh, const Pose& ray, Interval range) const;

  // The leaves of `gone` make way for leaves of `born`, which lie within the box around them. A face may
  // stand on both sides. Several replacements may be told late, in their order. The boxes above remember the
  // beam; the new leaves have not met it yet. Neither list is empty.
  void replace(const Mesh& mesh, std::span<const FaceId> gone, std::span<const FaceId> born);
  // The same as all of them in their order, sooner done.
  void replace(const Mesh& mesh, std::span<const Replacement> all);

  // Takes the leaf of a face away.
  void remove(FaceId f);

  // The corners of these faces have moved: their leaves are fitted anew, and boxes above grow where they
  // must. They stay marked where the beam was.
  void refit(const Mesh& mesh, std::span<const FaceId> faces);

  // A box of the tree for those who look at it, metres, in the frame of the mesh.
  struct Box {
    Vec3 min, max;
    int depth = 0;      // 0 at the root
    bool leaf = false;  // the box of one face
    bool hit = false;   // the beam is or was in it
  };
  // Visits all boxes, parents before children. A block of one face is that face's box.
  void for_each_box(const std::function<void(const Box&)>& visit) const;

  size_t leaf_count() const { return leaf_count_; }
  // How many boxes for_each_box visits. O(1).
  size_t box_count() const;
  // The bounds of all leaves, a little outward; zero for an empty tree.
  Box bounds() const;

  // Memory that the tree holds.
  size_t bytes() const { return store_.bytes(); }

  // What the tree was before a command (see ChangeOf): boxes, and where the beam was. To be used together
  // with the change of the mesh.
  class Change;

 private:
  friend class ChangeOfParts<AabbTree>;
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
