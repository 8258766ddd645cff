#include "core/game/match/recording.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/hash.h"
#include "core/document/files/file_hash.h"
#include "core/document/text/fields.h"
#include "core/document/text/hash_text.h"
#include "core/document/text/json_text.h"
#include "core/game/vehicle/vehicle_file.h"

namespace kerf {

namespace {

constexpr const char* kNames[] = {"easy", "normal", "hard"};
constexpr uint64_t kMostSeed = 1'000'000'000'000'000'000;

// The controls of `ticks` equal ticks.
nlohmann::ordered_json run_json(const Controls& c, size_t ticks) {
  return {ticks, c.throttle, c.steer, c.handbrake ? 1 : 0, c.fire ? 1 : 0, c.width, c.heading, c.pitch};
}

// The controls of one second.
std::string inputs_line(std::span<const Controls> controls) {
  nlohmann::ordered_json runs = nlohmann::ordered_json::array();
  for (size_t i = 0; i < controls.size();) {
    size_t end = i + 1;
    while (end < controls.size() && controls[end] == controls[i]) ++end;
    runs.push_back(run_json(controls[i], end - i));
    i = end;
  }
  return nlohmann::ordered_json{{"inputs", runs}}.dump() + "\n";
}

}  // namespace

const char* name_of(Difficulty difficulty) { return kNames[static_cast<size_t>(difficulty)]; }

std::optional<Difficulty> parse_difficulty(std::string_view name) {
  for (size_t i = 0; i < std::size(kNames); ++i) {
    if (name == kNames[i]) return static_cast<Difficulty>(i);
  }
  return std::nullopt;
}

void describe_head(Fields& f, Recording& recording) {
  std::string kind = "match";
  f.text("kerf", kind);
  f.check(kind == "match", "kerf", "this is no recording of a match");
  f.version("version", recording.version, kMatchVersion);
  f.path("rules", recording.rules);
  f.coded("files", recording.files, parse_hash, hash_text, kHashRule);
  f.whole("seed", recording.seed, 0, kMostSeed);
  f.choice("difficulty", recording.difficulty, kNames);
}

void describe_end(Fields& f, Recording& recording) {
  uint64_t hash = recording.hash.value_or(0);
  f.coded("hash", hash, parse_hash, hash_text, kHashRule);
  f.text("machine", recording.machine, kOptional);
  if (f.good()) recording.hash = hash;
}

Result<std::string> recording_text(const Recording& recording, const std::filesystem::path& folder) {
  Recording written = recording;
  auto text = dump_json(visited_json(folder, [&](Fields& f) { describe_head(f, written); }));
  if (!text) return text.error();
  *text += "\n";
  const std::span<const Controls> all(recording.controls);
  for (size_t i = 0; i < all.size(); i += kTicksPerSecond)
    *text += inputs_line(all.subspan(i, std::min<size_t>(kTicksPerSecond, all.size() - i)));
  if (recording.hash)
    *text += visited_json(folder, [&](Fields& f) { describe_end(f, written); }).dump() + "\n";
  return text;
}

Result<uint64_t> hash_of_files(const std::filesystem::path& rules_file, const RulesDescription& rules) {
  std::vector<std::filesystem::path> vehicles{rules.player};
  for (const auto& wave : rules.waves) vehicles.insert(vehicles.end(), wave.begin(), wave.end());
  const auto once = [](std::vector<std::filesystem::path>& files) {
    for (std::filesystem::path& file : files) file = file.lexically_normal();
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
  };
  once(vehicles);
  std::vector<std::filesystem::path> meshes;
  for (const std::filesystem::path& file : vehicles) {
    auto vehicle = read_vehicle(file);
    if (!vehicle) return vehicle.error();
    meshes.push_back(vehicle->body.mesh);
  }
  auto arena = read_arena(rules.arena);
  if (!arena) return arena.error();
  for (const ArenaBody& body : arena->bodies) meshes.push_back(body.body.mesh);
  once(meshes);
  std::vector<std::filesystem::path> files{rules_file, rules.arena};
  files.insert(files.end(), vehicles.begin(), vehicles.end());
  files.insert(files.end(), meshes.begin(), meshes.end());
  uint64_t all = 0;
  for (const std::filesystem::path& file : files) {
    const auto hash = file_hash(file);
    if (!hash) return hash.error();
    all = hash_combine(all, *hash);
  }
  return all;
}

}  // namespace kerf
