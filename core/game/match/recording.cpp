#include "core/game/match/recording.h"

#include <algorithm>
#include <fstream>
#include <map>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "core/base/random.h"
#include "core/document/text/fields.h"
#include "core/document/text/hash.h"
#include "core/document/text/json.h"
#include "core/game/vehicle/vehicle_model.h"

namespace kerf {

namespace {

constexpr const char* kNames[] = {"easy", "normal", "hard"};
constexpr int64_t kMaxButtons = 15 + 16 * Controls::kUpgrades;
constexpr size_t kMaxTicks = kMaxSeconds * kTicksPerSecond;

// The JSON of `ticks` ticks with equal controls.
nlohmann::ordered_json run_json(const Controls& c, size_t ticks) {
  const int buttons =
      (c.handbrake ? 1 : 0) + (c.spawn ? 2 : 0) + (c.give_up ? 4 : 0) + (c.boost ? 8 : 0) + 16 * c.upgrade;
  return {ticks, c.throttle, c.steer, buttons, c.fire ? 1 : 0, c.width, c.heading, c.pitch};
}

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

// Reads element `i` of a run, a whole number within limits, of which `most` is not negative.
template <typename T>
bool take(const nlohmann::json& run, size_t i, int64_t least, int64_t most, T& out) {
  if (!run[i].is_number_integer()) return false;
  // Numbers from 2^63 on would become negative.
  if (run[i].is_number_unsigned() && run[i].get<uint64_t>() > static_cast<uint64_t>(most)) return false;
  const auto n = run[i].get<int64_t>();
  out = static_cast<T>(n);
  return n >= least && n <= most;
}

Status parse_run(const JsonValue& value, std::vector<Controls>& controls) {
  const nlohmann::json& run = value.json();
  constexpr int64_t kFull = Controls::kFull, kAngle = 100'000;
  size_t ticks = 0;
  uint8_t buttons = 0;
  Controls c;
  const bool good = run.is_array() && run.size() == 8 && take(run, 0, 1, kTicksPerSecond, ticks) &&
                    take(run, 1, -kFull, kFull, c.throttle) && take(run, 2, -kFull, kFull, c.steer) &&
                    take(run, 3, 0, kMaxButtons, buttons) && take(run, 4, 0, 1, c.fire) &&
                    take(run, 5, 0, kFull, c.width) && take(run, 6, -kAngle, kAngle, c.heading) &&
                    take(run, 7, -kAngle, kAngle, c.pitch);
  if (!good) return value.wrong("must be eight whole numbers of the controls of a vehicle");
  c.handbrake = buttons % 2 == 1;
  c.spawn = buttons / 2 % 2 == 1;
  c.give_up = buttons / 4 % 2 == 1;
  c.boost = buttons / 8 % 2 == 1;
  c.upgrade = buttons / 16;
  if (controls.size() + ticks > kMaxTicks) return value.wrong("exceeds the limit of ten hours");
  controls.insert(controls.end(), ticks, c);
  return Done{};
}

Status parse_runs(const JsonValue& value, Recording& recording) {
  if (const Status list = value.array("runs"); !list) return list;
  for (size_t i = 0; i < value.json().size(); ++i) {
    if (const Status run = parse_run(value[i], recording.controls); !run) return run;
  }
  return Done{};
}

void describe_head(Fields& f, Recording& recording) {
  std::string kind = "match";
  f.text("kerf", kind);
  f.check(kind == "match", "kerf", "not a recording of a match");
  f.value(
      "format",
      [](const JsonValue& format) -> Status {
        const bool is_old = format.json().is_number_unsigned() && format.json() < kRecordingFormat;
        if (!is_old) return Done{};
        return format.wrong(
            "the match was recorded by an earlier build of Kerf, whose matches differ: replay it with that "
            "build");
      },
      [] { return nlohmann::ordered_json(kRecordingFormat); }, kOptional);
  f.format(kRecordingFormat);
  f.path("rules", recording.rules);
  if (f.present("player", !recording.player.empty())) f.path("player", recording.player);
  if (f.present("arena", !recording.arena.empty())) f.path("arena", recording.arena);
  f.coded("files", recording.files, parse_hash, hash_text, kHashRule);
  f.whole("seed", recording.seed, 0, kMaxSeed);
  f.choice("difficulty", recording.difficulty, kNames);
}

void describe_end(Fields& f, Recording& recording) {
  uint64_t hash = recording.hash.value_or(0);
  f.coded("hash", hash, parse_hash, hash_text, kHashRule);
  f.text("machine", recording.machine, kOptional);
  if (f.good()) recording.hash = hash;
}

// Line `number`, from 1, which is the head.
void describe_line(Fields& f, size_t number, Recording& recording) {
  if (number == 1) return describe_head(f, recording);
  if (f.present("hash", false)) return describe_end(f, recording);
  f.value(
      "inputs", [&](const JsonValue& runs) { return parse_runs(runs, recording); }, nullptr);
}

}  // namespace

const char* name_of(Difficulty difficulty) { return kNames[static_cast<size_t>(difficulty)]; }

std::optional<Difficulty> parse_difficulty(std::string_view name) {
  for (size_t i = 0; i < std::size(kNames); ++i) {
    if (name == kNames[i]) return static_cast<Difficulty>(i);
  }
  return std::nullopt;
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

Result<std::vector<std::filesystem::path>> files_of_match(const std::filesystem::path& rules_file,
                                                          const RulesDescription& rules) {
  std::vector<std::filesystem::path> vehicles{rules.player};
  for (const auto& wave : rules.waves) vehicles.insert(vehicles.end(), wave.begin(), wave.end());
  vehicles.insert(vehicles.end(), rules.spawns.begin(), rules.spawns.end());
  // Absolute paths, because a replay may name the same files by other relative ones.
  const auto once = [](std::vector<std::filesystem::path>& files) {
    for (std::filesystem::path& file : files) file = std::filesystem::absolute(file).lexically_normal();
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
  return files;
}

Result<uint64_t> hash_of_files(const std::filesystem::path& rules_file, const RulesDescription& rules) {
  const auto files = files_of_match(rules_file, rules);
  if (!files) return files.error();
  uint64_t all = 0;
  for (const std::filesystem::path& file : *files) {
    const auto hash = file_hash(file);
    if (!hash) return hash.error();
    all = hash_combine(all, *hash);
  }
  return all;
}

bool is_recording(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string expected = R"({"kerf":"match")";
  std::string start(expected.size(), '\0');
  return stream.read(start.data(), static_cast<std::streamsize>(start.size())) && start == expected;
}

Result<Recording> read_recording(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  Recording recording;
  size_t number = 0;
  for (size_t at = 0; at < text->size();) {
    const size_t end = text->find('\n', at);
    const std::string where = file.string() + ": line " + std::to_string(++number);
    const std::string_view line = std::string_view(*text).substr(at, end - at);
    const Status parsed = read_text_fields(line, where, file.parent_path(),
                                           [&](Fields& f) { describe_line(f, number, recording); });
    if (!parsed && number == 1) return parsed.error();
    if (!parsed || end == std::string::npos) {
      recording.torn = end == std::string::npos;
      recording.damage = where + " is damaged; the recording was read up to there";
      return recording;
    }
    at = end + 1;
  }
  if (number == 0) return bad_input(file.string() + ": the file is empty");
  return recording;
}

void ScoreLog::on_tick(const Match& match) {
  const Standing& standing = match.standing();
  const WaveStart& start = match.wave_start();
  if (waves_.empty() || waves_.back().standing.ticks != start.standing.ticks) waves_.push_back(start);
  ticks_ = standing.elapsed();
  for (const Event& event : match.events()) {
    if (event.points > 0 && event.vehicle != Match::kPlayer)
      scored_.push_back({standing.ticks, waves_.size() - 1, event.vehicle, event.points});
  }
}

// The moment of a wave that ends kAfterwards after `last`, or with the wave.
MatchMoment ScoreLog::around(size_t wave, Ticks last) const {
  KERF_ASSERT(wave < waves_.size());
  const Ticks begins = waves_[wave].standing.ticks;
  const Ticks ends = wave + 1 < waves_.size() ? waves_[wave + 1].standing.ticks - 1 : ticks_;
  MatchMoment moment{waves_[wave]};
  moment.to = std::min(last + kAfterwards, ends);
  moment.from = std::max(begins, moment.to - std::min(moment.to, kMoment));
  return moment;
}

std::optional<MatchMoment> ScoreLog::best() const {
  if (waves_.empty() || ticks_ == 0) return std::nullopt;
  MatchMoment best = around(waves_.size() - 1, ticks_);
  size_t first = 0;
  double sum = 0;
  for (size_t last = 0; last < scored_.size(); ++last) {
    sum += scored_[last].points;
    const MatchMoment moment = around(scored_[last].wave, scored_[last].tick);
    while (first <= last && (scored_[first].wave != scored_[last].wave || scored_[first].tick <= moment.from))
      sum -= scored_[first++].points;
    if (first > last || sum <= best.points) continue;
    best = moment;
    best.points = sum;
    std::map<size_t, double> by_vehicle;
    for (size_t i = first; i <= last; ++i) by_vehicle[scored_[i].vehicle] += scored_[i].points;
    best.vehicle = std::max_element(by_vehicle.begin(), by_vehicle.end(), [](const auto& a, const auto& b) {
                     return a.second < b.second;
                   })->first;
  }
  return best;
}

std::unique_ptr<Match> match_at(const MatchSetup& setup, const WaveStart& start,
                                std::span<const Controls> controls, Ticks ticks,
                                const std::function<bool()>& stop) {
  KERF_ASSERT(start.standing.ticks <= ticks && static_cast<size_t>(ticks) <= controls.size());
  auto match = std::make_unique<Match>(setup, start);
  while (match->standing().elapsed() < ticks && !match->settled()) {
    if (stop()) return nullptr;
    match->tick(controls[static_cast<size_t>(match->standing().elapsed())]);
  }
  return match;
}

}  // namespace kerf
