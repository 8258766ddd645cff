#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/containers.h"
#include "core/laser/laser.h"
#include "core/mesh/mesh.h"
#include "core/tree/swept_cylinder.h"

namespace kerf {

// All that a beam has swept in a stroke, in the frame of one body: the union of the volumes of its moves, its
// parts. For each face near the region the parts that meet the face are listed, so that asking for a distance
// in a face costs what lies there, however long the stroke is. Answers are right for as long as the list of a
// face holds every part that meets it: whoever replaces faces has the new ones inherit.
class StrokeRegion {
 public:
  void add(const SweptCylinder& part) { parts_.push_back(part); }
  size_t parts() const { return parts_.size(); }
  const SweptCylinder& part(size_t i) const { return parts_[i]; }

  // Appends a part to the list of a face. Precondition: the parts of a face are told in ascending order.
  void record_near(FaceId f, uint32_t part);
  // Faces of the parents' area replaced them: each child is near every part that any parent is near, for it
  // may lie where only that parent lay. Slots are reused, so parents may be among the children. Precondition:
  // a parent is near the region. Constant time where the parents have one list, else linear in their lists.
  void inherit(std::span<const FaceId> children, std::span<const FaceId> parents);
  bool is_near(FaceId f) const { return list_of_.get(f.index) != 0; }

  // The signed distance of a point in or near the face from the boundary of the union: negative inside,
  // positive outside.
  double signed_distance(FaceId near, const Vec3& p) const;

  // Whether any part, with its radius reduced by `graze` metres, meets the triangle.
  bool reaches_into(FaceId near, const Triangle& t, double graze) const;

  // The point at which the boundary crosses the segment from a point inside to one outside.
  Vec3 crossing(FaceId near, const Vec3& inside, const Vec3& outside) const;

 private:
  // Parts that may hold a point of a segment which is halved again and again.
  class PartsOnSegment;

  static constexpr uint32_t kNone = 0xffffffffu;

  // A list is a chain of entries in one array, so that thousands of lists grow and go without a pause.
  struct Entry {
    uint32_t part;
    uint32_t next;  // index of an entry, or kNone
  };
  struct List {
    uint32_t first = kNone, last = kNone;
  };

  template <typename Visit>
  void for_each_part_near(FaceId f, Visit visit) const;
  void append(List& list, uint32_t part);
  uint32_t list_of_both(uint32_t a, uint32_t b);

  std::vector<SweptCylinder> parts_;
  std::vector<Entry> entries_;
  std::vector<List> lists_;
  PagedArray<uint32_t> list_of_;  // by face slot: the number of its list plus one, or 0
};

// The signed distance from the boundary of all that a stroke has swept, anywhere and not only near a face as
// in StrokeRegion. Moves that follow each other are halved again and again to a tree, so that a query asks
// those that are near alone.
class SweptDistance {
 public:
  // Precondition: part i of the region is what moves[i] sweeps, in one frame. O(n log n).
  SweptDistance(const StrokeRegion& region, std::span<const BeamMove> moves);

  // Negative inside, positive outside; the least of the distances from the parts, to the bit (m).
  double operator()(const Vec3& p) const;

 private:
  // Parts first .. end - 1. All their axes lie within `aside` metres of the line from `origin` along
  // `direction` at the origin, and within `apart` metres more for each metre from there.
  struct Node {
    size_t first, end;
    Vec3 origin, direction;
    double aside = 0, apart = 0;
    uint32_t halves = 0;  // the index of the first half, before that of the second one; 0 for a leaf
  };
  void bound(uint32_t node, std::span<const BeamMove> moves);
  double at_least(const Node& node, const Vec3& p) const;

  std::vector<SweptCylinder> parts_;
  std::vector<Node> nodes_;  // the root first
};

// Whether a single chord across a triangle fails to approximate the boundary of the region: the chord would
// deviate from it by more than `chord`, an edge crosses it more than once, or the region reaches into the
// triangle although no corner is inside. Parts that reach across the boundary by less than `graze` are
// ignored. `at` is the triangle of `face`, and `distances` are the signed distances of its corners, negative
// inside and zero on the boundary; all in metres.
bool chord_fails(const StrokeRegion& region, FaceId face, const Triangle& at,
                 const std::array<double, 3>& distances, double chord, double graze);

}  // namespace kerf
