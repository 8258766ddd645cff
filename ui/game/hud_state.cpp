#include "ui/game/hud_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "ui/window/number_text.h"

namespace kerf {

const char* name_of_vital(const VehicleDescription& vehicle, size_t vital) {
  return vehicle.vitals[vital].kind == VitalDescription::Kind::kEngine ? "engine" : "driver's seat";
}

std::string name_of_wheel(const VehicleDescription& vehicle, size_t wheel) {
  std::string name = vehicle.wheels[wheel].part;  // "wheel_front_left"
  std::replace(name.begin(), name.end(), '_', ' ');
  return name.starts_with("wheel ") ? name.substr(6) + " wheel" : name;
}

// " by the van"; empty if no other vehicle is known.
static std::string by_whom(const Match& match, size_t vehicle) {
  const bool known = vehicle != Match::kPlayer && vehicle < match.vehicles().size();
  return known ? " by the " + match.vehicles()[vehicle].what().name : "";
}

std::string end_reason(const Match& match, size_t killer) {
  KERF_ASSERT(match.standing().over());
  if (match.standing().phase == Standing::Phase::kWon) return "All enemies wrecked";
  const Vehicle& own = match.vehicles()[Match::kPlayer];
  if (own.alive) return match.seconds_left() > 0 ? "You gave up" : "Time is up";
  const std::string by = by_whom(match, killer);
  for (size_t i = 0; i < own.vital_works.size(); ++i) {
    if (!own.vital_works[i]) return "Your " + std::string(name_of_vital(own.what(), i)) + " was cut off" + by;
  }
  return "Your car was cut to pieces" + by;
}

std::string give_up_hint(const Match& match, const std::string& control) {
  using Phase = Standing::Phase;
  const Phase phase = match.standing().phase;
  if (!match.is_disabled() || (phase != Phase::kFight && phase != Phase::kDown)) return "";
  const bool another_car = phase == Phase::kDown || match.standing().cars_left > 0;
  return "Laser lost: press " + control + (another_car ? " to take your next car" : " to end the match");
}

std::string loss_warning(const Match& match) {
  const bool has_waves = !match.rules().waves.empty() && !match.rules().description.targets;
  const std::string wave = has_waves ? "Wave " + std::to_string(match.standing().wave + 1) + " and " : "";
  const long points = std::lround(match.standing().score);
  return wave + std::to_string(points) + (points == 1 ? " point" : " points") + " will be lost.";
}

namespace {

constexpr double kNoticeSeconds = 3.2, kLargeSeconds = 2.2;
constexpr double kAgain = 1.5;  // s, within which a repeated event shares the line of the last one
constexpr size_t kMaxNotices = 6, kMaxFlying = 12;
constexpr double kPointsTogether = 1;  // m, between points that are added up
// By Loot, and by Upgrade.
constexpr std::array kLooted{"wheel replaced", "laser charged", "second beam", "armour fitted"};
constexpr std::array kUpgrades{"cooler laser", "faster charging", "armoured engine and seat"};
constexpr double kHurtFade = 1.6, kBiteFade = 6;  // 1/s

using Kind = Event::Kind;

void begin_with_capital(std::string& text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
}

constexpr double kAhead = 14, kReached = 3;  // m, destination ahead, and radius in which it counts as reached
constexpr double kEnough = 0.3;              // kg, of a drum that is not cut in two

// The place of a body: the middle of its remaining part.
Vec3 place_of(const Match& match, BodyId id) { return middle_of(match.world().body(id)); }

// Returns the nearest body that can be cut and is no larger than a drum.
BodyId nearest_drum(const Match& match, const Vec3& from) {
  constexpr double kLargest = 1.5;  // m, of the diagonal
  BodyId nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const BodyId id : match.world().ids()) {
    const Body& body = match.world().body(id);
    const bool serves = !match.is_wall(id) && match.vehicle_of(id) == Event::kNobody &&
                        body.tree.leaf_count() > 0 &&
                        glm::length(body.bounds().max - body.bounds().min) < kLargest;
    const double distance = glm::distance(middle_of(body), from);
    if (!serves || distance >= least) continue;
    least = distance;
    nearest = id;
  }
  return nearest;
}

}  // namespace

