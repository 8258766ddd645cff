#include <algorithm>

#include "core/game/laser/gun.h"
#include "core/game/match/match.h"
#include "core/game/vehicle/damage.h"
#include "core/game/vehicle/vehicle_bodies.h"
#include "core/joints/hold_parts.h"
#include "core/physics/release_pieces.h"

namespace kerf {

namespace {

constexpr size_t kSearch = 20'000;  // faces that the search for separated pieces visits in a tick
constexpr double kCrumb = 0.0015;   // m^2; smaller pieces burn up
constexpr double kHalf = 0.25;      // of the area of a chassis
constexpr Ticks kAssessEvery = 8;   // while nothing comes off

double area_of(const Body& body) {
  double area = 0;
  for (uint32_t p = 0; p < body.pieces.size(); ++p) area += body.pieces[p].area;
  return area;
}

Vec3 middle_of(const Body& body) {
  const AabbTree::Box box = body.tree.bounds();
  return body.placement.to_world(0.5 * (box.min + box.max));
}

}  // namespace

void Match::tell(Event event, double points) {
  const bool to_enemy = event.vehicle != kPlayer && event.vehicle != Event::kNobody;
  if (to_enemy && event.by == kPlayer) {
    event.points = points;
    standing_.score += points;
  }
  events_.push_back(event);
}

void Match::fire_beams(const PlacementsBefore& before) {
  const Sight sight(world_);
  const auto cuttable = [&](BodyId id) { return !is_wall(id); };
  for (size_t v = 0; v < vehicles_.size(); ++v) {
    Vehicle& vehicle = vehicles_[v];
    const bool was_on = vehicle.gun.firing;
    if (trigger(vehicle, rules().description.laser))
      tell({Event::Kind::kOverheated, v, v, 0, {}, world_.body(vehicle.chassis).placement.position});
    if (!vehicle.gun.firing) continue;
    if (!was_on && v == kPlayer) ++strokes_;
    note_cut(v, fire(world_, vehicle, sight, cuttable, rules().description.laser, before));
  }
}

void Match::note_cut(size_t shooter, const std::map<BodyId, StepResult>& cut) {
  for (const auto& [id, result] : cut) {
    follow(result.delta);
    if (result.delta.removed_faces == 0) continue;
    standing_.faces_removed += result.delta.removed_faces;
    const size_t victim = vehicle_of(id);
    Vec3 at = middle_of(world_.body(id));
    for (const BodyDelta& body : result.delta.bodies) {
      if (!body.removed.empty()) at = world_.body(id).placement.to_world(body.removed.front().corners[0]);
    }
    tell({Event::Kind::kCut, victim, shooter, 0, id, at, static_cast<double>(result.delta.removed_faces)});
    if (victim == Event::kNobody) continue;
    Record& record = records_[victim];
    record.last_cut_by = shooter;
    record.changed = true;
    if (shooter == kPlayer && record.first_stroke == 0) record.first_stroke = strokes_;
  }
}

// What came apart becomes bodies, once the search for it is finished and it is known what joints still hold,
// which the cuts of the beams leave to this function.
void Match::separate() {
  if (!is_settled(world_) || joints_asked(world_)) follow(go_on_separating(world_, kSearch).delta);
  if (!is_settled(world_)) return;
  Delta released;
  release_pieces(world_, kGeneration, released);
  const std::vector<Detached> detached = released.detached;
  follow(std::move(released));
  std::vector<BodyId> crumbs;
  for (const Detached& piece : detached) note_piece(piece, crumbs);
  remove(crumbs);
}

void Match::note_piece(const Detached& piece, std::vector<BodyId>& crumbs) {
  Body& body = world_.body(piece.to);
  const double area = area_of(body);
  const size_t victim = vehicle_of(piece.from);
  if (area < kCrumb) {
    crumbs.push_back(piece.to);
    return;
  }
  ++standing_.pieces;
  Event event{Event::Kind::kPieceOff, victim, Event::kNobody, 0, piece.to, middle_of(body), area};
  if (victim == Event::kNobody) return tell(event);
  const Vehicle& vehicle = vehicles_[victim];
  body.sheet = vehicle.what().body.sheet;
  event.by = records_[victim].last_cut_by;
  records_[victim].lost_piece = true;
  tell(event, rules().description.scores.piece);
  const bool half = piece.from == vehicle.chassis && area > kHalf * vehicle.model->chassis_area;
  if (!half) return;
  event.kind = Event::Kind::kInHalves;
  tell(event, rules().description.scores.in_halves);
}

void Match::assess() {
  if (!is_settled(world_)) return;
  for (size_t v = 0; v < vehicles_.size(); ++v) {
    Record& record = records_[v];
    const bool due = record.changed && (standing_.ticks + v) % kAssessEvery == 0;
    if (!record.lost_piece && !due) continue;
    record.changed = record.lost_piece = false;
    note_damage(v, assess_damage(world_, vehicles_[v]));
  }
}

void Match::note_damage(size_t v, const Damage& damage) {
  const Vehicle& vehicle = vehicles_[v];
  const Scores& scores = rules().description.scores;
  const Record& record = records_[v];
  Event event{Event::Kind::kWheelLost, v, record.last_cut_by};
  const auto lost = [&](Event::Kind kind, BodyId body, size_t part, double points) {
    event.kind = kind;
    event.body = body;
    event.part = part;
    event.at = middle_of(world_.body(body));
    tell(event, points);
  };
  for (const size_t w : damage.wheels) {
    lost(Event::Kind::kWheelLost, vehicle.wheels[w].body, w, scores.wheel);
    standing_.wheels_lost += v == kPlayer;
  }
  if (damage.turret) lost(Event::Kind::kTurretLost, vehicle.gun.turret, 0, scores.turret);
  if (damage.barrel) lost(Event::Kind::kBarrelLost, vehicle.gun.barrel, 0, damage.turret ? 0 : scores.turret);
  for (const size_t part : damage.vitals) {
    const bool engine = vehicle.what().vitals[part].kind == VitalDescription::Kind::kEngine;
    lost(Event::Kind::kVitalLost, vehicle.chassis, part, engine ? scores.engine : scores.driver);
  }
  if (!damage.died) return;
  const bool at_a_stroke = record.first_stroke == strokes_ && record.last_cut_by == kPlayer;
  lost(Event::Kind::kKilled, vehicle.chassis, 0, scores.kill + (at_a_stroke ? scores.at_a_stroke : 0));
  standing_.enemies_destroyed += v != kPlayer;
}

}  // namespace kerf
