#include "core/edit/cavities.h"

#include <limits>
#include <map>
#include <vector>

#include "core/base/assert.h"
#include "core/edit/separation.h"
#include "core/mesh/measures.h"

namespace kerf {

BodyDelta move_components(BodyId id, Body& body, const std::map<uint32_t, uint32_t>& label_of) {
  KERF_ASSERT(is_settled(body));
  BodyDelta delta;
  delta.body = id;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const FaceId base = body.loaded_base(FaceId(f));
    const auto label = label_of.find(body.components.of(base));
    if (label == label_of.end()) continue;
    const uint32_t own = body.mesh.data(FaceId(f)).piece;
    const bool is_at_home = body.components.at_home(base, own) != LoadedComponents::kNone;
    KERF_ASSERT(is_at_home || own != label->second);
    if (!is_at_home) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    const AreaMoments moments = area_moments(t, triangle_area(t), body.middle());
    while (body.pieces.size() <= label->second) {
      delta.new_pieces.push_back(body.pieces.size());
      body.pieces.push_back({});
    }
    body.edit_piece_of(FaceId(f)).moments -= moments;
    body.mesh.edit_data(FaceId(f)).piece = label->second;
    body.edit_piece_of(FaceId(f)).moments += moments;
    delta.relabelled.push_back(FaceId(f));
  }
  for (const auto& [component, label] : label_of) {
    const FaceCounts counts = body.components.left[component];
    Piece &from = body.pieces.edit(body.components.home[component]), &to = body.pieces.edit(label);
    from.faces -= counts.faces;
    from.area -= counts.area;
    to.faces += counts.faces;
    to.area += counts.area;
    body.components.home.edit(component) = label;
  }
  return delta;
}

namespace {

struct Enclosed {
  double volume = 0;  // m^3, signed
  FaceId lowest;
};

// Returns by component the volume that its faces at home enclose.
std::vector<Enclosed> components_of(const Body& body) {
  std::vector<Enclosed> all(body.components.left.size());
  const Vec3 o = body.middle();
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
    const FaceId f(slot);
    if (!body.mesh.is_live(f)) continue;
    const uint32_t component = body.components.at_home(body.loaded_base(f), body.mesh.data(f).piece);
    if (component == LoadedComponents::kNone) continue;
    const Triangle t = body.mesh.triangle(f);
    all[component].volume += volume_under(t, o);
    if (!all[component].lowest.valid()) all[component].lowest = f;
  }
  return all;
}

bool is_cavity(const Body& body, const std::vector<Enclosed>& components, FaceId f) {
  const uint32_t component = body.components.at_home(body.loaded_base(f), body.mesh.data(f).piece);
  return component != LoadedComponents::kNone && components[component].volume < 0;
}

// Returns the label of the piece around a cavity: that which a ray from a face of it, into the material
// behind that face, leaves once more than it enters; `own` if there is none.
uint32_t label_around(const Body& body, const std::vector<Enclosed>& components, FaceId f, uint32_t own) {
  const Triangle t = body.mesh.triangle(f);
  const Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length = glm::length(normal);
  if (!(length > 0)) return own;
  const Vec3 direction = -normal / length;
  std::vector<RayHit> hits;
  body.tree.crossings(body.mesh, {(t[0] + t[1] + t[2]) / 3.0, direction},
                      {0, std::numeric_limits<double>::max()}, hits);
  std::map<uint32_t, int> left;
  for (const RayHit& hit : hits) {
    if (is_cavity(body, components, hit.face)) continue;
    const Triangle other = body.mesh.triangle(hit.face);
    left[body.mesh.data(hit.face).piece] +=
        glm::dot(glm::cross(other[1] - other[0], other[2] - other[0]), direction) > 0 ? 1 : -1;
  }
  for (const RayHit& hit : hits) {
    const uint32_t label = body.mesh.data(hit.face).piece;
    if (!is_cavity(body, components, hit.face) && left[label] > 0) return label;
  }
  return own;
}

}  // namespace

bool cavities_requested(const Body& body) { return body.separation.cavities_requested; }

void assign_cavities(BodyId id, Body& body, Delta& delta) {
  if (!cavities_requested(body)) return;
  KERF_ASSERT(is_settled(body));
  body.separation.cavities_requested = false;
  if (body.components.left.empty()) return;
  const std::vector<Enclosed> components = components_of(body);
  std::map<uint32_t, uint32_t> label_of;
  for (uint32_t c = 0; c < components.size(); ++c) {
    if (!(components[c].volume < 0)) continue;
    const uint32_t home = body.components.home[c];
    const uint32_t label = label_around(body, components, components[c].lowest, home);
    if (label != home) label_of[c] = label;
  }
  if (label_of.empty()) return;
  Delta step;
  step.bodies.push_back(move_components(id, body, label_of));
  delta.append(std::move(step));
}

}  // namespace kerf
