#include "core/world/world.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

#include "core/base/assert.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/heat/conduction_solver.h"
#include "core/mesh/face_batches.h"
#include "core/mesh/looks.h"

namespace kerf {

namespace {

AreaMoments moments_of(const Mesh& mesh, const Vec3& origin) {
  constexpr size_t kSlots = 1 << 16;  // a range
  std::vector<AreaMoments> sums(range_count(mesh.face_slots(), kSlots));
  for_each_range(mesh.face_slots(), kSlots, [&](size_t first, size_t end) {
    AreaMoments sum;
    for_each_triangle(mesh, first, end,
                      [&](FaceId, const Triangle& t) { sum += area_moments(t, triangle_area(t), origin); });
    sums[first / kSlots] = sum;
  });
  AreaMoments whole;
  for (const AreaMoments& sum : sums) whole += sum;
  return whole;
}

struct GrowingBounds {
  World::Bounds all;
  bool any = false;

  void add(const Placement& placement, const Vec3& min, const Vec3& max) {
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p = placement.to_world(
          {corner & 1 ? max.x : min.x, corner & 2 ? max.y : min.y, corner & 4 ? max.z : min.z});
      all.min = any ? glm::min(all.min, p) : p;
      all.max = any ? glm::max(all.max, p) : p;
      any = true;
    }
  }
};

constexpr uint64_t kClockSeed = 0x9d5c'b07a'63e1'42f8u, kMotionSeed = 0x3c81'6f2e'b9d4'0a57u,
                   kHeatSeed = 0x51f3'8ad9'2e67'c40bu, kSolidSeed = 0xb27d'40c9'581e'f36au;

uint64_t hash_of(uint64_t seed, const Vec3& p) {
  for (int k = 0; k < 3; ++k) seed = hash_combine(seed, number_bits(p[k]));
  return seed;
}

uint64_t face_hash(const Body& body, uint64_t seed, FaceId f, const Triangle& t) {
  int least = 0;
  for (int i = 1; i < 3; ++i) {
    if (lexicographic_less(t[i], t[least])) least = i;
  }
  uint64_t h = hash_combine(seed, body.mesh.data(f).halvings);
  for (int i = 0; i < 3; ++i) h = hash_of(h, t[(least + i) % 3]);
  const double energy = body.heat.energy_of(body.mesh, f);
  return energy == 0 ? h : hash_combine(hash_combine(h, kHeatSeed), number_bits(energy));
}

uint64_t sum_of_face_hashes(const Body& body, uint64_t seed) {
  constexpr size_t kSlots = 1 << 14;  // a range
  std::vector<uint64_t> sums(range_count(body.mesh.face_slots(), kSlots));
  for_each_range(body.mesh.face_slots(), kSlots, [&](size_t first, size_t end) {
    uint64_t sum = 0;
    for_each_triangle(body.mesh, first, end,
                      [&](FaceId f, const Triangle& t) { sum += face_hash(body, seed, f, t); });
    sums[first / kSlots] = sum;
  });
  return std::accumulate(sums.begin(), sums.end(), uint64_t{0});
}

uint64_t motion_hash(uint64_t seed, const Motion& motion) {
  const uint64_t h = hash_of(hash_of(hash_combine(seed, kMotionSeed), motion.velocity), motion.spin);
  return hash_combine(hash_combine(h, motion.quiet), motion.asleep ? 1 : 0);
}

// Conducts heat in a body for a time (s). Returns the energy that it loses to the environment (J).
double lost_heat(World& world, BodyId id, double seconds) {
  Body& body = world.body(id);
  if (seconds <= 0 || body.mesh.columns().blank()) return 0;
  return conduct(body.mesh, body.heat, body.sheet.substance, body.sheet.thickness, HeatLoss{}, seconds,
                 world.heat_memory());
}

// Takes a time (s), or what remains of it, from that which strokes have simulated ahead of the clock.
double skip_ahead(World& world, double seconds) {
  const double done = std::min(seconds, world.energy().ahead);
  if (done > 0) world.edit_energy().ahead -= done;
  return done;
}

void flow(World& world, double seconds) {
  for (const BodyId id : world.ids()) step_heat(world, id, seconds);
}

}  // namespace

