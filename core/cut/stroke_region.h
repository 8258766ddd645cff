#pragma once

#include <span>
#include <unordered_map>
#include <vector>

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
  void note_near(FaceId f, uint32_t part);
  // Faces of the parents' area replaced them: each child is near every part that any parent is near, for it
  // may lie where only that parent lay. Slots are reused, so parents may be among the children. Precondition:
  // a parent is near the region. Constant time where the parents have one list, else linear in their lists.
  void inherit(std::span<const FaceId> children, std::span<const FaceId> parents);
  bool is_near(FaceId f) const { return list_of_.count(f.index) != 0; }

  // The signed distance of a point in or near the face from the boundary of the union: negative inside,
  // positive outside.
  double signed_distance(FaceId near, const Vec3& p) const;

  // Whether any part, with its radius reduced by `graze` metres, meets the triangle.
  bool reaches_into(FaceId near, const Triangle& t, double graze) const;

  // The point at which the boundary crosses the segment from a point inside to one outside.
  Vec3 crossing(FaceId near, const Vec3& inside, const Vec3& outside) const;

 private:
  std::span<const uint32_t> parts_near(FaceId f) const;
  uint32_t list_of_both(uint32_t a, uint32_t b);

  std::vector<SweptCylinder> parts_;
  std::vector<std::vector<uint32_t>> lists_;
  std::unordered_map<uint32_t, uint32_t> list_of_;  // face slot -> list; never iterated
};

}  // namespace kerf
