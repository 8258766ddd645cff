#pragma once

#include <array>
#include <filesystem>

#include "core/base/result.h"
#include "core/game/match/rules.h"

namespace kerf {

// What is played.
enum class GameMode {
  kWaves,    // the standard match
  kTrial,    // a vehicle to take apart against the clock
  kSandbox,  // no enemies; vehicles to cut come when they are asked for
};
inline constexpr std::array kModeNames{"waves", "trial", "sandbox"};
inline constexpr std::array kModeTitles{"Waves", "Time trial", "Sandbox"};

// What the player drives.
enum class OwnVehicle { kHatchback, kBuggy, kPickup, kVan };
inline constexpr std::array kVehicleNames{"hatchback", "buggy", "pickup", "van"};
inline constexpr std::array kVehicleTitles{"Hatchback", "Buggy", "Pick-up", "Van"};

// Loads the rules of a mode with the vehicle that the player drives. Fails like load_rules().
Result<std::shared_ptr<const Rules>> load_mode(GameMode mode, OwnVehicle vehicle);

// Loads the rules of the lesson (see Lesson).
Result<std::shared_ptr<const Rules>> load_lesson(OwnVehicle vehicle);

}  // namespace kerf