void HudState::clear() {
  notices_.clear();
  points_.clear();
  hurt_ = biting_ = 0;
}

void HudState::add_line(std::string text, double points, bool good, bool large) {
  begin_with_capital(text);
  if (!notices_.empty() && notices_.front().text == text && notices_.front().age < kAgain) {
    Notice& same = notices_.front();
    ++same.times;
    same.points += points;
    same.age = 0;
    return;
  }
  notices_.push_front({std::move(text), points, 1, 0, good, large});
  if (notices_.size() > kMaxNotices) notices_.pop_back();
}

void HudState::advance(double seconds) {
  clock_ += seconds;
  for (Notice& n : notices_) n.age += seconds;
  std::erase_if(notices_, [](const Notice& n) { return n.age > (n.large ? kLargeSeconds : kNoticeSeconds); });
  for (FlyingPoints& p : points_) p.age += seconds;
  std::erase_if(points_, [](const FlyingPoints& p) { return p.age > FlyingPoints::kSeconds; });
  hurt_ = std::max(0.0, hurt_ - kHurtFade * seconds);
  biting_ = std::max(0.0, biting_ - kBiteFade * seconds);
}

void HudState::on_tick(const Match& match) {
  for (const Event& event : match.events()) {
    on_event(match, event);
    add_points(event);
  }
}

// Points won at one place in one moment are one number. Small pieces would hide the parts.
void HudState::add_points(const Event& event) {
  if (!(event.points > 0) || event.kind == Kind::kPieceOff) return;
  if (!points_.empty() && points_.back().age == 0 &&
      glm::distance(points_.back().at, event.at) < kPointsTogether) {
    points_.back().points += event.points;
    points_.back().combo = std::max(points_.back().combo, event.combo);
    return;
  }
  points_.push_back({event.at, event.points, event.combo, 0});
  if (points_.size() > kMaxFlying) points_.pop_front();
}

void HudState::on_event(const Match& match, const Event& event) {
  // A wave that begins in the tick of the event replaces the vehicles.
  const bool known = event.vehicle < match.vehicles().size();
  const bool own = event.vehicle == Match::kPlayer;
  const VehicleDescription* what = known ? &match.vehicles()[event.vehicle].what() : nullptr;
  const std::string whose = own ? "your " : what ? "the " + what->name + "'s " : "";
  switch (event.kind) {
    case Kind::kCut:
      if (own && event.by < match.vehicles().size()) {
        hurt_ = 1;
        hurt_from_ = match.world().body(match.vehicles()[event.by].chassis).placement.position;
      } else if (event.by == Match::kPlayer && known) {
        biting_ = 1;
      }
      return;
    case Kind::kPieceOff:
      if (event.points > 0) add_line("piece cut", event.points, true);
      return;
    case Kind::kWheelLost:
      if (!what || event.part >= what->wheels.size()) return add_line("a wheel came off", event.points, !own);
      return add_line(
          own ? whose + name_of_wheel(*what, event.part) + " came off" : name_of_wheel(*what, event.part),
          event.points, !own);
    case Kind::kTurretLost:
    case Kind::kBarrelLost:
      return add_line(own || !what ? whose + "laser came off" : what->name + " disarmed", event.points, !own);
    case Kind::kVitalLost:
      if (!what || event.part >= what->vitals.size())
        return add_line("a part was cut off", event.points, !own);
      return add_line((own ? "you lost your " : "") + std::string(name_of_vital(*what, event.part)) +
                          (own ? "" : " cut out"),
                      event.points, !own);
    case Kind::kTankBurst:
      return add_line(whose + kTankName + " burst", event.points, !own, own);
    case Kind::kStruck:
      return add_line(own ? "struck by a falling part" : (what ? what->name : "enemy") + " struck",
                      event.points, !own, true);
    case Kind::kInHalves:
      return add_line(own ? "you were cut in half" : "cut in half!", event.points, !own, true);
    case Kind::kKilled:
      return add_line(own ? "wrecked" + by_whom(match, event.by) : (what ? what->name : "enemy") + " wrecked",
                      event.points, !own, true);
    case Kind::kOverheated:
      if (own) add_line("laser overheated", 0, false);
      return;
    case Kind::kRighted:
      if (own) add_line(event.part == Event::kFlipped ? "flipped upright" : "freed", 0, true);
      return;
    case Kind::kCleanPart:
      if (event.points > 0) add_line("clean cut", event.points, true);
      return;
    case Kind::kLooted:
      return add_line(kLooted[event.part], 0, true);
    case Kind::kJumped:
      return add_line(text_of("%.1f s in the air", event.size), event.points, true);
    case Kind::kUpgraded:
      return add_line(kUpgrades[event.part - 1], 0, true, true);
    case Kind::kNotSpawned:
      return add_line(event.part > 0 ? "limit of " + std::to_string(event.part) + " other cars reached"
                                     : "no room for another car",
                      0, false);
    case Kind::kCarLost:
      return add_line((event.part == 0 ? "last car in " : "next car in ") +
                          text_of("%.0f s", match.rules().description.times.between_waves),
                      0, false, true);
    case Kind::kWaveBegins:
      if (match.rules().description.targets) return;
      return add_line("wave " + std::to_string(event.part + 1), 0, true, true);
    case Kind::kWaveCleared:
      return add_line("wave cleared", event.points, true, true);
    case Kind::kWon:
    case Kind::kLost:
      return add_line(end_reason(match), 0, event.kind == Kind::kWon, true);
    case Kind::kImpact:
      return;
  }
}

