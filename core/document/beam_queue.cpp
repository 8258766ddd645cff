#include "core/document/beam_queue.h"

#include <algorithm>
#include <cassert>

namespace kerf {

namespace {

// How far along the beam there is anything to cut (m): to the farthest corner of what was loaded, where it
// stands now. What is left of it depends on how far the moves before were walked.
double reach(const World& world, const Stroke& stroke, const Pose& pose) {
  const World::Bounds bounds = world.loaded_bounds();
  const Vec3 far = glm::max(glm::abs(bounds.min - pose.origin), glm::abs(bounds.max - pose.origin));
  return std::min(stroke.settings.laser.range.high, glm::length(far));
}

std::vector<BeamMove> subdivide_in(const World& world, const Stroke& stroke, const BeamMove& move) {
  return subdivide(move, stroke.settings.laser.radius, reach(world, stroke, move.from));
}

}  // namespace

bool BeamQueue::holds(size_t step) const {
  if (!ready_.empty() && ready_step_ == step) return true;
  const auto first = std::lower_bound(entries_.begin(), entries_.end(), step,
                                      [](const Entry& e, size_t wanted) { return e.step < wanted; });
  return first != entries_.end() && first->step == step;
}

void BeamQueue::push(Entry entry) {
  assert(empty() || (entries_.empty() ? ready_step_ : entries_.back().step) <= entry.step);
  size_ += entry.count;
  if (entry.in_time()) in_time_ += entry.count;
  entries_.push_back(std::move(entry));
}

void BeamQueue::push_in_front(Entry entry) {
  assert(ready_.empty() && !unfinished_rim_.begun() && entry.in_time());
  size_ += entry.count;
  in_time_ += entry.count;
  entries_.push_front(std::move(entry));
}

void BeamQueue::push_move(size_t step, std::shared_ptr<Stroke> stroke, const BeamMove& move,
                          const World& world) {
  const size_t count = subdivisions(move, stroke->settings.laser.radius, reach(world, *stroke, move.from));
  push({step, Kind::kMove, std::move(stroke), move, count, false, {}});
}

void BeamQueue::push_rim(size_t step, std::shared_ptr<Stroke> stroke) {
  push({step, Kind::kRim, std::move(stroke), {}, 1, false, {}});
}

void BeamQueue::push_ticks(size_t step, Ticks ticks, bool bodies, std::shared_ptr<Stroke> stroke) {
  const Pose beam = stroke ? stroke->beam.pose : Pose{};
  push({step, Kind::kTicks, std::move(stroke), {beam, beam, 0}, ticks, bodies, {}});
}

void BeamQueue::push_spring(size_t step, const std::optional<Spring>& spring) {
  push({step, Kind::kSpring, nullptr, {}, 1, false, spring});
}

void BeamQueue::push_ticks_in_front(size_t step, Ticks ticks, bool bodies) {
  push_in_front({step, Kind::kTicks, nullptr, {}, ticks, bodies, {}});
}

void BeamQueue::push_spring_in_front(size_t step, const std::optional<Spring>& spring) {
  push_in_front({step, Kind::kSpring, nullptr, {}, 1, false, spring});
}

size_t BeamQueue::front_step() const {
  assert(!empty());
  return ready_.empty() ? entries_.front().step : ready_step_;
}

const std::shared_ptr<Stroke>& BeamQueue::front_stroke() const {
  assert(!empty() && (front_kind() == Kind::kMove || front_kind() == Kind::kRim));
  return ready_.empty() ? entries_.front().stroke : ready_stroke_;
}

Ticks BeamQueue::front_ticks() const {
  assert(!empty() && front_kind() == Kind::kTicks);
  return entries_.front().count;
}

bool BeamQueue::front_moves_bodies() const {
  assert(!empty() && front_kind() == Kind::kTicks);
  return entries_.front().bodies;
}

const std::shared_ptr<Stroke>& BeamQueue::front_beam() const {
  assert(!empty() && front_kind() == Kind::kTicks);
  return entries_.front().stroke;
}

const Pose& BeamQueue::front_beam_pose() const {
  assert(front_beam());
  return entries_.front().move.to;
}

const std::optional<Spring>& BeamQueue::front_spring() const {
  assert(!empty() && front_kind() == Kind::kSpring);
  return entries_.front().spring;
}

std::optional<BeamMove> BeamQueue::next_move(const World& world) const {
  if (!ready_.empty()) return ready_.front();
  if (entries_.empty() || entries_.front().kind != Kind::kMove) return std::nullopt;
  return subdivide_in(world, *entries_.front().stroke, entries_.front().move).front();
}

std::vector<BeamMove> BeamQueue::begin_moves(const World& world, size_t most) {
  assert(most > 0 && front_kind() == Kind::kMove);
  const size_t step = front_step();
  while (ready_.size() < most && !entries_.empty() && entries_.front().kind == Kind::kMove &&
         entries_.front().step == step) {
    const Entry entry = std::move(entries_.front());
    entries_.pop_front();
    const std::vector<BeamMove> moves = subdivide_in(world, *entry.stroke, entry.move);
    const bool straight = entry.move.from.direction == entry.move.to.direction;
    std::vector<BeamMove>& path = entry.stroke->path;
    path.insert(path.end(), straight ? &entry.move : moves.data(),
                straight ? &entry.move + 1 : moves.data() + moves.size());
    ready_.insert(ready_.end(), moves.begin(), moves.end());
    ready_step_ = step;
    ready_stroke_ = entry.stroke;
    size_ = size_ - entry.count + moves.size();
  }
  const auto count = static_cast<std::ptrdiff_t>(std::min(most, ready_.size()));
  return {ready_.begin(), ready_.begin() + count};
}

void BeamQueue::pop_moves(size_t count) {
  assert(count <= ready_.size());
  ready_.erase(ready_.begin(), ready_.begin() + static_cast<std::ptrdiff_t>(count));
  size_ -= count;
}

void BeamQueue::pop_rim() {
  assert(!empty() && front_kind() == Kind::kRim && !unfinished_rim_.begun());
  entries_.pop_front();
  --size_;
}

void BeamQueue::pop_ticks(Ticks count) {
  assert(!empty() && front_kind() == Kind::kTicks && count <= entries_.front().count);
  entries_.front().count -= count;
  size_ -= count;
  in_time_ -= count;
  if (entries_.front().count == 0) entries_.pop_front();
}

void BeamQueue::pop_spring() {
  assert(!empty() && front_kind() == Kind::kSpring);
  entries_.pop_front();
  --size_;
  --in_time_;
}

template <typename Drops>
void BeamQueue::drop_if(size_t step, Drops drops) {
  if (!ready_.empty() && ready_step_ == step) {
    size_ -= ready_.size();
    ready_.clear();
    unfinished_ = UnfinishedMove{};
  }
  if (!empty() && front_step() == step) unfinished_rim_ = UnfinishedRim{};
  std::erase_if(entries_, [&](const Entry& e) {
    const bool gone = e.step == step && drops(e);
    size_ -= gone ? e.count : 0;
    in_time_ -= gone && e.in_time() ? e.count : 0;
    return gone;
  });
}

void BeamQueue::drop(size_t step) {
  drop_if(step, [](const Entry&) { return true; });
}

void BeamQueue::drop_strokes(size_t step) {
  drop_if(step, [](const Entry& e) { return !e.in_time(); });
  for (Entry& e : entries_) {
    if (e.step == step) e.stroke = nullptr;
  }
}

}  // namespace kerf
