#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/assert.h"
#include "core/heat/heat_memory.h"
#include "core/world/world.h"

namespace kerf {

size_t World::Change::bytes() const {
  size_t bytes = 0;
  for (const BodyChange& c : edited_) bytes += c.parts.bytes();
  for (const auto& [home, body] : removed_) bytes += body.bytes();
  for (const Slot& slot : added_) bytes += slot.body.bytes();
  return bytes;
}

void World::BodyChange::exchange(Body& body) {
  std::vector<FaceId> faces;
  parts.part<Mesh>().append_faces(body.mesh, faces);
  parts.exchange(body);
  body.tree.update(body.mesh, std::move(faces));
}

void World::BodyChange::restore(Body& body) const {
  std::vector<FaceId> faces;
  parts.part<Mesh>().append_faces(body.mesh, faces);
  parts.restore(body);
  body.tree.update(body.mesh, std::move(faces));
}

World::World() = default;
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::World(const World& other) : slots_(other.slots_), situation_(other.situation_) {}
World& World::operator=(const World& other) {
  slots_ = other.slots_;
  situation_ = other.situation_;
  remembered_.reset();
  return *this;
}

void World::begin_change() {
  remembered_ = std::make_unique<Change>();
  remembered_->situation_.begin(situation_);
  remembered_->slots_ = slots_.size();
  for (uint32_t s = 0; s < slots_.size(); ++s) {
    if (!slots_[s].alive) continue;
    remembered_->edited_.emplace_back(BodyChange{s, s, {}}).parts.begin(slots_[s].body);
  }
}

// Keeps the body of a slot as it was before the command; one that the command itself made is let go.
void World::Change::keep(uint32_t slot, Body& body) {
  const auto edited =
      std::find_if(edited_.begin(), edited_.end(), [&](const BodyChange& c) { return c.slot == slot; });
  if (edited != edited_.end()) {
    edited->parts.end(body);
    edited->exchange(body);
    removed_.emplace_back(edited->home, std::move(body));
    edited_.erase(edited);
  }
  if (slot < slots_) died_.push_back(slot);
}

void World::remove(BodyId id) {
  Slot& slot = slots_[checked(id)];
  if (remembered_) remembered_->keep(id.slot, slot.body);
  slot.body = Body{};
  slot.alive = false;
}

void World::exchange_bodies(BodyId a, BodyId b) {
  KERF_ASSERT(contains(a) && contains(b) && a != b);
  swap_slots(a.slot, b.slot);
}

void World::swap_slots(uint32_t a, uint32_t b) {
  std::swap(slots_[a].body, slots_[b].body);
  if (!remembered_) return;
  remembered_->exchanged_.emplace_back(a, b);
  for (BodyChange& c : remembered_->edited_) {
    if (c.slot == a || c.slot == b) c.slot = a + b - c.slot;
  }
}

World::Change World::end_change() {
  Change change = std::move(*remembered_);
  remembered_.reset();
  change.situation_.end(situation_);
  change.slots_end_ = slots_.size();
  for (BodyChange& c : change.edited_) c.parts.end(slots_[c.slot].body);
  std::erase_if(change.edited_, [&](const BodyChange& c) { return !c.parts.any(); });
  return change;
}

void World::exchange(Change& change) {
  change.situation_.exchange(situation_);
  change.taken_back_ ? bring_again(change) : take_back(change);
  change.taken_back_ = !change.taken_back_;
}

void World::take_back(Change& change) {
  for (BodyChange& c : change.edited_) c.exchange(slots_[c.slot].body);
  for (size_t i = change.exchanged_.size(); i-- > 0;)
    std::swap(slots_[change.exchanged_[i].first].body, slots_[change.exchanged_[i].second].body);
  for (auto& [home, body] : change.removed_) std::swap(slots_[home].body, body);
  for (const uint32_t slot : change.died_) slots_[slot].alive = true;
  const auto first = slots_.begin() + static_cast<std::ptrdiff_t>(change.slots_);
  change.added_.assign(std::make_move_iterator(first), std::make_move_iterator(slots_.end()));
  slots_.erase(first, slots_.end());
}

// Makes the steps of take_back() in the opposite order.
void World::bring_again(Change& change) {
  KERF_ASSERT(slots_.size() == change.slots_);
  slots_.insert(slots_.end(), std::make_move_iterator(change.added_.begin()),
                std::make_move_iterator(change.added_.end()));
  change.added_.clear();
  for (const uint32_t slot : change.died_) slots_[slot].alive = false;
  for (auto& [home, body] : change.removed_) std::swap(slots_[home].body, body);
  for (const auto& [a, b] : change.exchanged_) std::swap(slots_[a].body, slots_[b].body);
  for (BodyChange& c : change.edited_) c.exchange(slots_[c.slot].body);
}

// A slot whose body the change removed holds the image of another for a while, if the two were exchanged.
void World::restore(const Change& change, size_t slots) {
  KERF_ASSERT(!change.taken_back_ && slots <= change.slots_);
  KERF_ASSERT(change.died_.empty() || *std::min_element(change.died_.begin(), change.died_.end()) >= slots);
  change.situation_.restore(situation_);
  for (const BodyChange& c : change.edited_) c.restore(slots_[c.slot].body);
  for (size_t i = change.exchanged_.size(); i-- > 0;)
    swap_slots(change.exchanged_[i].first, change.exchanged_[i].second);
  for (auto slot = static_cast<uint32_t>(change.slots_); slot < change.slots_end_; ++slot) {
    if (slots_[slot].alive) remove({slot, slots_[slot].generation});
  }
}

}  // namespace kerf
