#include "core/cut/thermal_step.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/heat/material.h"

namespace kerf {

namespace {

// Returns the squared width of a face: a square of twice its area is about as wide.
double width2_of(double area) { return 2 * area; }

constexpr double kRefinedRadii = 1.5;  // faces are fine up to this distance from the axis, in beam radii
// Distance of poses from which rays are emitted while the beam moves, in spacings of the bundle.
constexpr double kSpacingsASample = 0.8;
// Parts of a move by one radius, and of a move that takes the time radius^2 / diffusivity.
constexpr double kPartsARadius = 4, kPartsADiffusionTime = 16;
constexpr double kMaxHeatSlices = 4096;  // of a move
// Faces at which rays wait are split up to this multiple of the max distance of waiting rays from the axis.
constexpr double kBeyondRays = 1.01;

Pose between(const BeamMove& move, double t) {
  if (t <= 0) return move.from;
  const Vec3 origin = (1 - t) * move.from.origin + t * move.to.origin;
  if (move.from.direction == move.to.direction) return {origin, move.from.direction};
  return {origin, glm::normalize((1 - t) * move.from.direction + t * move.to.direction)};
}

// Returns the size of the faces that the resolution makes under the beam, in radii.
double size_of_faces(const CutSettings& settings) {
  const Resolution& r = settings.resolution;
  return r.rule == Resolution::Rule::kTargetEdge ? r.target_edge / settings.laser.radius : 1;
}

class ThermalMoves {
 public:
  ThermalMoves(World& world, const CutSettings& settings, const Progress& progress)
      : world_(world),
        settings_(settings),
        progress_(progress),
        face_(size_of_faces(settings)),
        burn_(world, settings, burned_, face_,
              [this](size_t b, FaceId f) { return is_fine_enough(steps_[b], settings_, f); }) {
    for (const BodyId id : cuttable(world, settings)) {
      burned_.push_back({id, {}, {}, 0, {}});
      steps_.emplace_back(id, world.body(id));
    }
  }

  Status take(const BeamMove& move) {
    KERF_ASSERT(move.seconds >= 0);
    const double parts = parts_of(move);
    for (double i = 0; i < parts; ++i) {
      const BeamMove part{between(move, i / parts), between(move, (i + 1) / parts), move.seconds / parts};
      if (const Status done = take_part(part, 1 / (kSpacingsASample * bundle_spacing(face_) * parts)); !done)
        return done;
    }
    apply_joints(world_, held_);
    return Done{};
  }

  size_t taken() const { return taken_; }

  void end(StepResult& result) {
    for (BodyStep& step : steps_) end_step(step, result);
    result.delta.append(std::move(held_));
    result.statistics.met_s += met_s_;
    result.statistics.depth_s += depth_s_;
  }

 private:
  // Returns the number of parts of a move: in each of them the beam advances by a fraction of its radius,
  // heat spreads by no more than that, and the faces under the beam absorb no more energy than their
  // removal needs.
  double parts_of(const BeamMove& move) const {
    const double w = settings_.laser.radius, joules = emitted_energy(settings_.laser, 0, move.seconds);
    double most = moves(move) ? kPartsARadius : 1;
    for (const BurnedBody& burned : burned_) {
      const Sheet& sheet = world_.body(burned.id).sheet;
      const Substance& s = sheet.substance;
      const double spot = 0.5 * kPi * w * w * sheet.thickness * s.density * enthalpy_of_removal(s);
      const double diffusivity = s.conductivity / (s.density * s.heat_solid);
      most =
          std::max(most, (absorptivity(s, settings_.laser.wavelength) * joules + burnt(sheet, move)) / spot);
      most = std::max(most, kPartsADiffusionTime * diffusivity * move.seconds / (w * w));
    }
    return std::min(std::ceil(most), kMaxHeatSlices);
  }

  // Returns an upper bound of the heat of burning during a move (J).
  double burnt(const Sheet& sheet, const BeamMove& move) const {
    if (settings_.laser.assist != Assist::kOxygen) return 0;
    const double kerf = 2 * settings_.laser.radius * sheet.thickness * kBurningFront * move.seconds;
    return kerf * sheet.substance.density * burning_heat(sheet.substance, kBurningFront);
  }

  static bool moves(const BeamMove& move) {
    return move.from.origin != move.to.origin || move.from.direction != move.to.direction;
  }

  Status take_part(const BeamMove& part, double max_samples) {
    ++taken_;
    const bool meets = find_reach(part);
    if (meets) {
      if (const Status refined = refine_reached(part); !refined) return refined;
    }
    emit(part, max_samples);
    double depth = remove_gone();
    while (burn_.any_waiting()) {
      const Result<bool> splits = refine_coarse(part);
      if (!splits) return splits.error();
      burn_.emit_waiting(*splits);
      depth = std::max(depth, remove_gone());
    }
    if (meets) {
      met_s_ += part.seconds;
      depth_s_ += depth * part.seconds;
    }
    step_heat(world_, part.seconds);
    return progress_.report(0) ? Status(Done{}) : Status(cancelled());
  }

