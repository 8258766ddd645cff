#include "core/game/match/tally.h"

#include <utility>

#include "core/game/vehicle/damage.h"

namespace kerf {

namespace {

constexpr double kHalf = 0.25;  // of the area of a chassis

}  // namespace

Vec3 middle_of(const Body& body) {
  const Bounds box = body.bounds();
  return body.placement.to_world(0.5 * (box.min + box.max));
}

void Tally::add_event(Event event, double points) {
  const bool to_enemy = event.vehicle != kPlayer && event.vehicle != Event::kNobody;
  if (to_enemy && event.by == kPlayer) {
    event.points = points;
    standing_.score += points;
  }
  events_.push_back(event);
}

void Tally::record_cut(size_t shooter, size_t victim, BodyId id, const Body& body, const StepResult& cut) {
  standing_.faces_removed += cut.delta.removed_faces;
  Vec3 at = middle_of(body);
  for (const BodyDelta& b : cut.delta.bodies) {
    if (!b.removed.empty()) at = body.placement.to_world(b.removed.front().corners[0]);
  }
  add_event({Event::Kind::kCut, victim, shooter, 0, id, at, cut.delta.removed_mass});
  if (victim == Event::kNobody) return;
  Record& record = records_[victim];
  record.last_cut_by = shooter;
  record.changed = true;
  if (shooter == kPlayer && record.first_stroke == 0) record.first_stroke = strokes_;
}

void Tally::record_piece(const Detached& piece, const Body& body, size_t victim, const Vehicle* vehicle,
                         bool clean) {
  ++standing_.pieces;
  const double area = area_of(body);
  Event event{Event::Kind::kPieceOff, victim, Event::kNobody, 0, piece.to, middle_of(body), area};
  if (!vehicle) return add_event(event);
  event.by = records_[victim].last_cut_by;
  records_[victim].changed = true;
  add_event(event, scores_->piece);
  event.kind = Event::Kind::kCleanPart;
  if (clean && scores_->clean > 0) add_event(event, scores_->clean);
  const bool half = piece.from == vehicle->chassis && area > kHalf * vehicle->model->chassis_area;
  if (!half) return;
  event.kind = Event::Kind::kInHalves;
  add_event(event, scores_->in_halves);
}

bool Tally::takes_assessment(size_t vehicle) { return std::exchange(records_[vehicle].changed, false); }

void Tally::record_damage(const World& world, size_t index, const Vehicle& vehicle, const Damage& damage) {
  const Record& record = records_[index];
  Event event{Event::Kind::kWheelLost, index, record.last_cut_by};
  const auto lost = [&](Event::Kind kind, BodyId body, size_t part, double points) {
    event.kind = kind;
    event.body = body;
    event.part = part;
    event.at = middle_of(world.body(body));
    add_event(event, points);
  };
  for (const size_t w : damage.wheels) {
    lost(Event::Kind::kWheelLost, vehicle.wheels[w].body, w, scores_->wheel);
    if (scores_->clean > 0 && is_clean(world.body(vehicle.wheels[w].body), vehicle.model->wheels[w].body))
      lost(Event::Kind::kCleanPart, vehicle.wheels[w].body, w, scores_->clean);
    standing_.wheels_lost += index == kPlayer;
  }
  if (damage.turret) lost(Event::Kind::kTurretLost, vehicle.gun.turret, 0, scores_->turret);
  if (damage.barrel)
    lost(Event::Kind::kBarrelLost, vehicle.gun.barrel, 0, damage.turret ? 0 : scores_->turret);
  for (const size_t part : damage.vitals) {
    const bool engine = vehicle.what().vitals[part].kind == VitalDescription::Kind::kEngine;
    lost(Event::Kind::kVitalLost, vehicle.chassis, part, engine ? scores_->engine : scores_->driver);
  }
  if (!damage.died) return;
  const bool at_a_stroke = record.first_stroke == strokes_ && record.last_cut_by == kPlayer;
  lost(Event::Kind::kKilled, vehicle.chassis, 0, scores_->kill + (at_a_stroke ? scores_->at_a_stroke : 0));
  standing_.enemies_destroyed += index != kPlayer;
}

}  // namespace kerf
