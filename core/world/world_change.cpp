#include <algorithm>
#include <iterator>
#include <utility>

#include "core/world/world.h"

namespace kerf {

size_t World::Change::bytes() const {
  size_t bytes = 0;
  for (const BodyChange& c : edited_) bytes += c.parts.bytes();
  for (const auto& [slot, other] : removed_) bytes += other.body.bytes();
  for (const Slot& slot : added_) bytes += slot.body.bytes();
  return bytes;
}

World::World() = default;
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::World(const World& other) : slots_(other.slots_) {}
World& World::operator=(const World& other) {
  slots_ = other.slots_;
  remembered_.reset();
  return *this;
}

void World::begin_change() {
  remembered_ = std::make_unique<Change>();
  remembered_->slots_ = slots_.size();
  for (uint32_t s = 0; s < slots_.size(); ++s) {
    if (!slots_[s].alive) continue;
    remembered_->edited_.emplace_back(BodyChange{s, {}}).parts.begin(slots_[s].body);
  }
}

// A body that goes is kept as it was before the command.
void World::remove(BodyId id) {
  if (!contains(id)) return;
  Slot& slot = slots_[id.slot];
  if (remembered_ && id.slot < remembered_->slots_) {
    const auto edited = std::find_if(remembered_->edited_.begin(), remembered_->edited_.end(),
                                     [&](const BodyChange& c) { return c.slot == id.slot; });
    edited->parts.end(slot.body);
    edited->parts.exchange(slot.body);
    remembered_->edited_.erase(edited);
    remembered_->removed_.emplace_back(id.slot, std::move(slot));
  }
  slot.body = Body{};
  slot.alive = false;
  slot.generation = id.generation + 1;
}

World::Change World::end_change() {
  Change change = std::move(*remembered_);
  remembered_.reset();
  change.slots_differ_ = change.slots_ != slots_.size();
  for (BodyChange& c : change.edited_) c.parts.end(slots_[c.slot].body);
  std::erase_if(change.edited_, [&](const BodyChange& c) { return !c.parts.any(); });
  return change;
}

void World::exchange(Change& change) {
  for (BodyChange& c : change.edited_) c.parts.exchange(slots_[c.slot].body);
  for (auto& [slot, other] : change.removed_) std::swap(slots_[slot], other);
  const size_t slots = slots_.size();
  if (change.slots_ < slots) {
    const auto first = slots_.begin() + static_cast<std::ptrdiff_t>(change.slots_);
    change.added_.assign(std::make_move_iterator(first), std::make_move_iterator(slots_.end()));
    slots_.erase(first, slots_.end());
  } else {
    slots_.insert(slots_.end(), std::make_move_iterator(change.added_.begin()),
                  std::make_move_iterator(change.added_.end()));
    change.added_.clear();
  }
  change.slots_ = slots;
}

void World::restore(const Change& change) {
  for (const BodyChange& c : change.edited_) c.parts.restore(slots_[c.slot].body);
}

}  // namespace kerf
