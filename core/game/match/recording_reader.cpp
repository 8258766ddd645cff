#include <fstream>

#include "core/document/text/fields.h"
#include "core/document/text/json_value.h"
#include "core/game/match/recording.h"

namespace kerf {

namespace {

constexpr size_t kMostTicks = 36'000 * kTicksPerSecond;

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

Status parse_runs(const JsonValue& value, Recording& recording) {
  if (const Status list = value.array("runs"); !list) return list;
  for (size_t i = 0; i < value.json().size(); ++i) {
    if (const Status run = parse_run(value[i], recording.controls); !run) return run;
  }
  return Done{};
}

// Line `number`, from 1, which is the head.
void describe_line(Fields& f, size_t number, Recording& recording) {
  if (number == 1) return describe_head(f, recording);
  if (f.present("hash", false)) return describe_end(f, recording);
  f.value(
      "inputs", [&](const JsonValue& runs) { return parse_runs(runs, recording); }, nullptr);
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
    const std::string_view line = std::string_view(*text).substr(at, end - at);
    const Status parsed = read_text_fields(line, where, file.parent_path(),
                                           [&](Fields& f) { describe_line(f, number, recording); });
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