Result<Body> make_body(std::string name, BuiltMesh built, const Progress* progress) {
  const bool one = built.report.components <= 1;
  ProgressShares shares(progress);
  const Progress building = shares.next(one ? 1 : 0.83), counting = shares.next(one ? 0 : 0.17);
  Body body;
  body.name = std::move(name);
  body.mesh = std::move(built.mesh);
  body.heat = FaceHeat::attach(body.mesh);
  body.walls = WallFaces::attach(body.mesh);
  if (const Status s = unpack(AabbTree::build(body.mesh, &building), body.tree); !s) return s.error();
  auto components = count_components(body.mesh, built.report.components, &counting);
  if (const Status s = unpack(std::move(components), body.components); !s) return s.error();
  body.material_names = std::move(built.material_names);
  body.named_parts = std::move(built.parts);
  body.looks = std::move(built.looks);
  body.loaded = std::move(built.report);
  body.pieces.push_back({{body.loaded.faces, body.loaded.area}, moments_of(body.mesh, body.middle())});
  return body;
}

Body make_body(std::string name, BuiltMesh built) {
  return std::move(*make_body(std::move(name), std::move(built), nullptr));
}

uint32_t Body::label(FaceId f) const {
  const uint32_t to_be = separation.search.label_to_be(f);
  return to_be != 0 ? to_be : mesh.data(f).piece;
}

std::string Body::name_of(uint32_t label) const {
  if (const auto given = piece_names.find(label); given != piece_names.end()) return given->second;
  return label == named ? name : name + " " + std::to_string(label);
}

std::string Body::own_name() const {
  uint32_t only = 0, count = 0;
  for (uint32_t label = 0; label < pieces.size(); ++label) {
    if (pieces[label].faces == 0) continue;
    only = label;
    ++count;
  }
  return count == 1 ? name_of(only) : name;
}

FaceId Body::loaded_source(FaceId f) const {
  if (walls.contain(mesh, f)) return {};
  const FaceId base = mesh.data(f).base;
  return loaded_faces.empty() || base.index < loaded_faces.size() ? loaded_face(base) : FaceId();
}

std::vector<FaceId> Body::faces_of(uint32_t piece, bool of_piece) const {
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    const FaceId face(f);
    if (mesh.is_live(face) && (mesh.data(face).piece == piece) == of_piece) faces.push_back(face);
  }
  return faces;
}

const FaceCounts& Body::whole_of(FaceId f) const {
  const uint32_t own = label(f), component = components.at_home(loaded_base(f), own);
  if (component != LoadedComponents::kNone) return components.left[component];
  return own == 0 ? pieces[own] : pieces[own].cut_off;
}

FaceCounts& Body::edit_whole_of(FaceId f) {
  const uint32_t own = label(f), component = components.at_home(loaded_base(f), own);
  if (component != LoadedComponents::kNone) return components.left.edit(component);
  return own == 0 ? pieces.edit(own) : pieces.edit(own).cut_off;
}

void Body::count(FaceId f, int faces, double area) {
  const auto add = [&](auto& counts) {
    counts.faces += static_cast<size_t>(faces);
    counts.area += area;
  };
  FaceCounts &piece = pieces.edit(label(f)), &whole = edit_whole_of(f);
  KERF_ASSERT(faces >= 0 || piece.faces >= static_cast<size_t>(-faces));
  add(piece);
  if (&whole != &piece) add(whole);
  OpenSearch& search = separation.search;
  if (search.stage == OpenSearch::Stage::kGrow && (search.mark.get(f.index) & OpenSearch::kVisited) != 0)
    add(*search.front_of(f));
}

size_t Body::bytes() const { return ChangeOfParts<Body>::bytes_of(*this); }

BodyId World::add(Body body, uint32_t generation) {
  const auto slot = static_cast<uint32_t>(slots_.size());
  body.number = slot;
  if (!body.loaded_as.valid()) body.loaded_as = {slot, generation};
  slots_.push_back({std::move(body), generation, true});
  return {slot, generation};
}

std::vector<BodyId> World::ids() const {
  std::vector<BodyId> ids;
  for (uint32_t s = 0; s < slots_.size(); ++s) {
    if (slots_[s].alive) ids.push_back({s, slots_[s].generation});
  }
  return ids;
}

