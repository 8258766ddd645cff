#include "core/shadow/shadow_volume.h"

#include <cstdlib>
#include <utility>

#include "core/base/assert.h"

namespace kerf {

int light_side(const std::array<glm::vec3, 3>& triangle, const LightPoint& light) {
  const Vec3 a(triangle[0]), b(triangle[1]), c(triangle[2]);
  const double side = glm::dot(glm::cross(b - a, c - a), light.xyz - a * light.w);
  return (side > 0) - (side < 0);
}

int8_t ShadowVolume::facing(const ShadowCaster& caster, uint32_t face) const {
  if (!caster.casts(face)) return 0;
  const LightPoint* light = &light_.light;
  if (!light_.pieces.empty()) {
    const uint32_t piece = caster.piece(face);
    if (piece < light_.pieces.size()) {
      if (!light_.pieces[piece]) return 0;
      light = &*light_.pieces[piece];
    }
  }
  return static_cast<int8_t>(light_side(caster.corners(face), *light));
}

int ShadowVolume::multiplicity(const ShadowCaster& caster, uint32_t edge) const {
  if (method_ == ShadowMethod::kRobust) {
    int sum = 0;
    caster.for_each_face_on(edge, [&](uint32_t face, int along) { sum += signs_[face] * along; });
    return sum;
  }
  // An edge that two polygons of a volume share does not belong to its silhouette, whatever their
  // orientation.
  int facing_sides = 0, facing_faces = 0, averted_sides = 0, averted_faces = 0;
  caster.for_each_face_on(edge, [&](uint32_t face, int along) {
    const int sign = signs_[face];
    (sign > 0 ? facing_sides : averted_sides) += sign * along;
    (sign > 0 ? facing_faces : averted_faces) += std::abs(sign);
  });
  const bool two = method_ == ShadowMethod::kPaperTwoVolumes;
  return (facing_faces == 1 ? facing_sides : 0) + (two && averted_faces == 1 ? averted_sides : 0);
}

void ShadowVolume::put(uint32_t edge, int multiplicity) {
  assert(edge < place_.size());
  uint32_t& place = place_[edge];
  if (multiplicity == 0) {
    if (place == kNone) return;
    assert(place < silhouette_.size() && silhouette_[place].edge == edge);
    touched_.places.push_back(place);
    silhouette_[place] = silhouette_.back();
    place_[silhouette_[place].edge] = place;
    silhouette_.pop_back();
    place = kNone;
    return;
  }
  if (place == kNone) {
    place = static_cast<uint32_t>(silhouette_.size());
    silhouette_.emplace_back();
  }
  silhouette_[place] = {edge, multiplicity};
  touched_.places.push_back(place);
}

void ShadowVolume::rebuild(const ShadowCaster& caster, LightOnBody light) {
  light_ = std::move(light);
  KERF_ASSERT(light_.light.w == 1 || (light_.light.w == 0 && light_.light.xyz != Vec3(0)));
  const uint32_t faces = caster.face_slots(), edges = caster.edge_slots();
  signs_.resize(faces);
  for (uint32_t f = 0; f < faces; ++f) signs_[f] = facing(caster, f);
  place_.assign(edges, kNone);
  silhouette_.clear();
  for (uint32_t e = 0; e < edges; ++e) {
    const int m = multiplicity(caster, e);
    if (m == 0) continue;
    place_[e] = static_cast<uint32_t>(silhouette_.size());
    silhouette_.push_back({e, m});
  }
  touched_ = {};
  effort_.faces += faces;
  effort_.edges += edges;
}

void ShadowVolume::follow(const ShadowCaster& caster, const ShadowCaster::Change& change) {
  KERF_ASSERT(signs_.size() <= caster.face_slots() && place_.size() <= caster.edge_slots());
  signs_.resize(caster.face_slots(), 0);
  place_.resize(caster.edge_slots(), kNone);
  for (const uint32_t f : change.faces) signs_[f] = facing(caster, f);
  for (const uint32_t e : change.edges) put(e, multiplicity(caster, e));
  effort_.faces += change.faces.size();
  effort_.edges += change.edges.size();
  if (!touched_.all) touched_.faces.insert(touched_.faces.end(), change.faces.begin(), change.faces.end());
}

ShadowVolume::Touched ShadowVolume::take_touched() {
  Touched touched = std::move(touched_);
  touched_ = {};
  touched_.all = false;
  return touched;
}

size_t ShadowVolume::bytes() const {
  return signs_.capacity() + silhouette_.capacity() * sizeof(SilhouetteEdge) +
         place_.capacity() * sizeof(uint32_t);
}

}  // namespace kerf
