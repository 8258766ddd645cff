#include "core/edit/move_components.h"

#include "core/base/assert.h"
#include "core/edit/separation.h"

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

}  // namespace kerf
