#include "ui/editor/single_step/stage_log.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "ui/editor/shared/command_labels.h"

namespace kerf {

namespace {

using Kind = StageMarks::Kind;
using OfBody = StageMarks::OfBody;

constexpr int kCornersOfEnd = 12;  // of each half of the outline of the beam's end
constexpr double kBeyond =
    0.12;  // of the size of the body, by which the drawn volume is longer than the body

void outline(const Triangle& t, uint32_t piece, Kind kind, OfBody& marks) {
  for (size_t i = 0; i < 3; ++i) marks.lines.push_back({t[i], t[(i + 1) % 3], piece, kind});
}

void mark_face(const Triangle& t, uint32_t piece, Kind kind, OfBody& marks) {
  marks.fills.push_back({t, piece, kind});
  outline(t, piece, kind, marks);
}

// Returns the depths of the body along the beam, i.e. the part of the volume that is drawn.
Interval depths_of(const Body& body, const SweptCylinder::Slab& whole) {
  const Bounds box = body.bounds();
  Interval depths{INFINITY, -INFINITY};
  for (unsigned i = 0; i < 8; ++i) {
    const Vec3 corner(i & 1u ? box.max.x : box.min.x, i & 2u ? box.max.y : box.min.y,
                      i & 4u ? box.max.z : box.min.z);
    const double depth = glm::dot(corner - whole.origin, whole.axis);
    depths = {std::min(depths.low, depth), std::max(depths.high, depth)};
  }
  const double beyond = kBeyond * glm::length(box.max - box.min);
  return {std::max(depths.low - beyond, whole.depth.low), std::min(depths.high + beyond, whole.depth.high)};
}

// Returns the cross-section of the volume: two half circles around the ends of the motion of the axis.
std::vector<Vec3> section(const SweptCylinder::Slab& slab, double radius) {
  std::vector<Vec3> corners;
  for (const bool back : {false, true}) {
    const double end = back ? slab.motion.low + radius : slab.motion.high - radius;
    for (int i = 0; i <= kCornersOfEnd; ++i) {
      const double turn = kPi * (static_cast<double>(i) / kCornersOfEnd - 0.5) + (back ? kPi : 0);
      corners.push_back(slab.origin + slab.along * (end + radius * std::cos(turn)) +
                        slab.across * (radius * std::sin(turn)));
    }
  }
  return corners;
}

void mark_volume(const Body& body, const SweptCylinder& volume, OfBody& marks) {
  const SweptCylinder::Slab whole = volume.slab({-INFINITY, INFINITY});
  const Interval depths = depths_of(body, whole);
  if (!(depths.low < depths.high)) return;
  const SweptCylinder::Slab slab = volume.slab(depths);
  const std::vector<Vec3> around = section(slab, volume.radius());
  const Vec3 low = whole.axis * depths.low, high = whole.axis * depths.high;
  for (size_t i = 0; i < around.size(); ++i) {
    const Vec3 &a = around[i], &b = around[(i + 1) % around.size()];
    marks.lines.push_back({a + low, b + low, 0, Kind::kSwept});
    marks.lines.push_back({a + high, b + high, 0, Kind::kSwept});
    if (i % kCornersOfEnd == 0) marks.lines.push_back({a + low, a + high, 0, Kind::kSwept});
    marks.fills.push_back({{a + low, b + low, b + high}, 0, Kind::kSwept});
    marks.fills.push_back({{a + low, b + high, a + high}, 0, Kind::kSwept});
  }
}

void mark_delta(const World& world, const BodyDelta& delta, StageRecord::Kind stage, StageMarks& marks) {
  if (!world.contains(delta.body)) return;
  const Body& body = world.body(delta.body);
  OfBody& on = marks.bodies.emplace_back();
  on.body = delta.body;
  for (const CutFace& f : delta.removed) mark_face(f.corners, f.piece, Kind::kRemoved, on);
  const bool splits = stage == StageRecord::Kind::kRefine || stage == StageRecord::Kind::kCloseRim;
  if (splits) {
    for (const FaceId f : delta.added) outline(body.mesh.triangle(f), body.label(f), Kind::kAdded, on);
  }
  std::set<uint32_t> off(delta.new_pieces.begin(), delta.new_pieces.end());
  for (const FaceId f : delta.relabelled) off.insert(body.mesh.data(f).piece);
  for (const uint32_t label : off) marks.came_off.push_back({delta.body, label});
}

void mark_beam(const Body& body, const StageRecord& stage, OfBody& on) {
  for (const SweptCylinder& volume : stage.beam) mark_volume(body, volume, on);
  for (const FaceId f : stage.hit) mark_face(body.mesh.triangle(f), body.label(f), Kind::kHit, on);
}

using Found = TouchedWalk::Outcome;
using Side = TouchedWalk::Side;
using Kind = StageMarks::Kind;

Kind kind_of(Found outcome) {
  switch (outcome) {
    case Found::kEntered:
      return Kind::kEntered;
    case Found::kCulled:
      return Kind::kCulled;
    case Found::kMissed:
      return Kind::kMissed;
    case Found::kTouched:
      return Kind::kTouched;
  }
  return Kind::kEntered;
}

std::string cull_reason(Side side) {
  switch (side) {
    case Side::kDepth:
      return "it lies before the start or beyond the end of the beam";
    case Side::kMotion:
      return "it lies ahead of or behind the volume that the beam sweeps";
    case Side::kLateral:
      return "it lies to the side of the volume that the beam sweeps";
    case Side::kNone:
      break;
  }
  return "it lies outside the volume that the beam sweeps";
}

void add_box(const AabbTree::Box& box, Kind kind, std::vector<StageMarks::Line>& lines) {
  const auto corner = [&](unsigned i) {
    return Vec3(i & 1u ? box.max.x : box.min.x, i & 2u ? box.max.y : box.min.y,
                i & 4u ? box.max.z : box.min.z);
  };
  for (unsigned from = 0; from < 8; ++from) {
    for (unsigned axis = 1; axis < 8; axis *= 2) {
      if ((from & axis) == 0) lines.push_back({corner(from), corner(from | axis), 0, kind});
    }
  }
}

}  // namespace

StageMarks mark_stage(const World& world, const StageRecord& stage) {
  StageMarks marks;
  if (world.contains(stage.body)) {
    OfBody& on = marks.bodies.emplace_back();
    on.body = stage.body;
    mark_beam(world.body(stage.body), stage, on);
  }
  for (const BodyDelta& delta : stage.done.delta.bodies) mark_delta(world, delta, stage.kind, marks);
  return marks;
}

void QueryWalk::trace(const World& world, const StageRecord& found) {
  visits_.clear();
  body_ = found.body;
  const Body& body = world.body(found.body);
  for (const SweptCylinder& volume : found.beam) {
    const auto before = static_cast<uint32_t>(visits_.size());
    for (TouchedWalk::Visit visit : trace_touched(body.tree, body.mesh, volume).visits) {
      if (visit.parent != TouchedWalk::kNoParent) visit.parent += before;
      visits_.push_back(visit);
    }
  }
  visited_ = visits_.size();
}

void QueryWalk::clear() {
  visits_.clear();
  visited_ = 0;
}

void QueryWalk::visit(size_t boxes) {
  KERF_ASSERT(boxes > 0);
  visited_ = std::min(boxes, visits_.size());
}

std::string QueryWalk::words() const {
  KERF_ASSERT(visited_ > 0);
  const TouchedWalk::Visit& visit = visits_[visited_ - 1];
  const std::string face = visit.face.valid() ? std::to_string(visit.face.index) : "";
  const std::string box =
      face.empty() ? "A box at level " + std::to_string(visit.box.depth) : "The box of face " + face;
  switch (visit.outcome) {
    case Found::kEntered:
      return box + " was entered: it may intersect the beam, so its contents are tested.";
    case Found::kCulled:
      return box + " was culled: " + cull_reason(visit.outside) + ".";
    case Found::kMissed:
      return box + " may intersect the beam, so the face was tested: the beam misses it.";
    case Found::kTouched:
      return box + " may intersect the beam, so the face was tested: the beam hits it.";
  }
  return box;
}

size_t QueryWalk::count(Found outcome) const {
  const auto end = visits_.begin() + static_cast<std::ptrdiff_t>(visited_);
  return static_cast<size_t>(
      std::count_if(visits_.begin(), end, [&](const TouchedWalk::Visit& v) { return v.outcome == outcome; }));
}

void QueryWalk::mark(StageMarks& marks) const {
  if (visited_ == 0) return;
  StageMarks::OfBody& on = marks.bodies.emplace_back();
  on.body = body_;
  for (size_t i = visited_ - std::min(visited_, kMaxDrawn); i < visited_; ++i)
    add_box(visits_[i].box, kind_of(visits_[i].outcome), on.lines);
  add_box(visits_[visited_ - 1].box, Kind::kLast, on.lines);
}

// A stage executed again has the same sentence; if it differs, the rest of the log belongs to another queue.
void StageLog::note(const World& world, const StageRecord& stage, FileUnit unit) {
  std::string sentence = stage_label(stage, unit);
  if (done_ < told_.size() && told_[done_] != sentence) told_.resize(done_);
  while (!sweeps_.empty() && sweeps_.back() > told_.size()) sweeps_.pop_back();
  if (done_ == told_.size()) told_.push_back(std::move(sentence));
  ++done_;
  const bool found = stage.kind == StageRecord::Kind::kHit || stage.kind == StageRecord::Kind::kHitAgain;
  if (found && world.contains(stage.body)) query_.trace(world, stage);
  if (stage.kind == StageRecord::Kind::kSweep) {
    swept_ = done_;
    if (sweeps_.empty() || sweeps_.back() < done_) sweeps_.push_back(done_);
    cut_.clear();
  }
  for (const BodyDelta& delta : stage.done.delta.bodies) {
    for (const CutFace& face : delta.removed) cut_.insert({delta.body, face.piece});
  }
  last_ = stage;
  marks_.reset();
}

size_t StageLog::moves() const {
  return static_cast<size_t>(std::upper_bound(sweeps_.begin(), sweeps_.end(), done_) - sweeps_.begin());
}

size_t StageLog::stage_of_move() const { return moves() == 0 ? done_ : done_ - sweeps_[moves() - 1] + 1; }

// The last query is that of the last sweep, or is traced again by the following stages.
void StageLog::restart(size_t stages) {
  KERF_ASSERT(stages <= done_);
  done_ = stages;
  last_.reset();
  if (stages < swept_) query_.clear();
  marks_.reset();
}

void StageLog::forget() {
  restart();
  told_.clear();
  sweeps_.clear();
  ++forgotten_;
}

void StageLog::draw_query(bool drawn) {
  query_.drawn = drawn;
  marks_.reset();
}

void StageLog::visit(size_t boxes) {
  query_.visit(boxes);
  draw_query(true);
}

std::shared_ptr<const StageMarks> StageLog::marks(const World& world) {
  if (!last_) return nullptr;
  if (marks_) return marks_;
  StageMarks marks = mark_stage(world, *last_);
  if (!marks.came_off.empty()) {
    for (const PieceId& piece : cut_) {
      if (std::count(marks.came_off.begin(), marks.came_off.end(), piece) == 0) marks.stayed.push_back(piece);
    }
  }
  if (query_.drawn) query_.mark(marks);
  marks_ = std::make_shared<const StageMarks>(std::move(marks));
  return marks_;
}

}  // namespace kerf