World::Bounds World::bounds() const {
  GrowingBounds bounds;
  for (const Slot& slot : slots_) {
    if (!slot.alive || slot.body.tree.leaf_count() == 0) continue;
    const Bounds& own = slot.body.bounds();
    bounds.add(slot.body.placement, own.min, own.max);
  }
  return bounds.all;
}

World::Bounds World::loaded_bounds() const {
  GrowingBounds bounds;
  for (const Slot& slot : slots_) {
    if (slot.alive) bounds.add(slot.body.placement, slot.body.loaded.min, slot.body.loaded.max);
  }
  return bounds.all;
}

size_t World::live_faces() const {
  size_t faces = 0;
  for (const Slot& slot : slots_) faces += slot.alive ? slot.body.mesh.live_faces() : 0;
  return faces;
}

size_t World::face_slots() const {
  size_t slots = 0;
  for (const Slot& slot : slots_) slots += slot.alive ? slot.body.mesh.face_slots() : 0;
  return slots;
}

size_t World::live_pieces() const {
  size_t pieces = 0;
  for (const Slot& slot : slots_) {
    const Records<Piece>& own = slot.body.pieces;
    for (uint32_t p = 0; slot.alive && p < own.size(); ++p) pieces += own[p].faces > 0;
  }
  return pieces;
}

HeatMemory& World::heat_memory() {
  if (!heat_memory_) heat_memory_ = std::make_unique<HeatMemory>();
  return *heat_memory_;
}

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
  first_editable_ = 0;
  return *this;
}

void World::begin_change(bool only_adds) {
  KERF_ASSERT(remembered_ == nullptr);
  remembered_ = std::make_unique<Change>();
  remembered_->situation_.begin(situation_);
  remembered_->slots_ = slots_.size();
  if (only_adds) {
    first_editable_ = slots_.size();
    return;
  }
  for (uint32_t s = 0; s < slots_.size(); ++s) {
    if (!slots_[s].alive) continue;
    remembered_->edited_.emplace_back(BodyChange{s, s, {}}).parts.begin(slots_[s].body);
  }
}

// Saves the body of a slot in its state before the command; discards one that the command itself made.
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
  KERF_ASSERT(remembered_ != nullptr);
  Change change = std::move(*remembered_);
  remembered_.reset();
  first_editable_ = 0;
  change.situation_.end(situation_);
  change.slots_end_ = slots_.size();
  for (BodyChange& c : change.edited_) c.parts.end(slots_[c.slot].body);
  std::erase_if(change.edited_, [&](const BodyChange& c) { return !c.parts.any(); });
  return change;
}

void World::exchange(Change& change) {
  KERF_ASSERT(remembered_ == nullptr);
  change.situation_.exchange(situation_);
  change.is_undone_ ? redo(change) : undo(change);
  change.is_undone_ = !change.is_undone_;
}

void World::undo(Change& change) {
  KERF_ASSERT(slots_.size() == change.slots_end_);
  for (BodyChange& c : change.edited_) c.exchange(slots_[c.slot].body);
  for (size_t i = change.exchanged_.size(); i-- > 0;)
    std::swap(slots_[change.exchanged_[i].first].body, slots_[change.exchanged_[i].second].body);
  for (auto& [home, body] : change.removed_) std::swap(slots_[home].body, body);
  for (const uint32_t slot : change.died_) slots_[slot].alive = true;
  const auto first = slots_.begin() + static_cast<std::ptrdiff_t>(change.slots_);
  change.added_.assign(std::make_move_iterator(first), std::make_move_iterator(slots_.end()));
  slots_.erase(first, slots_.end());
}

// Applies the steps of undo() in reverse order.
void World::redo(Change& change) {
  KERF_ASSERT(slots_.size() == change.slots_);
  slots_.insert(slots_.end(), std::make_move_iterator(change.added_.begin()),
                std::make_move_iterator(change.added_.end()));
  change.added_.clear();
  for (const uint32_t slot : change.died_) slots_[slot].alive = false;
  for (auto& [home, body] : change.removed_) std::swap(slots_[home].body, body);
  for (const auto& [a, b] : change.exchanged_) std::swap(slots_[a].body, slots_[b].body);
  for (BodyChange& c : change.edited_) c.exchange(slots_[c.slot].body);
}

