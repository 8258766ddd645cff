#include "core/game/match/rules.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/assert.h"
#include "core/document/text/fields.h"
#include "core/document/text/json.h"

namespace kerf {

namespace {

constexpr size_t kMaxWaves = 50, kMaxCars = 9;
constexpr NumberRange kPoints{0, 1e6};

std::array<EnemySkill, 3> default_skills() {
  return {EnemySkill{0.9, 0.105, 0.7, 0.35}, EnemySkill{}, EnemySkill{0.3, 0.03, 1, 1}};
}

Status read_vehicles(const JsonValue& value, const std::filesystem::path& folder,
                     std::vector<std::filesystem::path>& vehicles) {
  if (const Status array = value.array("vehicle files"); !array) return array;
  if (value.json().empty() || value.json().size() > kMaxEnemies)
    return value.wrong("must name 1 to " + std::to_string(kMaxEnemies) + " vehicle files");
  for (size_t i = 0; i < value.json().size(); ++i) {
    const auto name = value[i].text();
    if (!name) return name.error();
    vehicles.push_back(folder / *name);
  }
  return Done{};
}

Status read_medals(const JsonValue& value, std::vector<double>& medals) {
  if (const Status array = value.array("scores"); !array) return array;
  for (size_t i = 0; i < value.json().size(); ++i) {
    const auto score = value[i].number();
    if (!score) return score.error();
    medals.push_back(*score);
  }
  if (medals.size() == 3 && std::is_sorted(medals.begin(), medals.end())) return Done{};
  return value.wrong("must be three scores, ascending");
}

Status read_waves(const JsonValue& value, const std::filesystem::path& folder, RulesDescription& rules) {
  if (const Status array = value.array("waves"); !array) return array;
  for (size_t i = 0; i < value.json().size(); ++i) {
    if (const Status wave = read_vehicles(value[i], folder, rules.waves.emplace_back()); !wave) return wave;
  }
  if (rules.waves.size() <= kMaxWaves) return Done{};
  return value.wrong("must contain at most " + std::to_string(kMaxWaves) + " waves");
}

Status check_starts(const std::filesystem::path& file, const RulesDescription& rules,
                    const ArenaDescription& arena) {
  for (size_t i = 0; i < rules.waves.size(); ++i) {
    if (rules.waves[i].size() <= arena.enemies.size()) continue;
    return bad_input(file.string() + ": /waves/" + std::to_string(i) + ": has " +
                     std::to_string(rules.waves[i].size()) + " enemies, but " + rules.arena.string() +
                     " has only " + std::to_string(arena.enemies.size()) + " starts for them");
  }
  return Done{};
}

// Loads vehicles, each file once.
class Garage {
 public:
  Result<std::shared_ptr<const VehicleModel>> vehicle(const std::filesystem::path& file,
                                                      const Progress* progress) {
    const auto known = models_.find(file.lexically_normal());
    if (known != models_.end()) return known->second;
    auto description = read_vehicle(file);
    if (!description) return description.error();
    auto model = load_vehicle(std::move(*description), progress);
    if (!model) return model.error();
    models_[file.lexically_normal()] = *model;
    return *model;
  }

