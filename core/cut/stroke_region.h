#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/base/assert.h"
#include "core/base/containers.h"
#include "core/laser/laser.h"
#include "core/mesh/mesh.h"
#include "core/tree/swept_cylinder.h"

namespace kerf {

// The volume that a beam has swept in a stroke, in the frame of one body: the union of its parts, i.e. of the
// volumes swept by single moves. Each face near the region has a list of the parts that intersect it, so that
// the cost of a distance query in a face depends on their number, not on the length of the stroke. Queries
// are correct if the list of a face holds every part that intersects it, so call inherit() when faces are
// replaced.
class StrokeRegion {
 public:
  void add(const SweptCylinder& part) {
    parts_.push_back(part);
    steepest_ = std::max(steepest_, part.steepest());
  }
  size_t parts() const { return parts_.size(); }
  const SweptCylinder& part(size_t i) const {
    KERF_ASSERT(i < parts_.size());
    return parts_[i];
  }

  // Appends a part to the list of a face. Precondition: parts are added to a face in ascending order.
  void record_near(FaceId f, uint32_t part);
  // Copies the lists of replaced faces to their children. Each child gets the parts of all parents, since it
  // may lie within any of them. Slots are reused, so parents may be among the children. Precondition: at
  // least one parent is near the region. Constant time if the parents have one list, else linear in their
  // lists.
  void inherit(std::span<const FaceId> children, std::span<const FaceId> parents);
  bool is_near(FaceId f) const { return list_of_.get(f.index) != 0; }

  // Returns the signed distance (m) of a point in or near the face from the boundary: negative inside.
  double signed_distance(FaceId near, const Vec3& p) const;

  // Returns true if any part, with its radius reduced by `graze` metres, intersects the triangle.
  bool reaches_into(FaceId near, const Triangle& t, double graze) const;

  // Returns a Lipschitz constant of the signed distance.
  double steepest() const { return steepest_; }

  // Returns the point at which the segment from a point inside to a point outside crosses the boundary, or a
  // point outside that is nearer to it than `precision` times the length of the segment.
  Vec3 crossing(FaceId near, const Vec3& inside, const Vec3& outside, double precision = 0x1p-52) const;

 private:
  // The parts that may contain a point of a segment, reduced as the segment is halved.
  class PartsOnSegment;

  static constexpr uint32_t kNone = 0xffffffffu;

  // Entry of a linked list in one array, so that thousands of lists grow and shrink without allocations.
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
  double steepest_ = 1;  // of all parts
  std::vector<Entry> entries_;
  std::vector<List> lists_;
  PagedArray<uint32_t> list_of_;  // by face slot: index of its list plus one, or 0
};

// Signed distance from the boundary of the volume swept by a stroke, at any point; StrokeRegion works only
// near a face. A bounding hierarchy over consecutive moves, a binary tree, limits a query to the near parts.
class SweptDistance {
 public:
  // Precondition: part i of the region is the volume of moves[i], in one frame. O(n log n).
  SweptDistance(const StrokeRegion& region, std::span<const BeamMove> moves);

  // Returns the minimum of the signed distances from all parts (m), negative inside; exact to the bit.
  double operator()(const Vec3& p) const;

 private:
  // Parts first .. end - 1. `middle` is a pose in the middle. The origins of the other poses differ from its
  // origin by at most `aside` metres, along its direction by at most `shift`, and their unit directions from
  // its direction by at most `apart`. For each pose, the linear interpolation from `from` to `to` contains
  // one whose origin differs by at most `bulge` metres and whose direction by at most `bend`.
  struct Node {
    size_t first, end;
    Pose middle, from, to;
    double aside = 0, shift = 0, apart = 0, bulge = 0, bend = 0;
    uint32_t halves = 0;  // index of the first child, followed by the second; 0: a leaf
  };
  void bound(uint32_t node, std::span<const BeamMove> moves);
  // A lower bound of the distances from the parts of a node, and the distance from its middle pose (m).
  struct Estimate {
    double at_least, from_middle;
  };
  Estimate estimate(const Node& node, const Vec3& p) const;

  std::vector<SweptCylinder> parts_;
  std::vector<Node> nodes_;  // root first
};

// Returns true if a single chord across a triangle does not approximate the boundary of the region: the chord
// would deviate from the boundary by more than `chord`, an edge crosses the boundary more than once, or the
// region reaches into the triangle although no corner is inside. Ignores parts of the region that reach into
// the triangle by less than `graze`. `at`: the triangle of `face`. `distances`: of its corners, negative
// inside and zero on the boundary. All lengths in metres.
bool chord_fails(const StrokeRegion& region, FaceId face, const Triangle& at,
                 const std::array<double, 3>& distances, double chord, double graze);

}  // namespace kerf
