#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec3.h"
#include "core/mesh/files/point_tree.h"

namespace kerf {

// Ear clipping after G. H. Meisters, Polygons have ears (1975). An ear stays one until it or a neighbour is
// clipped, so that each clip needs two new tests; a test asks a tree for the corners that are not convex
// (D. Eberly, Triangulation by ear clipping, 2002) and looks only at the boxes that the ear touches.
//
// Polygons of files are not always simple. Straight corners, corners that repeat, seams that join a hole to
// the outside are cut rightly; for a line that crosses itself any cut into n - 2 triangles will do, and the
// work on it is bounded.
class EarClipper {
 public:
  // Appends n - 2 triangles of indices into `points`, n >= 3, a closed line counter-clockwise around its
  // area.
  void clip(std::span<const Vec2> points, std::vector<std::array<uint32_t, 3>>& ears);

 private:
  // What passes as an ear, from what is right to what ends the work.
  enum class Rule {
    kStrict,    // has area, and no other corner in it or on its border
    kFlat,      // has no area: a straight or repeated corner, or a spike
    kTouching,  // has area, and no other corner inside it
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
  std::vector<uint8_t> blocker_;  // alive and not convex
  std::vector<uint8_t> queued_;
  std::vector<uint8_t> alive_;
  std::vector<uint32_t> touched_;  // the round in which a neighbour was clipped last
  std::vector<uint32_t> queue_;    // the candidates of this round
  std::vector<uint32_t> waiting_;  // of them, those that a neighbour went before
  std::vector<uint32_t> fresh_;    // new candidates for the next round
  uint32_t round_ = 0;
  PointTree tree_;
  Rule rule_ = Rule::kStrict;
  bool loosened_ = false;  // a looser rule than the strict one has found an ear since the last change
  uint32_t left_ = 0;
  uint64_t work_ = 0;
  uint64_t most_work_ = 0;
};

}  // namespace kerf
