#include "core/document/commands/command_reader.h"

#include <cstdio>

#include "core/base/unit_vector.h"
#include "core/document/settings_text.h"

namespace kerf {

Result<CutSettings> CommandReader::settings() const { return parse_settings(line_["settings"]); }

Result<Pose> CommandReader::pose() const {
  const auto origin = line_["origin"].vector();
  if (!origin) return origin.error();
  const auto direction = line_["direction"].vector();
  if (!direction) return direction.error();
  if (!is_unit_length2(glm::dot(*direction, *direction)))
    return line_["direction"].wrong("must have length 1");
  return Pose{*origin, *direction};
}

Result<Pose> CommandReader::next_pose() const {
  const auto next = pose();
  if (next && beam_ && are_opposite(beam_->pose.direction, next->direction))
    return line_["direction"].wrong("is opposite to the one before");
  return next;
}

Result<double> CommandReader::time() const {
  if (!line_.has("t")) return 0.0;
  const auto t = line_["t"].number();
  if (!t) return t;
  if (!(*t >= (beam_ ? beam_->time : 0))) return line_["t"].wrong("must not be before the pose before");
  return t;
}

// [slot, generation, label]; or [number, label], as journals had it before bodies had generations.
Result<PieceId> CommandReader::piece() const {
  const JsonValue piece = line_["piece"];
  const nlohmann::json& json = piece.json();
  const auto wrong = piece.wrong("must be three whole numbers: a body's slot, its generation and a label");
  if (!json.is_array() || (json.size() != 2 && json.size() != 3)) return wrong;
  for (const nlohmann::json& n : json) {
    if (!n.is_number_unsigned() || n.get<uint64_t>() >= BodyId::kNone) return wrong;
  }
  const uint32_t slot = json.front().get<uint32_t>(), label = json.back().get<uint32_t>();
  const uint32_t generation = json.size() == 3 ? json[1].get<uint32_t>() : BodyId::kUnknownGeneration;
  return PieceId{{slot, generation}, label};
}

Result<Placement> CommandReader::placement() const {
  const auto position = line_["position"].vector();
  if (!position) return position.error();
  const auto turn = line_["orientation"].orientation();
  if (!turn) return turn.error();
  return Placement{*position, *turn};
}

Result<std::filesystem::path> CommandReader::mesh() const {
  const auto file = line_["mesh"].text();
  if (!file) return file.error();
  return folder_ / *file;
}

Result<uint64_t> CommandReader::whole_number(const char* key, uint64_t least, uint64_t most) const {
  const nlohmann::json& json = line_[key].json();
  if (json.is_number_unsigned() && json.get<uint64_t>() >= least && json.get<uint64_t>() <= most)
    return json.get<uint64_t>();
  return line_[key].wrong("must be a whole number from " + std::to_string(least) + " to " +
                          std::to_string(most));
}

Result<double> CommandReader::positive_number(const char* key) const {
  const auto number = line_[key].number();
  if (number && !(*number > 0)) return line_[key].wrong("must be more than 0");
  return number;
}

Result<double> CommandReader::number_within(const char* key, double least, double most) const {
  const auto number = line_[key].number();
  if (!number || (*number >= least && *number <= most)) return number;
  char range[64];
  std::snprintf(range, sizeof range, "must be from %g to %g", least, most);
  return line_[key].wrong(range);
}

Result<bool> CommandReader::flag(const char* key) const {
  if (!line_[key].json().is_boolean()) return line_[key].wrong("must be true or false");
  return line_[key].json().get<bool>();
}

Result<size_t> CommandReader::choice(const char* key, std::span<const char* const> names) const {
  const auto name = text(key);
  if (!name) return name.error();
  std::string all;
  for (size_t i = 0; i < names.size(); ++i) {
    if (*name == names[i]) return i;
    all += (all.empty() ? "" : ", ") + std::string(names[i]);
  }
  return line_[key].wrong("must be one of " + all);
}

}  // namespace kerf
