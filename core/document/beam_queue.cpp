#include "core/document/beam_queue.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.h"

namespace kerf {

namespace {

BeamMove in_body(const Placement& placement, const BeamMove& move) {
  return {placement.to_body(move.from), placement.to_body(move.to), move.seconds};
}

double distance(const Pose& beam, const Vec3& p) {
  const Vec3 way = p - beam.origin;
  const double along = std::max(0.0, glm::dot(way, beam.direction));
  return glm::length(way - along * beam.direction);
}

// The length of the beam up to the farthest corner of the loaded bounds at their current placement [m]. It
// ignores removed faces, which depend on the progress of the moves before.
double reach(const World& world, const Stroke& stroke, const Pose& pose) {
  const World::Bounds bounds = world.loaded_bounds();
  const Vec3 far = glm::max(glm::abs(bounds.min - pose.origin), glm::abs(bounds.max - pose.origin));
  return std::min(stroke.settings.laser.range.high, glm::length(far));
}

std::vector<BeamMove> subdivide_in(const World& world, const Stroke& stroke, const BeamMove& move) {
  return subdivide(move, stroke.settings.laser.radius, reach(world, stroke, move.from));
}

// Joins the first `parts` of `of` equal parts of a straight move.
BeamMove first_parts(const BeamMove& move, const Pose& to, size_t parts, size_t of) {
  return {move.from, to, move.seconds * static_cast<double>(parts) / static_cast<double>(of)};
}

bool is_straight(const BeamMove& move) { return move.from.direction == move.to.direction; }

// The number of parts of a move that make up a share of it, rounded up.
size_t parts_of(double share, size_t parts) {
  if (share >= 1) return parts;
  const auto rounded = static_cast<size_t>(std::ceil(share * static_cast<double>(parts)));
  return std::clamp<size_t>(rounded, 1, parts);
}

}  // namespace

void Stroke::list_path(const World& world) {
  for (auto& [id, moves] : swept) {
    if (!world.contains(id)) continue;
    const Placement& placement = world.body(id).placement;
    for (size_t i = listed_; i < path.size(); ++i) moves.push_back(in_body(placement, path[i]));
  }
  listed_ = path.size();
}

void Stroke::cut_back(const World& world, size_t moves, const std::optional<BeamMove>& instead) {
  KERF_ASSERT(listed_ == path.size() && moves <= path.size());
  for (auto& [id, listed] : swept) {
    if (world.contains(id)) listed.resize(listed.size() - moves);
  }
  path.resize(path.size() - moves);
  listed_ = path.size();
  if (instead) path.push_back(*instead);
  list_path(world);
}

void Stroke::inherit(std::span<const Detached> detached) {
  for (const Detached& d : detached) {
    const auto at = swept.find(d.from);
    if (at != swept.end()) swept[d.to] = at->second;
    if (settings.cuts(d.from) && !settings.cuts(d.to)) settings.bodies.push_back(d.to);
  }
}

std::vector<BeamMove> Stroke::move_body(BodyId id, const Body& body, const Placement& from,
                                        const Pose& still) {
  KERF_ASSERT(listed_ == path.size());
  const auto [at, first] = swept.try_emplace(id);
  if (first) {
    for (const BeamMove& move : path) at->second.push_back(in_body(from, move));
  }
  const BeamMove whole{from.to_body(still), body.placement.to_body(still), 0};
  // The loaded bounds of the body lie in a sphere around their middle.
  const Vec3 middle = body.middle();
  const double size = 0.5 * glm::length(body.loaded.max - body.loaded.min);
  const double reach = glm::distance(whole.from.origin, middle) + size;
  const double radius = settings.laser.radius;
  std::vector<BeamMove> moves = subdivide(whole, radius, std::min(settings.laser.range.high, reach));
  // Each of the moves carries the beam by at most a radius.
  std::erase_if(moves, [&](const BeamMove& m) { return distance(m.from, middle) > size + 3 * radius; });
  at->second.insert(at->second.end(), moves.begin(), moves.end());
  return moves;
}

bool BeamQueue::only_cools() const {
  return !empty() && !holds_beam() && std::all_of(entries_.begin(), entries_.end(), [](const Entry& e) {
    return e.kind == Kind::kTicks && !e.bodies;
  });
}

double BeamQueue::Part::begin() const {
  return static_cast<double>(of->number) + static_cast<double>(number) / static_cast<double>(of->parts);
}

double BeamQueue::Part::end() const {
  return static_cast<double>(of->number) + static_cast<double>(number + 1) / static_cast<double>(of->parts);
}

bool BeamQueue::holds(size_t step) const {
  if (!ready_.empty() && ready_step_ == step) return true;
  const auto first = std::lower_bound(entries_.begin(), entries_.end(), step,
                                      [](const Entry& e, size_t wanted) { return e.step < wanted; });
  return first != entries_.end() && first->step == step;
}

void BeamQueue::push(Entry entry) {
  KERF_ASSERT(entry.count > 0);
  KERF_ASSERT(empty() || (entries_.empty() ? ready_step_ : entries_.back().step) <= entry.step);
  size_ += entry.count;
  if (entry.in_time()) in_time_ += entry.count;
  if (entry.kind == Kind::kRim) ++rims_;
  entries_.push_back(std::move(entry));
}

void BeamQueue::push_in_front(Entry entry) {
  KERF_ASSERT(ready_.empty() && !unfinished_rim_.begun() && entry.in_time());
  size_ += entry.count;
  in_time_ += entry.count;
  entries_.push_front(std::move(entry));
}

void BeamQueue::push_move(size_t step, std::shared_ptr<Stroke> stroke, const BeamMove& move,
                          const World& world) {
  const size_t count = subdivisions(move, stroke->settings.laser.radius, reach(world, *stroke, move.from));
  const size_t number = stroke->queued++;
  push({.step = step, .stroke = std::move(stroke), .move = move, .number = number, .count = count});
}

void BeamQueue::push_rim(size_t step, std::shared_ptr<Stroke> stroke) {
  push({.step = step, .kind = Kind::kRim, .stroke = std::move(stroke)});
}

void BeamQueue::push_ticks(size_t step, Ticks ticks, bool bodies, std::shared_ptr<Stroke> stroke) {
  const Pose beam = stroke ? stroke->beam.pose : Pose{};
  push({.step = step,
        .kind = Kind::kTicks,
        .stroke = std::move(stroke),
        .move = {beam, beam, 0},
        .count = ticks,
        .bodies = bodies});
}

void BeamQueue::push_spring(size_t step, const std::optional<Spring>& spring) {
  push({.step = step, .kind = Kind::kSpring, .spring = spring});
}

void BeamQueue::push_ticks_in_front(size_t step, Ticks ticks, bool bodies) {
  push_in_front({.step = step, .kind = Kind::kTicks, .count = ticks, .bodies = bodies});
}

void BeamQueue::push_spring_in_front(size_t step, const std::optional<Spring>& spring) {
  push_in_front({.step = step, .kind = Kind::kSpring, .spring = spring});
}

size_t BeamQueue::front_step() const {
  KERF_ASSERT(!empty());
  return ready_.empty() ? entries_.front().step : ready_step_;
}

const std::shared_ptr<Stroke>& BeamQueue::front_stroke() const {
  KERF_ASSERT(!empty() && (front_kind() == Kind::kMove || front_kind() == Kind::kRim));
  return ready_.empty() ? entries_.front().stroke : ready_stroke_;
}

const BeamQueue::Entry& BeamQueue::front_in_time() const {
  KERF_ASSERT(ready_.empty() && !entries_.empty() && entries_.front().in_time());
  return entries_.front();
}

std::optional<BeamMove> BeamQueue::next_move(const World& world) const {
  if (!ready_.empty()) return ready_.front().move;
  if (entries_.empty() || entries_.front().kind != Kind::kMove) return std::nullopt;
  return subdivide_in(world, *entries_.front().stroke, entries_.front().move).front();
}

std::vector<BeamMove> BeamQueue::begin_moves(const World& world, size_t most) {
  KERF_ASSERT(most > 0 && front_kind() == Kind::kMove);
  const size_t step = front_step();
  while (ready_.size() < most && !entries_.empty() && entries_.front().kind == Kind::kMove &&
         entries_.front().step == step) {
    const Entry entry = std::move(entries_.front());
    entries_.pop_front();
    begin_move(entry, subdivide_in(world, *entry.stroke, entry.move));
    ready_step_ = step;
    ready_stroke_ = entry.stroke;
  }
  std::vector<BeamMove> moves;
  for (size_t i = 0; i < std::min(most, ready_.size()); ++i) moves.push_back(ready_[i].move);
  KERF_ASSERT(!moves.empty());
  return moves;
}

void BeamQueue::begin_move(const Entry& entry, std::span<const BeamMove> parts) {
  KERF_ASSERT(!parts.empty() && entry.share > 0);
  const size_t kept = parts_of(entry.share, parts.size());
  std::vector<BeamMove>& path = entry.stroke->path;
  const bool whole = kept == parts.size(), straight = is_straight(entry.move);
  if (straight) {
    path.push_back(whole ? entry.move : first_parts(entry.move, parts[kept].from, kept, parts.size()));
  } else {
    path.insert(path.end(), parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(kept));
  }
  const auto begun =
      std::make_shared<const Begun>(Begun{entry.move, entry.number, parts.size(), straight ? 1 : kept});
  for (size_t i = 0; i < kept; ++i) ready_.push_back({parts[i], begun, i});
  size_ = size_ - entry.count + kept;
}

StopStroke BeamQueue::reached(size_t step) const {
  StopStroke reached;
  if (reached_step_ == step) reached = reached_;
  const bool within = unfinished_.bodies > 0 || unfinished_.stage != UnfinishedMove::Stage::kFind;
  if (!ready_.empty() && ready_step_ == step && within) reached = {ready_.front().end()};
  return reached;
}

bool BeamQueue::holds_moves(size_t step) const {
  if (!ready_.empty() && ready_step_ == step && ready_.back().end() > reached(step).moves) return true;
  return std::any_of(entries_.begin(), entries_.end(),
                     [&](const Entry& e) { return e.step == step && e.kind == Kind::kMove; });
}

// Drops the parts of begun moves beyond the place, and shortens the one that contains it.
void BeamQueue::stop_begun(const StopStroke& at, const World& world) {
  size_t kept = 0;
  while (kept < ready_.size() && ready_[kept].begin() < at.moves) ++kept;
  if (kept == ready_.size()) return;
  const Part first = ready_[kept];  // of those that are dropped
  size_t back = first.of->in_path - first.number;
  std::optional<BeamMove> instead;
  if (first.number > 0 && is_straight(first.of->move)) {
    back = 1;
    instead = first_parts(first.of->move, first.move.from, first.number, first.of->parts);
  }
  for (size_t i = kept + 1; i < ready_.size(); ++i) {
    if (ready_[i].of != ready_[i - 1].of) back += ready_[i].of->in_path;
  }
  ready_stroke_->cut_back(world, back, instead);
  size_ -= ready_.size() - kept;
  ready_.erase(ready_.begin() + static_cast<std::ptrdiff_t>(kept), ready_.end());
}

// Keeps the part of a move before the end of its stroke. Returns true if the move extends beyond it.
bool BeamQueue::stop_move(Entry& move, double moves, std::deque<Entry>& kept) {
  const double left = moves - static_cast<double>(move.number);
  size_ -= move.count;
  if (left <= 0) return true;
  move.share = std::min(move.share, left);
  move.count = parts_of(move.share, move.count);
  size_ += move.count;
  kept.push_back(std::move(move));
  return left < 1;
}

void BeamQueue::stop_ticks(Entry ticks, Ticks on, std::deque<Entry>& kept) {
  KERF_ASSERT(on <= ticks.count);
  const Ticks off = ticks.count - on;
  Entry dark = ticks;
  dark.stroke = nullptr;
  dark.count = off;
  ticks.count = on;
  if (on > 0) kept.push_back(std::move(ticks));
  if (off > 0) kept.push_back(std::move(dark));
}

void BeamQueue::stop(size_t step, StopStroke at, const World& world) {
  at.moves = std::max(at.moves, 1.0);
  const StopStroke before = reached(step);
  double moves = before.moves;
  Ticks on = at.ticks - (at.moves > before.moves ? 0 : std::min(at.ticks, before.ticks));
  if (!ready_.empty() && ready_step_ == step) {
    stop_begun(at, world);
    if (!ready_.empty()) moves = ready_.back().end();
  }
  std::deque<Entry> kept;
  for (Entry& e : std::exchange(entries_, {})) {
    if (e.step != step) {
      kept.push_back(std::move(e));
    } else if (e.kind == Kind::kMove) {
      moves = stop_move(e, at.moves, kept) ? at.moves : static_cast<double>(e.number + 1);
    } else if (e.kind == Kind::kTicks && e.stroke && moves >= at.moves) {
      const Ticks ticks = std::min<Ticks>(on, e.count);
      on -= ticks;
      stop_ticks(std::move(e), ticks, kept);
    } else {
      kept.push_back(std::move(e));
    }
  }
  entries_ = std::move(kept);
}

void BeamQueue::pop_moves(size_t count) {
  KERF_ASSERT(count <= ready_.size());
  if (count == 0) return;
  reached_ = {ready_[count - 1].end()};
  reached_step_ = ready_step_;
  ready_.erase(ready_.begin(), ready_.begin() + static_cast<std::ptrdiff_t>(count));
  size_ -= count;
}

void BeamQueue::pop(size_t count) {
  KERF_ASSERT(!empty() && front_kind() != Kind::kMove);
  Entry& front = entries_.front();
  KERF_ASSERT(count <= front.count && (front.in_time() || !unfinished_rim_.begun()));
  if (front.kind == Kind::kTicks && front.stroke) {
    if (reached_step_ != front.step) reached_ = {};
    reached_step_ = front.step;
    reached_.ticks += count;
  }
  size_ -= count;
  (front.in_time() ? in_time_ : rims_) -= count;
  front.count -= count;
  if (front.count == 0) entries_.pop_front();
}

template <typename Drops>
void BeamQueue::drop_if(size_t step, Drops drops) {
  if (!ready_.empty() && ready_step_ == step) {
    size_ -= ready_.size();
    ready_.clear();
    unfinished_ = UnfinishedMove{};
  }
  if (!empty() && front_step() == step) unfinished_rim_ = UnfinishedRim{};
  if (reached_step_ == step) reached_ = {};
  std::erase_if(entries_, [&](const Entry& e) {
    const bool gone = e.step == step && drops(e);
    size_ -= gone ? e.count : 0;
    in_time_ -= gone && e.in_time() ? e.count : 0;
    rims_ -= gone && e.kind == Kind::kRim ? 1 : 0;
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
