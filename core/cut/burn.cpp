#include "core/cut/burn.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/assert.h"
#include "core/heat/oxygen.h"

namespace kerf {

Burn::Burn(World& world, const CutSettings& settings, std::vector<BurnedBody>& bodies, double face)
    : world_(world),
      settings_(settings),
      bodies_(bodies),
      bundle_(ray_bundle(settings.laser.pattern, face)) {}

void Burn::emit(const Pose& pose, double joules) {
  KERF_ASSERT(joules >= 0);
  EnergyLedger& ledger = world_.edit_energy();
  ledger.emitted += joules;
  double absorbed = 0;
  met_.clear();
  for (const BundleRay& ray : turned_bundle(bundle_, ledger.poses++)) {
    double left = joules * ray.share;
    find_meetings(ray_at(settings_.laser, ray, pose));
    for (size_t i = 0; i < meetings_.size() && left > 0; ++i) {
      const Meeting& at = meetings_[i];
      if (bodies_[at.body].gone_slots.contains(at.face.index)) continue;
      const Body& body = world_.body(bodies_[at.body].id);
      const double share = absorptivity(body.sheet.substance, settings_.laser.wavelength);
      if (share <= 0) break;
      const double taken = spend(at, left * share);
      if (settings_.laser.assist == Assist::kOxygen) met_.push_back(at);
      absorbed += taken;
      left = bodies_[at.body].gone_slots.contains(at.face.index) ? std::max(0.0, left - taken / share) : 0;
    }
  }
  ledger.absorbed += absorbed;
  ledger.escaped += joules - absorbed;
}

// The faces of a body that were met and are not gone, each once.
std::vector<FaceId> Burn::faces_met(size_t b) const {
  std::vector<FaceId> met;
  for (const Meeting& at : met_) {
    if (at.body == b && !bodies_[b].gone_slots.contains(at.face.index)) met.push_back(at.face);
  }
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());
  return met;
}

// Heats faces of a body by shares of an energy (J) that are as large as their areas; returns what they took.
double Burn::spread(size_t b, std::span<const FaceId> faces, double joules) {
  const Body& body = world_.body(bodies_[b].id);
  double all = 0, taken = 0;
  for (const FaceId f : faces) all += triangle_area(body.mesh.triangle(f));
  if (all <= 0) return 0;
  for (const FaceId f : faces) taken += spend({0, b, f}, joules * triangle_area(body.mesh.triangle(f)) / all);
  return taken;
}

void Burn::burn(double area, double speed) {
  KERF_ASSERT(area >= 0 && speed >= 0);
  for (size_t b = 0; b < bodies_.size(); ++b) {
    const Body& body = world_.body(bodies_[b].id);
    const Sheet& sheet = body.sheet;
    if (sheet.substance.burnt_share == 0) continue;
    std::vector<FaceId> faces = faces_met(b);
    const auto on_fire = [&](FaceId f) {
      return body.heat.temperature(body.mesh, f, sheet.substance, sheet.thickness) >= kKindling;
    };
    const auto cold = std::stable_partition(faces.begin(), faces.end(), on_fire);
    if (cold == faces.begin()) continue;
    const double joules =
        burning_heat(sheet.substance, speed) * area * sheet.thickness * sheet.substance.density;
    const double taken = spread(b, {faces.begin(), cold}, joules);
    world_.edit_energy().burnt += taken + spread(b, {cold, faces.end()}, joules - taken);
  }
}

std::optional<double> Burn::reach(const Pose& pose) {
  std::optional<double> farthest;
  for (const BundleRay& ray : bundle_) {
    find_meetings(ray_at(settings_.laser, ray, pose));
    if (!meetings_.empty()) farthest = std::max(farthest.value_or(0), meetings_.front().length);
  }
  return farthest;
}

void Burn::find_meetings(const Pose& ray) {
  meetings_.clear();
  for (size_t b = 0; b < bodies_.size(); ++b) {
    const Body& body = world_.body(bodies_[b].id);
    hits_.clear();
    body.tree.crossings(body.mesh, body.placement.to_body(ray), settings_.laser.range, hits_);
    for (const RayHit& hit : hits_) meetings_.push_back({hit.length, b, hit.face});
  }
  std::sort(meetings_.begin(), meetings_.end(), [](const Meeting& a, const Meeting& b) {
    return std::tie(a.length, a.body, a.face) < std::tie(b.length, b.body, b.face);
  });
}

// Heats a face by as much of the energy as it takes until it is gone; returns how much that is.
double Burn::spend(const Meeting& at, double joules) {
  BurnedBody& burned = bodies_[at.body];
  Body& body = world_.body(burned.id);
  const double before = body.heat.energy_of(body.mesh, at.face), whole = removal_energy(body, at.face);
  const double needed = std::max(0.0, whole - before);
  if (joules < needed) {
    body.heat.set_energy(body.mesh, at.face, before + joules);
    burned.deepest = std::max(burned.deepest, (before + joules) / whole);
    return joules;
  }
  body.heat.set_energy(body.mesh, at.face, before + needed);
  burned.gone.push_back(at.face);
  burned.gone_slots.insert(at.face.index);
  return needed;
}

double Burn::removal_energy(const Body& body, FaceId f) const {
  const Sheet& sheet = body.sheet;
  const Triangle t = body.mesh.triangle(f);
  const double area = triangle_area(t), kerf = 2 * settings_.laser.radius;
  const double whole =
      area * sheet.thickness * sheet.substance.density * enthalpy_of_removal(sheet.substance);
  const double width2 = 2 * area;  // a square of this area is about as wide as the face is
  return width2 > kerf * kerf ? whole * kerf / std::sqrt(width2) : whole;
}

}  // namespace kerf
