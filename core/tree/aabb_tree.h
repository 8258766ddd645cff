#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/mesh.h"
#include "core/tree/swept_cylinder.h"

namespace kerf {

// A point where a ray meets a face, `length` metres from the ray's origin.
struct RayHit {
  FaceId face;
  double length = 0;
  friend bool operator==(const RayHit&, const RayHit&) = default;
};

// What a query looked at.
struct QueryCounts {
  size_t boxes = 0;
  size_t faces = 0;
};

// A tree of axis-aligned bounding boxes over the live faces of a mesh, one face a leaf slot. It is built once
// and never rebuilt: a face that is split becomes a node over its parts, whose boxes lie within its own; a
// removed face goes and the boxes above it shrink. An edit costs what the bite costs.
//
// Boxes are floats of (x - origin) times a power of two, rounded outward, so they only cull; the doubles of
// the mesh decide. Positions of the mesh must not change behind the tree's back.
class AabbTree {
 public:
  AabbTree() = default;

  // Top-down, halving along the longest side of the centroids' box. O(n log n).
  explicit AabbTree(const Mesh& mesh);

  // Appends every face that meets the closed volume, none missed, each once, in an order that depends on the
  // tree alone. Remembers in every box that the volume meets that the beam was there.
  QueryCounts touched(const Mesh& mesh, const SweptCylinder& beam, std::vector<FaceId>& out);

  // All faces that the ray crosses at lengths within the range, nearest first, each surface once: where the
  // ray goes through an edge or a corner, one of the faces there is chosen by rule. Faces edge-on are not
  // crossed.
  void crossings(const Mesh& mesh, const Pose& ray, Interval range, std::vector<RayHit>& out) const;

  // The leaves of `gone` (one face, or all faces below one node) make way for leaves of `born`, which lie
  // within theirs. A face may stand on both sides. Several replacements may be told late, in their order. The
  // node remembers the beam; the new leaves have not met it yet.
  void replace(const Mesh& mesh, std::span<const FaceId> gone, std::span<const FaceId> born);

  // Corners of these faces have moved: their leaves are fitted anew and the boxes above grow with them.
  void refit(const Mesh& mesh, std::span<const FaceId> faces);

  // Takes the leaf of a face away.
  void remove(FaceId f);

  // A box of the tree for those who look at it, metres, in the frame of the mesh.
  struct Box {
    Vec3 min, max;
    int depth = 0;  // 0 at the root
    bool leaf = false;
    bool hit = false;  // the beam is or was in it
  };
  // Visits all boxes, parents before children.
  void for_each_box(const std::function<void(const Box&)>& visit) const;

  size_t leaf_count() const { return leaf_count_; }
  size_t box_count() const { return leaf_count_ == 0 ? 0 : 2 * leaf_count_ - 1; }
  // The bounds of all leaves, a little outward; zero for an empty tree.
  Box bounds() const;

 private:
  static constexpr uint32_t kNone = 0xffffffffu;
  struct Node {
    std::array<float, 3> low, high;  // scaled; see scaled_box
    uint32_t parent = kNone;
    std::array<uint32_t, 2> child{kNone, kNone};  // a leaf: {face, kNone}
    bool hit = false;
    bool leaf() const { return child[1] == kNone; }
  };
  struct Span;

  void set_frame(const Mesh& mesh);
  void fit_leaf(const Mesh& mesh, Node& node) const;
  void fit_parent(Node& node) const;
  uint32_t new_node();
  void free_node(uint32_t n);
  uint32_t build(const Mesh& mesh, std::vector<Span>& spans, size_t begin, size_t end, uint32_t parent);
  uint32_t graft(const Mesh& mesh, std::span<const FaceId> faces, uint32_t parent, uint32_t at);
  void shrink_from(uint32_t n);
  void grow_from(uint32_t n);
  Box box_of(const Node& node, int depth) const;
  void set_leaf(FaceId f, uint32_t node);

  Vec3 origin_{0};
  double scale_ = 1;  // a power of two; boxes are (x - origin) * scale, about within [-1, 1]
  uint32_t root_ = kNone;
  std::vector<Node> nodes_;
  std::vector<uint32_t> free_;
  std::vector<uint32_t> leaf_of_;  // one a face slot
  size_t leaf_count_ = 0;
};

}  // namespace kerf
