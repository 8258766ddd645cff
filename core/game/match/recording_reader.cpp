#include <fstream>

#include "core/document/hash_text.h"
#include "core/document/json_value.h"
#include "core/game/json_fields.h"
#include "core/game/match/recording.h"

namespace kerf {

namespace {

constexpr size_t kMostTicks = 36'000 * kTicksPerSecond;

Status parse_head(const JsonValue& head, const std::filesystem::path& folder, Recording& recording) {
  std::string kind, rules, files, difficulty;
  double seed = 0;
  JsonFields fields(head);
  fields.text("kerf", kind, true)
      .count("version", recording.version, 1, kMatchVersion, true)
      .text("rules", rules, true);
  fields.text("files", files, true).number("seed", seed, {0, 1e18}, true);
  fields.text("difficulty", difficulty, true);
  if (!fields.status()) return fields.status();
  if (kind != "match") return head["kerf"].wrong("this is no recording of a match");
  const auto hash = parse_hash(files);
  if (!hash) return head["files"].wrong("must be sixteen hexadecimal digits");
  const auto named = parse_difficulty(difficulty);
  if (!named) return head["difficulty"].wrong("must be \"easy\", \"normal\" or \"hard\"");
  if (!head["seed"].json().is_number_unsigned()) return head["seed"].wrong("must be a whole number");
  recording.rules = folder / rules;
  recording.files = *hash;
  recording.seed = head["seed"].json().get<uint64_t>();
  recording.difficulty = *named;
  return Done{};
}

// A whole number within limits, of an element of a run.
template <typename T>
bool take(const nlohmann::json& run, size_t i, int64_t least, int64_t most, T& out) {
  if (!run[i].is_number_integer()) return false;
  const auto n = run[i].get<int64_t>();
  out = static_cast<T>(n);
  return n >= least && n <= most;
}

Status parse_run(const JsonValue& value, std::vector<Controls>& controls) {
  const nlohmann::json& run = value.json();
  constexpr int64_t kFull = Controls::kFull, kAngle = 100'000;
  size_t ticks = 0;
  Controls c;
  const bool good = run.is_array() && run.size() == 8 && take(run, 0, 1, kTicksPerSecond, ticks) &&
                    take(run, 1, -kFull, kFull, c.throttle) && take(run, 2, -kFull, kFull, c.steer) &&
                    take(run, 3, 0, 1, c.handbrake) && take(run, 4, 0, 1, c.fire) &&
                    take(run, 5, 0, kFull, c.width) && take(run, 6, -kAngle, kAngle, c.heading) &&
                    take(run, 7, -kAngle, kAngle, c.pitch);
  if (!good) return value.wrong("must be eight whole numbers of the controls of a vehicle");
  if (controls.size() + ticks > kMostTicks) return value.wrong("is beyond ten hours");
  controls.insert(controls.end(), ticks, c);
  return Done{};
}

Status parse_line(const JsonValue& line, Recording& recording) {
  if (const Status object = line.object(); !object) return object;
  if (!line.has("hash")) {
    return JsonFields(line)
        .list(
            "inputs", "runs", [&](const JsonValue& run) { return parse_run(run, recording.controls); }, true)
        .status();
  }
  std::string hash;
  const Status parsed = JsonFields(line).text("hash", hash).text("machine", recording.machine).status();
  recording.hash = parse_hash(hash);
  if (parsed && !recording.hash) return line["hash"].wrong("must be sixteen hexadecimal digits");
  return parsed;
}

}  // namespace

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
    const auto json = parse_json(std::string_view(*text).substr(at, end - at), where);
    const Status parsed = !json         ? Status(json.error())
                          : number == 1 ? parse_head(JsonValue(*json, where), file.parent_path(), recording)
                                        : parse_line(JsonValue(*json, where), recording);
    if (!parsed && number == 1) return parsed.error();
    if (!parsed || end == std::string::npos) {
      recording.damage = where + " is damaged, and the match is read up to there";
      return recording;
    }
    at = end + 1;
  }
  if (number == 0) return bad_input(file.string() + ": the file is empty");
  return recording;
}

}  // namespace kerf
