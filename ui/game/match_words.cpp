#include "ui/game/match_words.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

const char* name_of_vital(const VehicleDescription& vehicle, size_t vital) {
  return vehicle.vitals[vital].kind == VitalDescription::Kind::kEngine ? "engine" : "driver's seat";
}

std::string name_of_wheel(const VehicleDescription& vehicle, size_t wheel) {
  std::string name = vehicle.wheels[wheel].part;  // "wheel_front_left"
  std::replace(name.begin(), name.end(), '_', ' ');
  return name.starts_with("wheel ") ? name.substr(6) + " wheel" : name;
}

std::string why_it_ended(const Match& match, size_t killer) {
  KERF_ASSERT(match.standing().over());
  if (match.standing().phase == Standing::Phase::kWon) return "All enemies are out";
  const Vehicle& own = match.vehicles()[Match::kPlayer];
  if (own.alive) return match.seconds_left() > 0 ? "You gave up" : "Time is up";
  const bool known = killer != Match::kPlayer && killer < match.vehicles().size();
  const std::string by = known ? " by the " + match.vehicles()[killer].what().name : "";
  for (size_t i = 0; i < own.vital_works.size(); ++i) {
    if (!own.vital_works[i]) return "Your " + std::string(name_of_vital(own.what(), i)) + " was cut off" + by;
  }
  return "Your car was cut to pieces" + by;
}

}  // namespace kerf
