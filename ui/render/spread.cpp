#include "ui/render/spread.h"

#include <vector>

namespace kerf {

namespace {

struct Middle {
  Vec3 moment{0};  // m^3
  double area = 0;
  Vec3 mean() const { return area > 0 ? moment / area : Vec3(0); }
};

std::vector<Middle> middles_of(const Body& body) {
  std::vector<Middle> middles(body.pieces.size());
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    const double area = triangle_area(t);
    Middle& middle = middles[body.mesh.data(FaceId(f)).piece];
    middle.moment += (t[0] + t[1] + t[2]) * (area / 3);
    middle.area += area;
  }
  return middles;
}

}  // namespace

void spread_pieces(const World& world, double spread, std::map<PieceId, PieceLook>& looks) {
  for (auto& [id, look] : looks) look.offset = Vec3(0);
  if (spread > 0) {
    const World::Bounds bounds = world.bounds();
    const Vec3 middle = 0.5 * (bounds.min + bounds.max);
    for (const BodyId id : world.ids()) {
      const Body& body = world.body(id);
      const std::vector<Middle> middles = middles_of(body);
      for (uint32_t label = 0; label < middles.size(); ++label) {
        if (body.pieces[label].faces == 0) continue;
        looks[{id, label}].offset = spread * (body.placement.to_world(middles[label].mean()) - middle);
      }
    }
  }
  std::erase_if(looks, [](const auto& entry) { return entry.second == PieceLook(); });
}

}  // namespace kerf