 private:
  std::map<std::filesystem::path, std::shared_ptr<const VehicleModel>> models_;
};

constexpr double kHalf = 0.25;  // of the area of a chassis

}  // namespace

static void describe(Fields& f, LaserRules& laser) {
  f.number("range", laser.range, {1, 1000, "m"}, kOptional);
  f.interval("radius", laser.radius, {0.001, 0.5, "m"}, kOptional);
  double energy = 100, drain = energy * laser.drain, charge = energy * laser.charge,
         driving = energy * laser.charge_driving;
  f.number("energy", energy, {0.001, 1e9}, kOptional);
  f.number("energy_per_second", drain, {0, 1e9}, kOptional);
  f.number("recharge_per_second", charge, {0, 1e9}, kOptional);
  if (f.present("recharge_per_second", false)) driving = charge;
  f.number("recharge_per_second_driving", driving, {0, 1e9}, kOptional);
  laser.drain = drain / energy;
  laser.charge = charge / energy;
  laser.charge_driving = driving / energy;
  f.number("heat_per_second", laser.heating, {0, 100}, kOptional);
  f.number("cooling_per_second", laser.cooling, {0.001, 100}, kOptional);
}

static void describe(Fields& f, MatchTimes& times) {
  f.number("match", times.match, {1, 36'000, "s"}, kOptional);
  f.number("between_waves", times.between_waves, {0.1, 60, "s"}, kOptional);
  f.number("righting", times.righting, {0.1, 60, "s"}, kOptional);
  f.number("stuck", times.stuck, {0.1, 60, "s"}, kOptional);
}

static void describe(Fields& f, EnemySkill& skill) {
  f.number("reaction", skill.reaction, {0, 2, "s"}, kOptional);
  f.angle("aim_error", skill.aim_error, {0, 45, "degrees"}, kOptional);
  f.number("enemy_speed", skill.speed, kShare, kOptional);
  f.number("enemy_fire", skill.fire, kShare, kOptional);
  f.number("enemy_distance", skill.distance, {4, 60, "m"}, kOptional);
  f.whole("enemies_at_once", skill.max_firing, 1, kMaxEnemies, kOptional);
  f.number("player_vital", skill.min_vital, {0.01, 1}, kOptional);
}

static void describe(Fields& f, Scores& scores) {
  f.number("piece", scores.piece, kPoints, kOptional);
  f.number("wheel", scores.wheel, kPoints, kOptional);
  f.number("turret", scores.turret, kPoints, kOptional);
  f.number("engine", scores.engine, kPoints, kOptional);
  f.number("driver", scores.driver, kPoints, kOptional);
  f.number("kill", scores.kill, kPoints, kOptional);
  f.number("in_halves", scores.in_halves, kPoints, kOptional);
  f.number("at_a_stroke", scores.at_a_stroke, kPoints, kOptional);
  f.number("clean", scores.clean, kPoints, kOptional);
  f.number("air", scores.air, kPoints, kOptional);
  f.number("struck", scores.struck, kPoints, kOptional);
  f.number("tank", scores.tank, kPoints, kOptional);
  f.value(
      "medals", [&](const JsonValue& value) { return read_medals(value, scores.medals); }, nullptr,
      kOptional);
}

static void describe(Fields& f, RulesDescription& rules) {
  f.filled_text("name", rules.name, kOptional);
  f.path("arena", rules.arena);
  f.path("player", rules.player);
  f.value(
      "waves", [&](const JsonValue& value) { return read_waves(value, f.folder(), rules); }, nullptr);
  f.object("times", rules.times, kOptional);
  f.object("laser", rules.laser, kOptional);
  f.member("difficulties", kOptional, [&](Fields& skills) {
    skills.object("easy", rules.skills[0], kOptional);
    skills.object("normal", rules.skills[1], kOptional);
    skills.object("hard", rules.skills[2], kOptional);
  });
  f.object("score", rules.scores, kOptional);
  f.whole("cars", rules.cars, 1, kMaxCars, kOptional);
  f.flag("targets", rules.targets, kOptional);
  f.value(
      "spawns", [&](const JsonValue& value) { return read_vehicles(value, f.folder(), rules.spawns); },
      nullptr, kOptional);
}

Result<RulesDescription> read_rules(const std::filesystem::path& file) {
  RulesDescription rules;
  rules.name = file.stem().string();
  rules.skills = default_skills();
  return read_described(file, std::move(rules));
}

Result<std::shared_ptr<const Rules>> load_rules(const std::filesystem::path& file, const Progress* progress,
                                                const std::filesystem::path& player_file,
                                                const std::filesystem::path& arena_file) {
  auto description = read_rules(file);
  if (!description) return description.error();
  if (!player_file.empty()) description->player = player_file;
  const bool elsewhere =
      !arena_file.empty() && arena_file.lexically_normal() != description->arena.lexically_normal();
  if (elsewhere) description->arena = arena_file;
  auto rules = std::make_shared<Rules>();
  rules->description = std::move(*description);
  rules->file = file;
  rules->player_file = player_file;
  if (elsewhere) rules->arena_file = arena_file;
  const RulesDescription& what = rules->description;
  size_t vehicles = 1 + what.spawns.size();
  for (const auto& wave : what.waves) vehicles += wave.size();
  ProgressShares shares(progress);
  const Progress of_arena = shares.next(0.2);
  auto arena_description = read_arena(what.arena);
  if (!arena_description) return arena_description.error();
  if (const Status placed = check_starts(file, what, *arena_description); !placed) return placed.error();
  if (elsewhere) rules->description.name += ", " + arena_description->name;
  auto arena = load_arena(std::move(*arena_description), &of_arena);
  if (!arena) return arena.error();
  rules->arena = std::move(*arena);
  Garage garage;
  const auto next = [&](const std::filesystem::path& name) {
    const Progress loading = shares.next(0.8 / static_cast<double>(vehicles));
    return garage.vehicle(name, &loading);
  };
  auto player = next(what.player);
  if (!player) return player.error();
  rules->player = *player;
  for (const auto& wave : what.waves) {
    auto& models = rules->waves.emplace_back();
    for (const auto& name : wave) {
      auto model = next(name);
      if (!model) return model.error();
      models.push_back(*model);
    }
  }
  for (const auto& name : what.spawns) {
    auto model = next(name);
    if (!model) return model.error();
    rules->spawns.push_back(*model);
  }
  return std::shared_ptr<const Rules>(std::move(rules));
}

Vec3 middle_of(const Body& body) {
  const Bounds box = body.bounds();
  return body.placement.to_world(0.5 * (box.min + box.max));
}

void Tally::add_event(Event event, double points) {
  const bool to_enemy = event.vehicle != kPlayer && event.vehicle != Event::kNobody;
  if (!to_enemy || event.by != kPlayer) {
    events_.push_back(event);
    return;
  }
  event.combo = combo_of(event);
  award(event, points * static_cast<double>(event.combo));
}

void Tally::award(Event event, double points) {
  event.points = points;
  standing_.score += points;
  events_.push_back(event);
}

// The number of different parts within the last seconds, for the event of a part.
size_t Tally::combo_of(const Event& event) {
  using Kind = Event::Kind;
  const bool is_part = event.kind == Kind::kWheelLost || event.kind == Kind::kTurretLost ||
                       event.kind == Kind::kVitalLost || event.kind == Kind::kInHalves;
  if (!is_part) return 1;
  const Ticks now = standing_.ticks;
  std::erase_if(hits_, [&](const Hit& hit) { return seconds_of_ticks(now - hit.tick) > kComboSeconds; });
  const bool known = std::ranges::any_of(
      hits_, [&](const Hit& hit) { return hit.kind == event.kind && hit.part == event.part; });
  if (!known) hits_.push_back({now, event.kind, event.part});
  return std::clamp<size_t>(hits_.size(), 1, kMaxCombo);
}

void Tally::record_cut(size_t shooter, size_t victim, BodyId id, const Body& body, const StepResult& cut) {
  standing_.faces_removed += cut.delta.removed_faces;
  Vec3 at = middle_of(body);
  for (const BodyDelta& b : cut.delta.bodies) {
    if (!b.removed.empty()) at = body.placement.to_world(b.removed.front().corners[0]);
  }
  add_event({Event::Kind::kCut, victim, shooter, 0, id, at, cut.delta.removed_mass});
  if (victim == Event::kNobody) return;
  KERF_ASSERT(victim < records_.size());
  Record& record = records_[victim];
  record.last_cut_by = shooter;
  record.changed = true;
  if (shooter == kPlayer && record.first_stroke == 0) record.first_stroke = strokes_;
}

void Tally::blame(size_t victim, size_t by) {
  KERF_ASSERT(victim < records_.size());
  records_[victim].last_cut_by = by;
  records_[victim].changed = true;
}

void Tally::record_piece(const Detached& piece, const Body& body, size_t victim, const Vehicle* vehicle,
                         bool clean, const Vec3& across) {
  ++standing_.pieces;
  const double area = area_of(body);
  Event event{Event::Kind::kPieceOff, victim, Event::kNobody, 0, piece.to, middle_of(body), area};
  event.across = across;
  if (!vehicle) return add_event(event);
  event.by = records_[victim].last_cut_by;
  records_[victim].changed = true;
  standing_.pieces_cut += victim != kPlayer && event.by == kPlayer;
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
  KERF_ASSERT(index < records_.size() && vehicle.model);
  Record& record = records_[index];
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
  // The turret and its laser score once in all.
  const auto score_of_laser = [&]() -> double {
    const bool is_paid = record.disarmed;
    record.disarmed = is_paid || record.last_cut_by == kPlayer;
    return is_paid ? 0 : scores_->turret;
  };
  if (damage.turret) lost(Event::Kind::kTurretLost, vehicle.gun.turret, 0, score_of_laser());
  if (damage.barrel) lost(Event::Kind::kBarrelLost, vehicle.gun.barrel, 0, score_of_laser());
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
