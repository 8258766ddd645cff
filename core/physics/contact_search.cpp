#include "core/physics/contact_search.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/physics/contact/broad_phase.h"
#include "core/physics/contact/chord_points.h"
#include "core/physics/contact/crossing_sheets.h"
#include "core/physics/contact/pair_contacts.h"

namespace kerf {

namespace {

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
  const std::vector<std::pair<uint32_t, uint32_t>> near = near_pairs(bodies_);
  candidates_ += near.size();
  std::vector<TouchingPair> found;  // sorted like `pairs_`: the ground comes after all bodies
  auto next = near.begin();
  for (uint32_t i = 0; i < bodies_.size(); ++i) {
    for (; next != near.end() && next->first == i; ++next) find_between(i, next->second, found);
    find_on_ground(i, found);
  }
  const auto known = static_cast<ptrdiff_t>(pairs_.size());
  pairs_.insert(pairs_.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
  std::ranges::inplace_merge(pairs_, pairs_.begin() + known, {}, key);
}

void ContactSearch::find_between(uint32_t first, uint32_t second, std::vector<TouchingPair>& found) const {
  if (find(first, second) || are_joined(joints_, first, second)) return;
  TouchingPair& pair = found.emplace_back(start(first, second));
  pair.contacts = find_contacts(bodies_[first], bodies_[second], kContactLengths, pair.memory);
}

void ContactSearch::find_on_ground(uint32_t i, std::vector<TouchingPair>& found) const {
  if (!bodies_[i].moves() || find(i, TouchingPair::kGround)) return;
  TouchingPair pair = start(i, TouchingPair::kGround);
  pair.contacts = find_ground_contacts(bodies_[i], around_, kContactLengths, pair.memory);
  if (!pair.contacts.empty()) found.push_back(std::move(pair));
}

std::vector<std::pair<uint32_t, uint32_t>> ContactSearch::pairs_apart() const {
  std::vector<std::pair<uint32_t, uint32_t>> pairs = near_pairs(bodies_);
  std::erase_if(pairs, [&](const std::pair<uint32_t, uint32_t>& p) {
    const TouchingPair* pair = find(p.first, p.second);
    return (pair && pair->memory.crossed > 0) || are_joined(joints_, p.first, p.second);
  });
  return pairs;
}

bool ContactSearch::were_apart(uint32_t first, uint32_t second) {
  PairMemory& memory = pair_of(first, second).memory;
  memory.crossed = sheets_cross(bodies_[first], bodies_[second]) ? 1 : 0;
  return memory.crossed == 0;
}

bool ContactSearch::remember_piercing(uint32_t first, uint32_t second) {
  PairMemory& memory = pair_of(first, second).memory;
  const bool of_first = remember_piercing_points(bodies_[first], bodies_[second], memory.points_of_first);
  const bool of_second = remember_piercing_points(bodies_[second], bodies_[first], memory.points_of_second);
  return of_first || of_second;
}

}  // namespace kerf
