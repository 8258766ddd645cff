#include "core/game/match/rules.h"

#include <map>

#include "core/game/vehicle/vehicle_file.h"

namespace kerf {

namespace {

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

}  // namespace

Result<std::shared_ptr<const Rules>> load_rules(const std::filesystem::path& file, const Progress* progress) {
  auto description = read_rules(file);
  if (!description) return description.error();
  auto rules = std::make_shared<Rules>();
  rules->description = std::move(*description);
  const RulesDescription& what = rules->description;
  size_t vehicles = 1;
  for (const auto& wave : what.waves) vehicles += wave.size();
  Stages stages(progress);
  const Progress of_arena = stages.next(0.2);
  auto arena_description = read_arena(what.arena);
  if (!arena_description) return arena_description.error();
  auto arena = load_arena(std::move(*arena_description), &of_arena);
  if (!arena) return arena.error();
  rules->arena = std::move(*arena);
  Garage garage;
  const auto next = [&](const std::filesystem::path& name) {
    const Progress loading = stages.next(0.8 / static_cast<double>(vehicles));
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
  return std::shared_ptr<const Rules>(std::move(rules));
}

}  // namespace kerf
