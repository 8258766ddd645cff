#include "core/heat/face_heat.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

FaceHeat FaceHeat::attach(Mesh& mesh) {
  return {mesh.columns().attach_shared_by_area(), mesh.columns().attach_copied<float>()};
}

double FaceHeat::temperature(const Mesh& mesh, FaceId f, const Substance& substance, double thickness) const {
  KERF_ASSERT(thickness > 0 && substance.density > 0);
  const double joules = energy_of(mesh, f);
  if (joules == 0) return kAmbient;
  const double mass = triangle_area(mesh.triangle(f)) * thickness * substance.density;
  return temperature_of(substance, joules, mass);
}

double FaceHeat::hottest_of(const Mesh& mesh, FaceId f) const {
  return std::max(kAmbient, static_cast<double>(mesh.columns().get(hottest, f)));
}

void FaceHeat::note_hottest(Mesh& mesh, FaceId f, double temperature) const {
  const auto now = static_cast<float>(temperature);
  if (now > mesh.columns().get(hottest, f)) mesh.columns().set(hottest, f, now);
}

double FaceHeat::stored(const Mesh& mesh) const {
  double sum = 0;
  mesh.columns().for_each_set(energy, [&](FaceId f) { sum += energy_of(mesh, f); });
  return sum;
}

}  // namespace kerf
