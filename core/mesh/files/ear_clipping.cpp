#include "core/mesh/files/ear_clipping.h"

#include <algorithm>
#include <cassert>

namespace kerf {
namespace {

// Limits of the number of boxes and points tested for a polygon, beyond which any corner counts as an ear.
// The worst simple polygons tried, of a hundred thousand corners, need 500 tests per corner.
constexpr uint64_t kWorkPerCorner = 2000;
constexpr uint64_t kMostWork = 400'000'000;

double turn2(Vec2 a, Vec2 b, Vec2 c) { return cross2(b - a, c - a); }

}  // namespace

double EarClipper::turn(uint32_t i) const {
  return turn2(points_[previous_[i]], points_[i], points_[next_[i]]);
}

void EarClipper::start(std::span<const Vec2> points) {
  points_ = points;
  left_ = static_cast<uint32_t>(points.size());
  previous_.resize(left_);
  next_.resize(left_);
  blocker_.resize(left_);
  queued_.assign(left_, 0);
  touched_.assign(left_, 0);
  alive_.assign(left_, 1);
  for (uint32_t i = 0; i < left_; ++i) {
    previous_[i] = i == 0 ? left_ - 1 : i - 1;
    next_[i] = i + 1 == left_ ? 0 : i + 1;
  }
  waiting_.clear();
  fresh_.clear();
  round_ = 0;
  std::vector<uint32_t> chosen;
  for (uint32_t i = 0; i < left_; ++i) {
    blocker_[i] = !(turn(i) > 0);
    if (blocker_[i]) chosen.push_back(i);
  }
  tree_.build(points, chosen);
  rule_ = Rule::kStrict;
  loosened_ = false;
  work_ = 0;
  most_work_ = std::min(kMostWork, kWorkPerCorner * (left_ + uint64_t{1000}));
}

void EarClipper::enqueue(uint32_t i) {
  if (queued_[i]) return;
  queued_[i] = 1;
  fresh_.push_back(i);
}

void EarClipper::enqueue_all() {
  work_ += alive_.size();
  for (uint32_t i = 0; i < alive_.size(); ++i) {
    if (alive_[i]) enqueue(i);
  }
}

// Whether the edges at q, which coincides with the tip of the ear, lead into the ear: one of them into its
// interior, or both along its sides.
bool EarClipper::enters_wedge(uint32_t q, uint32_t ear) const {
  const Vec2 tip = points_[ear], out = points_[next_[ear]] - tip, back = points_[previous_[ear]] - tip;
  bool along = true;
  for (const uint32_t neighbour : {previous_[q], next_[q]}) {
    const Vec2 direction = points_[neighbour] - tip;
    const double from_out = cross2(out, direction), to_back = cross2(direction, back);
    if (from_out > 0 && to_back > 0) return true;
    along = along && from_out >= 0 && to_back >= 0;
  }
  return along;
}

bool EarClipper::blocks(uint32_t q, uint32_t ear) const {
  const Vec2 p = points_[q], a = points_[previous_[ear]], b = points_[ear], c = points_[next_[ear]];
  const double ab = turn2(a, b, p), bc = turn2(b, c, p), ca = turn2(c, a, p);
  if (rule_ == Rule::kTouching) return ab > 0 && bc > 0 && ca > 0;
  if (!(ab >= 0 && bc >= 0 && ca >= 0)) return false;
  // A chain that starts at an end of the cut and enters the ear has a corner inside that blocks by itself.
  if (p == a || p == c) return false;
  return p != b || enters_wedge(q, ear);
}

bool EarClipper::is_blocked(uint32_t i) {
  const std::array<Vec2, 3> ear{points_[previous_[i]], points_[i], points_[next_[i]]};
  return tree_.visit(ear, work_, [&](uint32_t q) {
    if (!blocker_[q]) return PointTree::Verdict::kForget;
    if (q == i || q == previous_[i] || q == next_[i]) return PointTree::Verdict::kPass;
    return blocks(q, i) ? PointTree::Verdict::kStop : PointTree::Verdict::kPass;
  });
}

bool EarClipper::is_ear(uint32_t i) {
  if (rule_ == Rule::kAny) return true;
  const double area = turn(i);
  if (rule_ == Rule::kFlat) return area == 0;
  return area > 0 && !is_blocked(i);
}

void EarClipper::remove(uint32_t i) {
  assert(alive_[i] && left_ > 3);
  const uint32_t before = previous_[i], after = next_[i];
  next_[before] = after;
  previous_[after] = before;
  alive_[i] = 0;
  blocker_[i] = 0;
  --left_;
  // A corner that became convex stays removed from the tree even if rounding makes it straight again.
  blocker_[before] = blocker_[before] && !(turn(before) > 0);
  blocker_[after] = blocker_[after] && !(turn(after) > 0);
  touched_[before] = touched_[after] = round_;
  enqueue(before);
  enqueue(after);
}

// No candidate is left: returns to the strict rule if a looser one found an ear, else loosens the rule.
void EarClipper::change_rule() {
  if (rule_ != Rule::kAny) rule_ = loosened_ ? Rule::kStrict : static_cast<Rule>(static_cast<int>(rule_) + 1);
  loosened_ = false;
  enqueue_all();
}

// Ears are clipped in rounds, and no two neighbours in the same round: clipping neighbours one after the
// other would make fans of long triangles, whose tests visit many boxes. Postponed candidates come first in
// the next round.
bool EarClipper::start_round() {
  queue_.assign(waiting_.begin(), waiting_.end());
  queue_.insert(queue_.end(), fresh_.begin(), fresh_.end());
  waiting_.clear();
  fresh_.clear();
  ++round_;
  return !queue_.empty();
}

void EarClipper::consider(uint32_t i, std::vector<std::array<uint32_t, 3>>& ears) {
  if (alive_[i] && touched_[i] == round_) return waiting_.push_back(i);
  queued_[i] = 0;
  if (!alive_[i] || !is_ear(i)) return;
  ears.push_back({previous_[i], i, next_[i]});
  loosened_ = rule_ != Rule::kStrict;
  remove(i);
}

void EarClipper::clip(std::span<const Vec2> points, std::vector<std::array<uint32_t, 3>>& ears) {
  assert(points.size() >= 3);
  start(points);
  enqueue_all();
  while (left_ > 3) {
    if (!start_round() || (rule_ == Rule::kTouching && loosened_)) change_rule();
    for (size_t i = 0; i < queue_.size() && left_ > 3; ++i) {
      if (work_ > most_work_) rule_ = Rule::kAny;
      consider(queue_[i], ears);
    }
  }
  const uint32_t rest = static_cast<uint32_t>(std::find(alive_.begin(), alive_.end(), 1) - alive_.begin());
  ears.push_back({previous_[rest], rest, next_[rest]});
}

}  // namespace kerf
