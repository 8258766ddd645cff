#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec3.h"
#include "core/mesh/files/point_tree.h"

namespace kerf {

// Triangulation of a polygon by ear clipping (G. H. Meisters: Polygons have ears, 1975). Clipping an ear can
// change only whether its two neighbours are ears, so that each clip needs two new tests. Only corners that
// are not convex can block an ear (D. Eberly: Triangulation by ear clipping, 2002); a tree finds those near
// it.
//
// Polygons of mesh files are not always simple. Straight corners, repeated corners and seams that join a hole
// to the outer boundary are triangulated correctly. For a boundary that intersects itself any n - 2 triangles
// are accepted, and the work is bounded.
class EarClipper {
 public:
  // Appends n - 2 triangles, as indices into the n points of a closed counter-clockwise polygon.
  // Preconditions: n >= 3, all coordinates are finite. O(n log n) for typical polygons.
  void clip(std::span<const Vec2> points, std::vector<std::array<uint32_t, 3>>& ears);

 private:
  // The rule by which a corner is accepted as an ear, from strict to anything.
  enum class Rule {
    kStrict,    // positive area, no other corner inside it or on its boundary
    kFlat,      // zero area: a straight or repeated corner, or a spike
    kTouching,  // positive area, no other corner inside it
    kAny,
  };

  void start(std::span<const Vec2> points);
  void enqueue_all();
  void enqueue(uint32_t i);
  bool start_round();
  void consider(uint32_t i, std::vector<std::array<uint32_t, 3>>& ears);
  void change_rule();
  bool is_ear(uint32_t i);
  bool is_blocked(uint32_t i);
  bool blocks(uint32_t q, uint32_t ear) const;
  bool enters_wedge(uint32_t q, uint32_t ear) const;
  void remove(uint32_t i);
  double turn(uint32_t i) const;

  std::span<const Vec2> points_;
  std::vector<uint32_t> previous_, next_;
  std::vector<uint8_t> blocker_;  // by corner: not clipped yet and not convex
  std::vector<uint8_t> queued_;
  std::vector<uint8_t> alive_;
  std::vector<uint32_t> touched_;  // by corner: the last round in which a neighbour was clipped
  std::vector<uint32_t> queue_;    // candidates of this round
  std::vector<uint32_t> waiting_;  // candidates postponed because a neighbour was clipped in this round
  std::vector<uint32_t> fresh_;    // new candidates for the next round
  uint32_t round_ = 0;
  PointTree tree_;
  Rule rule_ = Rule::kStrict;
  bool loosened_ = false;  // whether a rule other than kStrict found an ear since the last change of rule
  uint32_t left_ = 0;
  uint64_t work_ = 0;
  uint64_t most_work_ = 0;
};

}  // namespace kerf
