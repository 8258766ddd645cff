#include <algorithm>

#include "core/game/angle.h"
#include "core/game/json_fields.h"
#include "core/game/match/rules.h"

namespace kerf {

namespace {

constexpr size_t kMostEnemies = 12, kMostWaves = 50;

Status parse_laser(const JsonValue& value, LaserRules& laser) {
  JsonFields fields(value);
  fields.number("range", laser.range, {1, 1000});
  fields.member("radius", [&](const JsonValue& member) -> Status {
    const auto radius = member.interval();
    if (!radius) return radius.error();
    if (radius->low < 0.001 || radius->high > 0.5) return member.wrong("must be from 0.001 to 0.5 m");
    laser.radius = *radius;
    return Done{};
  });
  double energy = 100, drain = energy * laser.drain, charge = energy * laser.charge;
  fields.number("energy", energy, {0.001, 1e9}).number("energy_per_second", drain, {0, 1e9});
  fields.number("recharge_per_second", charge, {0, 1e9});
  laser.drain = drain / energy;
  laser.charge = charge / energy;
  fields.number("heat_per_second", laser.heating, {0, 100});
  return fields.number("cooling_per_second", laser.cooling, {0.001, 100}).status();
}

Status parse_times(const JsonValue& value, MatchTimes& times) {
  JsonFields fields(value);
  fields.number("match", times.match, {1, 36'000}).number("between_waves", times.between_waves, {0.1, 60});
  return fields.number("righting", times.righting, {0.1, 60})
      .number("stuck", times.stuck, {0.1, 60})
      .status();
}

Status parse_skill(const JsonValue& value, EnemySkill& skill) {
  double error = degrees_of(skill.aim_error);
  JsonFields fields(value);
  fields.number("reaction", skill.reaction, {0, 2}).number("aim_error", error, {0, 45});
  fields.number("enemy_speed", skill.speed, {0, 1}).number("enemy_fire", skill.fire, {0, 1});
  fields.number("enemy_distance", skill.distance, {4, 60})
      .count("enemies_at_once", skill.at_once, 1, kMostEnemies);
  skill.aim_error = radians_of(error);
  return fields.status();
}

Status parse_difficulties(const JsonValue& value, std::array<EnemySkill, 3>& skills) {
  JsonFields fields(value);
  const char* const names[] = {"easy", "normal", "hard"};
  for (size_t i = 0; i < skills.size(); ++i)
    fields.member(names[i], [&](const JsonValue& skill) { return parse_skill(skill, skills[i]); });
  return fields.status();
}

Status parse_scores(const JsonValue& value, Scores& scores) {
  JsonFields fields(value);
  for (const auto& [key, score] : {std::pair{"piece", &scores.piece},
                                   {"wheel", &scores.wheel},
                                   {"turret", &scores.turret},
                                   {"engine", &scores.engine},
                                   {"driver", &scores.driver},
                                   {"kill", &scores.kill},
                                   {"in_halves", &scores.in_halves},
                                   {"at_a_stroke", &scores.at_a_stroke}})
    fields.number(key, *score, {0, 1e6});
  return fields.status();
}

Status parse_wave(const JsonValue& value, const std::filesystem::path& folder,
                  std::vector<std::filesystem::path>& wave) {
  if (const Status array = value.array("vehicle files"); !array) return array;
  if (value.json().empty() || value.json().size() > kMostEnemies)
    return value.wrong("must name 1 to " + std::to_string(kMostEnemies) + " vehicle files");
  for (size_t i = 0; i < value.json().size(); ++i) {
    const auto name = value[i].text();
    if (!name) return name.error();
    wave.push_back(folder / *name);
  }
  return Done{};
}

std::array<EnemySkill, 3> default_skills() {
  return {EnemySkill{0.9, 0.105, 0.7, 0.35}, EnemySkill{}, EnemySkill{0.3, 0.03, 1, 1}};
}

}  // namespace

Result<RulesDescription> read_rules(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  const auto json = parse_json(*text, file.string());
  if (!json) return json.error();
  const JsonValue root(*json, file.string());
  const std::filesystem::path folder = file.parent_path();
  RulesDescription rules;
  rules.name = file.stem().string();
  rules.skills = default_skills();
  std::string arena, player;
  JsonFields fields(root);
  fields.text("name", rules.name).text("arena", arena, true).text("player", player, true);
  fields.list(
      "waves", "waves", [&](const JsonValue& v) { return parse_wave(v, folder, rules.waves.emplace_back()); },
      true);
  fields.member("times", [&](const JsonValue& v) { return parse_times(v, rules.times); });
  fields.member("laser", [&](const JsonValue& v) { return parse_laser(v, rules.laser); });
  fields.member("difficulties", [&](const JsonValue& v) { return parse_difficulties(v, rules.skills); });
  fields.member("score", [&](const JsonValue& v) { return parse_scores(v, rules.scores); });
  if (!fields.status()) return fields.status().error();
  if (rules.waves.size() > kMostWaves)
    return root["waves"].wrong("must hold no more than " + std::to_string(kMostWaves) + " waves");
  rules.arena = folder / arena;
  rules.player = folder / player;
  return rules;
}

}  // namespace kerf
