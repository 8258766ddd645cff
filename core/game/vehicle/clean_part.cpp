#include "core/game/vehicle/clean_part.h"

#include <vector>

namespace kerf {

bool is_clean(const Body& piece, const Body& loaded) {
  const LoadedComponents& components = loaded.components;
  if (components.of_base.empty()) return false;
  std::vector<double> areas(components.left.size(), 0);
  double all = 0;
  for (uint32_t slot = 0; slot < piece.mesh.face_slots(); ++slot) {
    const FaceId f(slot);
    if (!piece.mesh.is_live(f)) continue;
    const double area = triangle_area(piece.mesh.triangle(f));
    areas[components.of_base[piece.loaded_face(piece.loaded_base(f)).index]] += area;
    all += area;
  }
  if (all < kLeastCleanArea) return false;
  for (uint32_t c = 0; c < areas.size(); ++c) {
    if (areas[c] > 0 && areas[c] < kCleanShare * components.left[c].area) return false;
  }
  return true;
}

}  // namespace kerf
