#include "core/heat/face_heat.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/heat/conduction_solver.h"

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

void FaceHeat::record_hottest(Mesh& mesh, FaceId f, double temperature) const {
  const auto now = static_cast<float>(temperature);
  if (now > mesh.columns().get(hottest, f)) mesh.columns().set(hottest, f, now);
}

double FaceHeat::stored(const Mesh& mesh) const {
  double sum = 0;
  mesh.columns().for_each_set(energy, [&](FaceId f) { sum += energy_of(mesh, f); });
  return sum;
}

namespace {

constexpr int kMaxSteps = 64;  // in one call
// Cooling rate of faces almost as cold as the ambient (K/s). Slower heating by a beam has no effect.
constexpr double kRestRate = 0.5;
constexpr double kTintedFrom = 500;  // K; below it no surface discolours

struct HotBody {
  Mesh& mesh;
  const FaceHeat& heat;
  const Substance& substance;
  double thickness;
  HeatGeometry& geometry;

  double mass(FaceId f) const { return geometry.area(mesh, f) * thickness * substance.density; }
  void note(FaceId f, double temperature) const {
    if (temperature > kTintedFrom) heat.record_hottest(mesh, f, temperature);
  }
};

// Returns the energy that a resting face loses in a time (J): all of it if it has no mass.
double resting_loss(const Substance& substance, double joules, double mass, double seconds) {
  return mass > 0 ? std::min(joules, mass * substance.heat_solid * kRestRate * seconds) : joules;
}

// Adds the hot faces and their neighbours to the region. Other warm faces rest; returns the energy they lose
// (J).
double gather(const HotBody& body, const std::vector<FaceId>& warm, double seconds, HeatRegion& region) {
  std::vector<FaceId> mild;
  double rested = 0;
  const auto rest = [&](FaceId f, double mass) {
    const double joules = body.heat.energy_of(body.mesh, f);
    const double loss = resting_loss(body.substance, joules, mass, seconds);
    body.heat.set_energy(body.mesh, f, joules - loss);
    rested += loss;
  };
  for (const FaceId f : warm) {
    const double mass = body.mass(f);
    const double temperature = temperature_of(body.substance, body.heat.energy_of(body.mesh, f), mass);
    if (temperature > kAmbient + kColdRise) {
      body.note(f, temperature);
      region.add(f);
    } else if (mass > 0) {
      mild.push_back(f);
    } else {
      rest(f, 0);
    }
  }
  const uint32_t hot = region.size();
  for (uint32_t i = 0; i < hot; ++i) region.surround(i);
  for (const FaceId f : mild) {
    if (!region.contains(f)) rest(f, body.mass(f));
  }
  return rested;
}

// Writes the energies to the mesh. Returns by how much they decrease (J).
double store(const HotBody& body, const HeatRegion& region) {
  double before = 0, after = 0;
  for (const HeatRegion::Node& node : region.nodes()) {
    before += body.heat.energy_of(body.mesh, node.face);
    after += node.joules;
    body.heat.set_energy(body.mesh, node.face, node.joules);
    body.note(node.face, temperature_of(body.substance, node.joules, node.mass));
  }
  return before - after;
}

}  // namespace

double conduct(Mesh& mesh, const FaceHeat& heat, const Substance& substance, double thickness,
               const HeatLoss& loss, double seconds, HeatMemory& memory) {
  KERF_ASSERT(thickness > 0 && seconds >= 0);
  KERF_ASSERT(loss.convection >= 0 && substance.density > 0);
  std::vector<FaceId> warm;
  mesh.columns().for_each_set(heat.energy, [&](FaceId f) { warm.push_back(f); });
  if (warm.empty() || seconds == 0) return 0;

  if (!memory.keeps_geometry) memory.geometry.clear();
  const HotBody body{mesh, heat, substance, thickness, memory.geometry};
  HeatRegion region(mesh, heat, substance, thickness, memory.geometry, memory.region);
  const double rested = gather(body, warm, seconds, region);
  HeatStep step(region, substance, loss, thickness, memory.step);
  double remaining = seconds;
  while (remaining > 0 && step.any_hot()) remaining -= step.advance(remaining, seconds / kMaxSteps);
  if (remaining > 0) {
    for (HeatRegion::Node& node : region.nodes())
      node.joules -= resting_loss(substance, node.joules, node.mass, remaining);
  }
  return rested + store(body, region);
}

}  // namespace kerf
