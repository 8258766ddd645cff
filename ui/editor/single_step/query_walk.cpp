#include "ui/editor/single_step/query_walk.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

namespace {

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

std::string why_culled(Side side) {
  switch (side) {
    case Side::kDepth:
      return "it lies before the beginning of the beam or behind its end";
    case Side::kMotion:
      return "it lies ahead of the volume that the beam sweeps, or behind it, in the direction of its motion";
    case Side::kLateral:
      return "it lies beside the volume that the beam sweeps, across its motion";
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
      return box + " was entered: it may meet the beam, so what it contains is tested, too.";
    case Found::kCulled:
      return box + " was culled: " + why_culled(visit.outside) + ".";
    case Found::kMissed:
      return box + " may meet the beam, so the face was tested: the beam misses it.";
    case Found::kTouched:
      return box + " may meet the beam, so the face was tested: the beam hits it.";
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
  for (size_t i = visited_ - std::min(visited_, kMostDrawn); i < visited_; ++i)
    add_box(visits_[i].box, kind_of(visits_[i].outcome), on.lines);
  add_box(visits_[visited_ - 1].box, Kind::kLast, on.lines);
}

}  // namespace kerf