  // Returns true if the beam meets a face; sets reach_.
  bool find_reach(const BeamMove& part) {
    std::optional<double> reach = burn_.reach(part.from);
    const std::optional<double> end = burn_.reach(part.to);
    if (end) reach = std::max(reach.value_or(0), *end);
    reach_ = reach.value_or(0);
    return reach.has_value();
  }

  Status refine_reached(const BeamMove& part) {
    Laser wide = settings_.laser;
    wide.radius *= kRefinedRadii;
    for (BodyStep& step : steps_) {
      sweep(step, wide, part);
      UnfinishedMove move;
      hit(step, move.hit);
      const Pose seen = step.body().placement.to_body(part.from);
      std::erase_if(move.hit, [&](FaceId f) { return is_behind_reach(step.mesh().triangle(f), seen); });
      taken_ += move.hit.size();
      move.to_split.assign(move.hit.rbegin(), move.hit.rend());
      while (!move.to_split.empty()) {
        if (const Status refined = refine(step, move, settings_, progress_); !refined) return refined;
      }
    }
    return Done{};
  }

  // Splits the faces at which rays wait. Returns true if any face was split.
  Result<bool> refine_coarse(const BeamMove& part) {
    Laser wide = settings_.laser;
    wide.pattern = Pattern::kVolume;
    wide.radius = kBeyondRays * std::max(wide.radius, burn_.waiting_within());
    bool splits = false;
    for (size_t b = 0; b < steps_.size(); ++b) {
      sweep(steps_[b], wide, part);
      UnfinishedMove move;
      move.to_split = std::exchange(burned_[b].coarse, {});
      std::erase_if(move.to_split, [&](FaceId f) { return !steps_[b].mesh().is_live(f); });
      taken_ += move.to_split.size();
      while (!move.to_split.empty()) {
        if (const Status refined = refine(steps_[b], move, settings_, progress_); !refined)
          return refined.error();
      }
      splits = splits || move.has_split;
    }
    return splits;
  }

  bool is_behind_reach(const Triangle& t, const Pose& beam) const {
    const auto depth = [&](const Vec3& p) { return glm::dot(p - beam.origin, beam.direction); };
    return std::min({depth(t[0]), depth(t[1]), depth(t[2])}) > reach_ + settings_.laser.radius;
  }

  void emit(const BeamMove& part, double max_samples) {
    const EnergyLedger& ledger = world_.energy();
    const double joules = emitted_energy(settings_.laser, ledger.beam_on, ledger.beam_on + part.seconds);
    world_.edit_energy().beam_on += part.seconds;
    const double samples = moves(part) ? std::max(1.0, std::ceil(max_samples)) : 1;
    const double way = settings_.laser.assist == Assist::kOxygen ? way_on_surface(part) : 0;
    for (double i = 0; i < samples; ++i) {
      burn_.emit(between(part, (i + 0.5) / samples), joules / samples);
      if (way > 0 && part.seconds > 0)
        burn_.burn(2 * settings_.laser.radius * way / samples, way / part.seconds);
    }
  }

  // Returns the distance that the beam moves across the surface (m).
  double way_on_surface(const BeamMove& part) const {
    const auto at = [&](const Pose& pose) { return pose.origin + reach_ * pose.direction; };
    const Vec3 way = at(part.to) - at(part.from);
    return glm::length(way - glm::dot(way, part.from.direction) * part.from.direction);
  }

  // Removes the faces that have reached their energy of removal. Returns the depth of the beam; 1 if a face
  // was removed.
  double remove_gone() {
    double depth = 0;
    for (size_t b = 0; b < burned_.size(); ++b) {
      BurnedBody& burned = burned_[b];
      depth = std::max(depth, burned.removed.empty() ? burned.deepest : 1.0);
      std::sort(burned.removed.begin(), burned.removed.end());
      if (!burned.removed.empty()) remove_faces(steps_[b], burned.removed);
      taken_ += separate(world_, steps_[b], burned.removed, settings_.search_a_move);
      burned.removed.clear();
      burned.removed_slots.clear();
      burned.deepest = 0;
    }
    return std::min(depth, 1.0);
  }