// The slot of a removed body temporarily holds the image of another if the two were exchanged.
void World::restore(const Change& change, size_t slots) {
  KERF_ASSERT(!change.is_undone_ && slots <= change.slots_);
  KERF_ASSERT(change.died_.empty() || *std::min_element(change.died_.begin(), change.died_.end()) >= slots);
  change.situation_.restore(situation_);
  for (const BodyChange& c : change.edited_) c.restore(slots_[c.slot].body);
  for (size_t i = change.exchanged_.size(); i-- > 0;)
    swap_slots(change.exchanged_[i].first, change.exchanged_[i].second);
  for (auto slot = static_cast<uint32_t>(change.slots_); slot < change.slots_end_; ++slot) {
    if (slots_[slot].alive) remove({slot, slots_[slot].generation});
  }
}

uint64_t state_hash(const World& world) {
  std::vector<BodyId> ids = world.ids();
  std::sort(ids.begin(), ids.end(),
            [&](BodyId a, BodyId b) { return world.body(a).number < world.body(b).number; });
  uint64_t sum = 0, place_of_body = 0;
  for (const BodyId id : ids) {
    const Body& body = world.body(id);
    const uint64_t seed = mix64(++place_of_body);
    sum += sum_of_face_hashes(body, seed);
    const auto& q = body.placement.orientation;
    uint64_t place = hash_of(seed, body.placement.position);
    for (const double x : {q.w, q.x, q.y, q.z}) place = hash_combine(place, number_bits(x));
    sum += place;
    if (body.motion != Motion{}) sum += motion_hash(seed, body.motion);
    if (body.solid) sum += hash_combine(seed, kSolidSeed);
  }
  if (world.clock() != 0) sum += hash_combine(kClockSeed, world.clock());
  return sum;
}

std::optional<uint64_t> looks_hash(const World& world) {
  std::set<uint64_t> hashes;
  for (const BodyId id : world.ids()) {
    if (const auto& looks = world.body(id).looks) hashes.insert(looks->hash());
  }
  if (hashes.empty()) return std::nullopt;
  return std::accumulate(hashes.begin(), hashes.end(), uint64_t{0}, hash_combine);
}

void step_heat(World& world, BodyId id, double seconds) {
  KERF_ASSERT(seconds >= 0);
  if (const double lost = lost_heat(world, id, seconds); lost != 0) world.edit_energy().lost += lost;
}

void step_heat(World& world, double seconds) {
  flow(world, seconds);
  if (is_hot(world)) world.edit_energy().ahead += seconds;
}

void cool(World& world, double seconds) {
  KERF_ASSERT(seconds >= 0);
  flow(world, seconds - skip_ahead(world, seconds));
}

void cool_for_ticks(World& world, Ticks passed) {
  KERF_ASSERT(passed <= world.clock());
  const Ticks flows = world.clock() / kTicksOfFlow - (world.clock() - passed) / kTicksOfFlow;
  if (flows == 0) return;
  std::vector<double> times;
  for (Ticks i = 0; i < flows; ++i) {
    constexpr double kSeconds = static_cast<double>(kTicksOfFlow) / kTicksPerSecond;
    times.push_back(kSeconds - skip_ahead(world, kSeconds));
  }
  // Body by body, because the geometry of a body stays the same; the losses are summed in the order of time.
  const std::vector<BodyId> ids = world.ids();
  std::vector<std::vector<double>> lost(ids.size());
  for (size_t b = 0; b < ids.size(); ++b) {
    const KeptHeatGeometry kept(world.heat_memory());
    for (const double seconds : times) lost[b].push_back(lost_heat(world, ids[b], seconds));
  }
  for (size_t i = 0; i < times.size(); ++i) {
    for (size_t b = 0; b < ids.size(); ++b) {
      if (lost[b][i] != 0) world.edit_energy().lost += lost[b][i];
    }
  }
}

double ejected_energy(const World& world) {
  double ejected = world.energy().deleted;
  for (const BodyId id : world.ids()) ejected += world.body(id).ejected;
  return ejected;
}

bool is_hot(const World& world) {
  return std::ranges::any_of(world.ids(), [&](BodyId id) {
    const Body& body = world.body(id);
    return body.mesh.columns().any_set(body.heat.energy);
  });
}

}  // namespace kerf
