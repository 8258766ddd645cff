#include "core/physics/contact_search.h"

#include <algorithm>
#include <numeric>

#include "core/base/assert.h"
#include "core/base/parallel.h"
#include "core/physics/contact/narrow_phase.h"
#include "core/physics/contact/penetration.h"
#include "core/physics/contact/point_contacts.h"

namespace kerf {

namespace {

int widest_axis(std::span<const MovingBody> bodies) {
  Box corners;
  for (const MovingBody& b : bodies) corners.add(b.bounds.min);
  return corners.widest_axis();
}

// Returns true if the bounds of one body on its way overlap those of another in the frame of the other:
// tilted sheets have small bounds in their own frames and large ones in the world. Either may move or stay.
bool meets_in_frame_of(const MovingBody& other, const MovingBody& b) {
  KERF_ASSERT(other.margin >= 0 && b.margin >= 0);
  Box way;
  for (const RigidMap* to : {&other.now, &other.next}) {
    for (const RigidMap* from : {&b.now, &b.next}) way.add(moved(into(*to, *from), b.collider->bounds));
  }
  return way.wider(std::min(other.margin, b.margin)).overlaps(other.collider->bounds);
}

bool can_touch(const MovingBody& a, const MovingBody& b) {
  return (a.moves() || b.moves()) && !(a.passes_fixed && b.fixed) && !(b.passes_fixed && a.fixed);
}

bool are_near(const MovingBody& a, const MovingBody& b) {
  return can_touch(a, b) && a.bounds.overlaps(b.bounds) && meets_in_frame_of(a, b) && meets_in_frame_of(b, a);
}

}  // namespace

std::vector<std::pair<uint32_t, uint32_t>> near_pairs(std::span<const MovingBody> bodies) {
  std::vector<std::pair<uint32_t, uint32_t>> pairs;
  if (bodies.empty()) return pairs;
  const int axis = widest_axis(bodies);
  std::vector<uint32_t> order(bodies.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    return bodies[a].bounds.min[axis] < bodies[b].bounds.min[axis];
  });
  for (size_t i = 0; i < order.size(); ++i) {
    const MovingBody& a = bodies[order[i]];
    for (size_t j = i + 1; j < order.size() && bodies[order[j]].bounds.min[axis] <= a.bounds.max[axis]; ++j) {
      if (are_near(a, bodies[order[j]])) pairs.push_back(std::minmax(order[i], order[j]));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

namespace {

constexpr size_t kPairsAtATime = 4;  // pairs per task of a thread

std::pair<uint32_t, uint32_t> key(const TouchingPair& p) { return {p.first, p.second}; }

const PairMemory* memory_of(const ContactMemory& memory, BodyId first, BodyId second) {
  const auto at = std::ranges::lower_bound(memory, std::pair(first, second), {}, &PairMemory::bodies);
  return at != memory.end() && at->bodies() == std::pair(first, second) ? &*at : nullptr;
}

}  // namespace

TouchingPair ContactSearch::start(uint32_t first, uint32_t second) const {
  KERF_ASSERT(first < second && first < bodies_.size());
  KERF_ASSERT(second < bodies_.size() || second == TouchingPair::kGround);
  const BodyId a = bodies_[first].id, b = second == TouchingPair::kGround ? BodyId{} : bodies_[second].id;
  const PairMemory* old = memory_of(before_, a, b);
  TouchingPair pair{first, second, {}, old ? *old : PairMemory{a, b, {}, {}, {}}};
  if (pair.memory.held > 0) --pair.memory.held;
  if (second != TouchingPair::kGround && (!old || old->crossed))
    pair.memory.crossed = sheets_cross(bodies_[first], bodies_[second]) ? pair.memory.crossed + 1 : 0;
  return pair;
}

const TouchingPair* ContactSearch::find(uint32_t first, uint32_t second) const {
  const auto at = std::ranges::lower_bound(pairs_, std::pair(first, second), {}, key);
  return at != pairs_.end() && key(*at) == std::pair(first, second) ? &*at : nullptr;
}

TouchingPair& ContactSearch::pair_of(uint32_t first, uint32_t second) {
  KERF_ASSERT(first < second && second < bodies_.size());
  const auto at = std::ranges::lower_bound(pairs_, std::pair(first, second), {}, key);
  if (at != pairs_.end() && key(*at) == std::pair(first, second)) return *at;
  return *pairs_.insert(at, start(first, second));
}

void ContactSearch::find() {
  KERF_ASSERT(std::is_sorted(bodies_.begin(), bodies_.end(),
                             [](const MovingBody& a, const MovingBody& b) { return a.id < b.id; }));
  std::vector<TouchingPair> found = pairs_to_test();
  for_each_range(found.size(), kPairsAtATime, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) look_at(found[i]);
  });
  std::erase_if(
      found, [](const TouchingPair& p) { return p.second == TouchingPair::kGround && p.contacts.empty(); });
  const auto known = static_cast<ptrdiff_t>(pairs_.size());
  pairs_.insert(pairs_.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
  std::ranges::inplace_merge(pairs_, pairs_.begin() + known, {}, key);
}

std::vector<TouchingPair> ContactSearch::pairs_to_test() {
  const std::vector<std::pair<uint32_t, uint32_t>> near = near_pairs(bodies_);
  candidates_ += near.size();
  std::vector<TouchingPair> pairs;
  auto next = near.begin();
  for (uint32_t i = 0; i < bodies_.size(); ++i) {
    for (; next != near.end() && next->first == i; ++next) {
      if (!find(i, next->second) && !are_joined(joints_, i, next->second))
        pairs.push_back({i, next->second, {}, {}});
    }
    if (bodies_[i].moves() && !find(i, TouchingPair::kGround))
      pairs.push_back({i, TouchingPair::kGround, {}, {}});
  }
  return pairs;
}

void ContactSearch::look_at(TouchingPair& pair) const {
  pair = start(pair.first, pair.second);
  const MovingBody& first = bodies_[pair.first];
  pair.contacts = pair.second == TouchingPair::kGround
                      ? find_ground_contacts(first, around_, kContactLengths, pair.memory)
                      : find_contacts(first, bodies_[pair.second], kContactLengths, pair.memory);
}

std::vector<std::pair<uint32_t, uint32_t>> ContactSearch::pairs_apart() const {
  std::vector<std::pair<uint32_t, uint32_t>> pairs = near_pairs(bodies_);
  std::erase_if(pairs, [&](const std::pair<uint32_t, uint32_t>& p) {
    const TouchingPair* pair = find(p.first, p.second);
    return (pair && pair->memory.crossed > 0) || are_joined(joints_, p.first, p.second);
  });
  return pairs;
}

std::vector<uint8_t> ContactSearch::remember_piercing(std::span<const std::pair<uint32_t, uint32_t>> pairs) {
  for (const auto& [first, second] : pairs) pair_of(first, second);
  std::vector<uint8_t> any_new(pairs.size());
  for_each_range(pairs.size(), kPairsAtATime, [&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p) any_new[p] = remember_piercing(pairs[p].first, pairs[p].second);
  });
  return any_new;
}

bool ContactSearch::remember_piercing(uint32_t first, uint32_t second) {
  PairMemory& memory = pair_of(first, second).memory;
  const MovingBody &a = bodies_[first], &b = bodies_[second];
  const bool of_first = remember_piercing_points(a, b, memory.points_of_first);
  const bool of_second = remember_piercing_points(b, a, memory.points_of_second);
  remember_passing_guards(a, b, memory.points_of_first);
  remember_passing_guards(b, a, memory.points_of_second);
  const bool held_before = memory.held > 0;
  memory.held = 2;
  return (of_first || of_second) && !held_before;
}

}  // namespace kerf
