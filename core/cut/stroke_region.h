#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "core/laser/laser.h"
#include "core/mesh/mesh.h"
#include "core/tree/swept_cylinder.h"

namespace kerf {

// All that a beam has swept in a stroke, in the frame of one body: the union of its moves. Faces remember the
// moves near them, so that asking for a distance near a face costs what lies there, however long the stroke
// is.
class StrokeRegion {
 public:
  void add(const SweptCylinder& part) { parts_.push_back(part); }
  size_t parts() const { return parts_.size(); }
  const SweptCylinder& part(size_t i) const { return parts_[i]; }

  // Tells of a part near a face, once each and in the order of parts; the parts of a face that was split are
  // those of its parent.
  void note_near(FaceId f, uint32_t part);
  void inherit(FaceId child, FaceId parent);
  bool is_near(FaceId f) const { return list_of_.count(f.index) != 0; }

  // Negative inside the union, positive outside; for a point in or next to the face.
  double signed_distance(FaceId near, const Vec3& p) const;

  // Whether any part, thinner by `graze` metres, meets the triangle.
  bool reaches_into(FaceId near, const Triangle& t, double graze) const;

  // Where the boundary crosses the segment from a point inside to one outside.
  Vec3 crossing(FaceId near, const Vec3& inside, const Vec3& outside) const;

 private:
  std::span<const uint32_t> parts_near(FaceId f) const;

  std::vector<SweptCylinder> parts_;
  std::vector<std::vector<uint32_t>> lists_;
  std::unordered_map<uint32_t, uint32_t> list_of_;  // face slot -> list; looked up, never walked
};

}  // namespace kerf
