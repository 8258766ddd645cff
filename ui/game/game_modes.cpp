#include "ui/game/game_modes.h"

#include "core/base/assets.h"

namespace kerf {

namespace {

Result<std::shared_ptr<const Rules>> load(const char* rules, OwnVehicle vehicle) {
  const std::string name = kVehicleNames[static_cast<size_t>(vehicle)];
  return load_rules(assets_folder() / "games" / rules, nullptr,
                    assets_folder() / "vehicles" / (name + ".json"));
}

}  // namespace

Result<std::shared_ptr<const Rules>> load_mode(GameMode mode, OwnVehicle vehicle) {
  static constexpr std::array kRules{"standard.json", "trial.json", "sandbox.json"};
  return load(kRules[static_cast<size_t>(mode)], vehicle);
}

Result<std::shared_ptr<const Rules>> load_lesson(OwnVehicle vehicle) { return load("lesson.json", vehicle); }

}  // namespace kerf
