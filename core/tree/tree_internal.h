#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/refinement.h"
#include "core/tree/swept_cylinder.h"
#include "core/tree/tree_store.h"
#include "core/tree/walks.h"

namespace kerf {

// In-place edits of a tree. They access only the changed records and their ancestors. Preconditions: see
// AabbTree.

// Applies replacements in order; the leaves that one adds go to the block of its first removed face (see
// BlockFiller).
void replace_faces(TreeStore& tree, const Mesh& mesh, std::span<const Replacement> all);

// Adds leaves, each to the block found by descending into the child whose box grows least in area: from the
// root, or from the lowest node around both the face and the one before. Preconditions: the faces are not in
// the tree, and the tree is not empty.
void add_faces(TreeStore& tree, const Mesh& mesh, std::span<const FaceId> faces);

// Removes a leaf, and each block or node that becomes empty. Replaces a node with a single child by that
// child. Shrinks the ancestors' boxes up to the first one that does not change.
void remove_face(TreeStore& tree, FaceId f);

// Updates the leaf of a face whose corners have moved and enlarges the boxes above it.
void refit_face(TreeStore& tree, const Mesh& mesh, FaceId f);

// The lists of one traversal, on the caller's stack while they are short. Construction and destruction are
// cheap, because a ray that misses everything takes only one or two hundred instructions.
class WalkScratch : public WalkLists {
 public:
  WalkScratch()
      : WalkLists{
            {nodes_, 0, kShort}, {blocks_, 0, kShort}, {faces_, 0, kShort}, {boxes_, 0, kShort}, lengthen} {}
  WalkScratch(const WalkScratch&) = delete;
  WalkScratch& operator=(const WalkScratch&) = delete;

  // Faces listed by the traversal, as face_word().
  std::span<const uintptr_t> found() const { return {faces.items, faces.count}; }
  // Faces whose boxes passed the test, as face_word().
  std::span<const uintptr_t> met() const { return {boxes.items, boxes.count}; }

 private:
  using Words = std::vector<uintptr_t>;
  static void lengthen(WalkLists& lists, WordList& list) {
    auto& self = static_cast<WalkScratch&>(lists);
    if (!self.long_lists_) self.long_lists_ = std::make_unique<std::vector<Words>>();
    Words& words = self.long_lists_->emplace_back(list.items, list.items + list.count);
    list.capacity *= 2;
    words.resize(list.capacity);
    list.items = words.data();
  }

  static constexpr uint32_t kShort = 96;
  std::unique_ptr<std::vector<Words>> long_lists_;
  uintptr_t nodes_[kShort], blocks_[kShort], faces_[kShort], boxes_[kShort];
};

// A watertight ray-triangle test. Axes are permuted and sheared so that the ray becomes the z axis (S. Woop,
// C. Benthin, I. Wald: Watertight ray/triangle intersection, 2013). A corner has the same projection in all
// of its faces, the side of an edge on which the ray passes is decided exactly, and ties are broken by
// symbolic perturbation (H. Edelsbrunner, E. Mücke: Simulation of simplicity, 1990). A ray from outside
// therefore crosses a closed surface an even number of times, even through edges and corners.
class ShearedRay {
 public:
  ShearedRay() = default;
  // Precondition: the direction is a unit vector.
  explicit ShearedRay(const Pose& ray);
  // Returns the sheared ray of a parallel ray. Precondition: its direction equals that of this ray.
  ShearedRay beside(const Pose& ray) const {
    ShearedRay other = *this;
    other.origin_ = ray.origin;
    return other;
  }

  // Returns the signed length along the ray [m] at which its line crosses the triangle; nullopt if the line
  // misses the triangle or is parallel to it. The orientation of the triangle does not matter.
  std::optional<double> cross(const Triangle& t) const;

 private:
  Vec3 origin_{0};
  Vec2 shear_{0};
  double per_z_ = 1;
  int x_ = 0, y_ = 1, z_ = 2;
};

// Returns the exact sign (1, 0 or -1) of a.x * b.y - a.y * b.x. Precondition: all coordinates are finite.
int side_of(Vec2 a, Vec2 b);

// Returns an oriented box, in the frame of the tree, around the part of a swept volume within the tree,
// widened by all rounding errors so that no face that touches the volume is culled. Axis 0 is the direction
// of the beam, 1 that of its motion and 2 the one across both. The volume is in the frame of the mesh.
// Precondition: the tree has a root.
SlabQuery beam_slab(const TreeStore& tree, const SweptCylinder& beam);

}  // namespace kerf
