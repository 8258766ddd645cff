#include "core/cut/burn.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/assert.h"
#include "core/heat/oxygen.h"

namespace kerf {

namespace {

// The width of a face, squared: a square of half its size is about as wide as it is.
double width2_of(double area) { return 2 * area; }

}  // namespace

Burn::Burn(World& world, const CutSettings& settings, std::vector<BurnedBody>& bodies, double face,
           IsFine is_fine)
    : world_(world),
      settings_(settings),
      bodies_(bodies),
      bundle_(ray_bundle(settings.laser.pattern, face)),
      is_fine_(std::move(is_fine)) {}

void Burn::emit(const Pose& pose, double joules) {
  KERF_ASSERT(joules >= 0);
  EnergyLedger& ledger = world_.edit_energy();
  ledger.emitted += joules;
  double absorbed = 0, waits = 0;
  met_.clear();
  for (const BundleRay& ray : turned_bundle(bundle_, ledger.poses++)) {
    waits += emit_ray(ray_at(settings_.laser, ray, pose), joules * ray.share, pose, absorbed);
  }
  ledger.absorbed += absorbed;
  ledger.escaped += joules - absorbed - waits;
}

double Burn::waiting_within() const {
  double aside = 0;
  for (const WaitingRay& ray : waiting_) aside = std::max(aside, ray.aside);
  return aside;
}

void Burn::emit_waiting(bool splits) {
  EnergyLedger& ledger = world_.edit_energy();
  splits_ = splits;
  for (const WaitingRay& w : std::exchange(waiting_, {})) {
    double absorbed = 0;
    const double waits = emit_ray(w.ray, w.joules, w.axis, absorbed);
    ledger.absorbed += absorbed;
    ledger.escaped += w.joules - absorbed - waits;
  }
  splits_ = true;
}

// Adds to what was absorbed (J); returns what waits.
double Burn::emit_ray(const Pose& ray, double joules, const Pose& axis, double& absorbed) {
  double left = joules;
  find_meetings(ray);
  for (size_t i = 0; i < meetings_.size() && left > 0; ++i) {
    const Meeting& at = meetings_[i];
    if (is_gone(at)) continue;
    const Body& body = world_.body(bodies_[at.body].id);
    const double share = absorptivity(body.sheet.substance, settings_.laser.wavelength);
    if (share <= 0) break;
    if (must_wait(at, left * share)) {
      wait(at, {ray, axis, left, 0});
      return left;
    }
    const double taken = spend(at, left * share);
    if (settings_.laser.assist == Assist::kOxygen) met_.push_back(at);
    absorbed += taken;
    left = is_gone(at) ? std::max(0.0, left - taken / share) : 0;
  }
  return 0;
}

// Whether the energy (J) would take a wide face that is to be split first.
bool Burn::must_wait(const Meeting& at, double joules) const {
  const Body& body = world_.body(bodies_[at.body].id);
  return splits_ && is_wide(triangle_area(body.mesh.triangle(at.face))) &&
         joules >= removal_energy(body, at.face) - body.heat.energy_of(body.mesh, at.face) &&
         !is_fine_(at.body, at.face);
}

void Burn::wait(const Meeting& at, WaitingRay ray) {
  const Vec3 from = ray.ray.origin + at.length * ray.ray.direction - ray.axis.origin;
  ray.aside = glm::length(from - glm::dot(from, ray.axis.direction) * ray.axis.direction);
  waiting_.push_back(ray);
  std::vector<FaceId>& coarse = bodies_[at.body].coarse;
  if (std::find(coarse.begin(), coarse.end(), at.face) == coarse.end()) coarse.push_back(at.face);
}

// The faces of a body that were met and are not gone, each once.
std::vector<FaceId> Burn::faces_met(size_t b) const {
  std::vector<FaceId> met;
  for (const Meeting& at : met_) {
    if (at.body == b && !is_gone(at)) met.push_back(at.face);
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
  for (const FaceId f : faces) {
    const double own = joules * triangle_area(body.mesh.triangle(f)) / all;
    if (!must_wait({0, b, f}, own)) taken += spend({0, b, f}, own);
  }
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
  return is_wide(area) ? whole * kerf / std::sqrt(width2_of(area)) : whole;
}

// Wider than the kerf.
bool Burn::is_wide(double area) const {
  const double kerf = 2 * settings_.laser.radius;
  return width2_of(area) > kerf * kerf;
}

}  // namespace kerf
