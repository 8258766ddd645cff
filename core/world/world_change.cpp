#include <algorithm>
#include <iterator>
#include <utility>

#include "core/world/world.h"

namespace kerf {

namespace {

void begin(Body& body) {
  body.mesh.begin_change();
  body.tree.begin_change();
  body.refinement.begin_change();
  body.pieces.begin_change();
  body.components.left.begin_change();
}

bool same_place(const Placement& a, const Placement& b) {
  return a.position == b.position && a.orientation == b.orientation;
}

}  // namespace

void World::BodyChange::end(Body& body) {
  mesh = body.mesh.end_change();
  tree = body.tree.end_change();
  refinement = body.refinement.end_change();
  pieces = body.pieces.end_change();
  components = body.components.left.end_change();
}

bool World::BodyChange::any(const Body& body) const {
  return name != body.name || hidden != body.hidden || !same_place(placement, body.placement) || mesh.any() ||
         tree.any() || refinement.any() || pieces.any() || components.any();
}

void World::BodyChange::exchange(Body& body) {
  std::swap(name, body.name);
  std::swap(placement, body.placement);
  std::swap(hidden, body.hidden);
  body.mesh.exchange(mesh);
  body.tree.exchange(tree);
  body.refinement.exchange(refinement);
  body.pieces.exchange(pieces);
  body.components.left.exchange(components);
  body.separation = SeparationState();
}

void World::BodyChange::restore(Body& body) const {
  body.name = name;
  body.placement = placement;
  body.hidden = hidden;
  body.mesh.restore(mesh);
  body.tree.restore(tree);
  body.refinement.restore(refinement);
  body.pieces.restore(pieces);
  body.components.left.restore(components);
  body.separation = SeparationState();
}

size_t World::BodyChange::bytes() const {
  return mesh.bytes() + tree.bytes() + refinement.bytes() + pieces.bytes() + components.bytes();
}

size_t World::Change::bytes() const {
  size_t bytes = 0;
  for (const BodyChange& c : edited_) bytes += c.bytes();
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
    remembered_->edited_.emplace_back(s, slots_[s].body);
    begin(slots_[s].body);
  }
}

// A body that goes is kept as it was before the command.
void World::remove(BodyId id) {
  if (!contains(id)) return;
  Slot& slot = slots_[id.slot];
  if (remembered_ && id.slot < remembered_->slots_) {
    const auto edited = std::find_if(remembered_->edited_.begin(), remembered_->edited_.end(),
                                     [&](const BodyChange& c) { return c.slot == id.slot; });
    edited->end(slot.body);
    edited->exchange(slot.body);
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
  for (BodyChange& c : change.edited_) c.end(slots_[c.slot].body);
  std::erase_if(change.edited_, [&](const BodyChange& c) { return !c.any(slots_[c.slot].body); });
  return change;
}

void World::exchange(Change& change) {
  for (BodyChange& c : change.edited_) c.exchange(slots_[c.slot].body);
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
  for (const BodyChange& c : change.edited_) c.restore(slots_[c.slot].body);
}

}  // namespace kerf