  World& world_;
  const CutSettings& settings_;
  const Progress& progress_;
  std::vector<BurnedBody> burned_;
  std::vector<BodyStep> steps_;  // of the same bodies
  double face_;                  // size of the faces under the beam, in radii
  Burn burn_;
  double reach_ = 0;  // m, along the beam
  Delta held_;        // changes made by joints
  size_t taken_ = 0;  // faces and parts of moves
  double met_s_ = 0, depth_s_ = 0;
};

}  // namespace

Burn::Burn(World& world, const CutSettings& settings, std::vector<BurnedBody>& bodies, double face,
           IsFine is_fine)
    : world_(world),
      settings_(settings),
      bodies_(bodies),
      bundle_(ray_bundle(settings.laser.pattern, face)),
      is_fine_(std::move(is_fine)) {}

// A beam without a wavelength has the usual one of the first body.
Pose Burn::ray_of(const BundleRay& ray, const Pose& pose) const {
  if (settings_.laser.wavelength > 0 || !settings_.laser.focus || bodies_.empty())
    return ray_at(settings_.laser, ray, pose);
  Laser laser = settings_.laser;
  laser.wavelength = world_.body(bodies_.front().id).sheet.substance.wavelength;
  return ray_at(laser, ray, pose);
}

void Burn::emit(const Pose& pose, double joules) {
  KERF_ASSERT(joules >= 0);
  EnergyLedger& ledger = world_.edit_energy();
  ledger.emitted += joules;
  double absorbed = 0, waits = 0;
  pose_hits_.clear();
  for (const BundleRay& ray : turned_bundle(bundle_, ledger.poses++)) {
    waits += emit_ray(ray_of(ray, pose), joules * ray.share, pose, absorbed);
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

// Adds to the absorbed energy (J); returns the energy that waits.
double Burn::emit_ray(const Pose& ray, double joules, const Pose& axis, double& absorbed) {
  double left = joules;
  find_hits(ray);
  for (size_t i = 0; i < ray_hits_.size() && left > 0; ++i) {
    const Meeting& at = ray_hits_[i];
    if (is_removed(at)) continue;
    const Body& body = world_.body(bodies_[at.body].id);
    const double share = absorptivity(body.sheet.substance, settings_.laser.wavelength);
    if (share <= 0) break;
    if (needs_to_wait(at, left * share)) {
      wait(at, {ray, axis, left, 0});
      return left;
    }
    const double taken = spend(at, left * share);
    if (settings_.laser.assist == Assist::kOxygen) pose_hits_.push_back(at);
    absorbed += taken;
    left = is_removed(at) ? std::max(0.0, left - taken / share) : 0;
  }
  return 0;
}

// Returns true if the energy (J) would remove a wide face that must be split first.
bool Burn::needs_to_wait(const Meeting& at, double joules) const {
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

// Returns the faces of a body that were hit and are not removed, each once.
std::vector<FaceId> Burn::hit_faces(size_t b) const {
  std::vector<FaceId> met;
  for (const Meeting& at : pose_hits_) {
    if (at.body == b && !is_removed(at)) met.push_back(at.face);
  }
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());
  return met;
}

// Heats faces of a body with energy (J) shared in proportion to their areas; returns the energy absorbed.
double Burn::spread(size_t b, std::span<const FaceId> faces, double joules) {
  const Body& body = world_.body(bodies_[b].id);
  double all = 0, taken = 0;
  for (const FaceId f : faces) all += triangle_area(body.mesh.triangle(f));
  if (all <= 0) return 0;
  for (const FaceId f : faces) {
    const double own = joules * triangle_area(body.mesh.triangle(f)) / all;
    if (!needs_to_wait({0, b, f}, own)) taken += spend({0, b, f}, own);
  }
  return taken;
}

void Burn::burn(double area, double speed) {
  KERF_ASSERT(area >= 0 && speed >= 0);
  for (size_t b = 0; b < bodies_.size(); ++b) {
    const Body& body = world_.body(bodies_[b].id);
    const Sheet& sheet = body.sheet;
    if (sheet.substance.burnt_share == 0) continue;
    std::vector<FaceId> faces = hit_faces(b);
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
    find_hits(ray_of(ray, pose));
    if (!ray_hits_.empty()) farthest = std::max(farthest.value_or(0), ray_hits_.front().length);
  }
  return farthest;
}

void Burn::find_hits(const Pose& ray) {
  ray_hits_.clear();
  for (size_t b = 0; b < bodies_.size(); ++b) {
    const Body& body = world_.body(bodies_[b].id);
    hits_.clear();
    body.tree.crossings(body.mesh, body.placement.to_body(ray), settings_.laser.range, hits_);
    for (const RayHit& hit : hits_) ray_hits_.push_back({hit.length, b, hit.face});
  }
  std::sort(ray_hits_.begin(), ray_hits_.end(), [](const Meeting& a, const Meeting& b) {
    return std::tie(a.length, a.body, a.face) < std::tie(b.length, b.body, b.face);
  });
}

// Heats a face with as much of the energy as its removal needs; returns the energy absorbed.
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
  burned.removed.push_back(at.face);
  burned.removed_slots.insert(at.face.index);
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

// Returns true if the face is wider than the kerf.
bool Burn::is_wide(double area) const {
  const double kerf = 2 * settings_.laser.radius;
  return width2_of(area) > kerf * kerf;
}

Result<StepResult> thermal_step(World& world, const CutSettings& settings, std::span<const BeamMove> moves,
                                const Progress* progress) {
  KERF_ASSERT(settings.model == Model::kThermal);
  StepResult result;
  const Progress asked = share_of(progress, 0, 1);
  ThermalMoves thermal(world, settings, asked);
  for (const BeamMove& move : moves) {
    if (result.moves > 0 && thermal.taken() >= settings.faces_per_step) break;
    if (const Status done = thermal.take(move); !done) return done.error();
    ++result.moves;
    result.last = move;
  }
  thermal.end(result);
  return result;
}

bool scales_removal(const CutSettings& settings) {
  const Resolution& r = settings.resolution;
  return r.rule != Resolution::Rule::kTargetEdge || r.target_edge > 2 * settings.laser.radius;
}

}  // namespace kerf