Lesson::Lesson(const Match& match) {
  const Placement& own = match.world().body(match.vehicles()[Match::kPlayer].chassis).placement;
  place_ = own.to_world({0, 0, kAhead});
  drum_ = nearest_drum(match, place_);
}

std::optional<Lesson::Task> Lesson::task(const Match& match, const KeyBindings& keys, bool gamepad) const {
  switch (step_) {
    case Step::kDrive:
      return Task{"Drive to the marker (" + drive_label(keys, gamepad) + ")", place_};
    case Step::kDrum:
      return Task{std::string(gamepad ? "Aim with the right stick and hold the right trigger"
                                      : "Aim with the mouse and hold the left button") +
                      " to cut the drum in half",
                  place_of(match, drum_)};
    case Step::kWheel:
      return Task{"Get within 18 m of this car and sweep the beam through a wheel hub",
                  place_of(match, match.vehicles().back().chassis)};
    case Step::kDone:
      break;
  }
  return std::nullopt;
}

bool Lesson::is_done(const Match& match) {
  const Vehicle& own = match.vehicles()[Match::kPlayer];
  switch (step_) {
    case Step::kDrive:
      return glm::distance(match.world().body(own.chassis).placement.position, place_) < kReached;
    case Step::kDrum:
      for (const Event& e : match.events()) {
        if (e.kind == Event::Kind::kCut && e.body == drum_) drum_removed_ += e.size;
      }
      return !drum_.valid() || !match.world().contains(drum_) || drum_removed_ > kEnough ||
             std::ranges::any_of(match.delta().detached, [&](const Detached& d) { return d.from == drum_; });
    case Step::kWheel: {
      // The player may have wrecked the car, or cut off all its wheels, before this task.
      const Vehicle& car = match.vehicles().back();
      return !car.alive || car.wheels_attached() == 0 ||
             std::ranges::any_of(match.events(), [](const Event& e) {
               return e.vehicle != Match::kPlayer && e.kind == Event::Kind::kWheelLost;
             });
    }
    case Step::kDone:
      break;
  }
  return false;
}

bool Lesson::on_tick(const Match& match) {
  if (!is_done(match)) return false;
  step_ = static_cast<Step>(static_cast<int>(step_) + 1);
  if (step_ == Step::kDrum && !drum_.valid()) step_ = Step::kWheel;
  return true;
}

std::string clock_text(double seconds) {
  const int whole = static_cast<int>(std::max(0.0, seconds));
  return text_of("%d:%02d", whole / 60, whole % 60);
}

}  // namespace kerf
