#include "core/world/world.h"

#include "core/base/parallel.h"
#include "core/heat/heat_memory.h"
#include "core/mesh/triangle_batch.h"

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
  add(piece);
  if (&whole != &piece) add(whole);
  OpenSearch& search = separation.search;
  if (search.stage == OpenSearch::Stage::kGrow && (search.mark.get(f.index) & OpenSearch::kLookedAt) != 0)
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

namespace {

// Bounds that grow by boxes of bodies.
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

}  // namespace

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

}  // namespace kerf
