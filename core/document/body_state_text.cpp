#include "core/document/body_state_text.h"

#include <algorithm>

namespace kerf {

namespace {

nlohmann::ordered_json vector_json(const Vec3& v) { return {v.x, v.y, v.z}; }

// A list of whole numbers without sign.
bool holds_whole_numbers(const nlohmann::json& json, size_t count) {
  if (!json.is_array() || json.size() != count) return false;
  return std::all_of(json.begin(), json.end(),
                     [](const auto& n) { return n.is_number_unsigned() && n < BodyId::kNone; });
}

Result<BodyState> parse_body_state(const JsonValue& value) {
  for (const char* key : {"body", "position", "orientation", "velocity", "spin", "quiet", "asleep"}) {
    if (!value.has(key)) return value.wrong(std::string("needs \"") + key + "\"");
  }
  BodyState state;
  if (!holds_whole_numbers(value["body"].json(), 2))
    return value["body"].wrong("must be two whole numbers: a body's slot and its generation");
  state.id = {value["body"].json()[0], value["body"].json()[1]};
  const auto orientation = value["orientation"].orientation();
  if (!orientation) return orientation.error();
  state.placement.orientation = *orientation;
  const std::pair<const char*, Vec3*> vectors[] = {{"position", &state.placement.position},
                                                   {"velocity", &state.motion.velocity},
                                                   {"spin", &state.motion.spin}};
  for (const auto& [key, to] : vectors) {
    const auto v = value[key].vector();
    if (!v) return v.error();
    *to = *v;
  }
  const nlohmann::json &quiet = value["quiet"].json(), &asleep = value["asleep"].json();
  if (!quiet.is_number_unsigned() || quiet >= BodyId::kNone)
    return value["quiet"].wrong("must be a whole number");
  if (!asleep.is_boolean()) return value["asleep"].wrong("must be true or false");
  state.motion.quiet = quiet;
  state.motion.asleep = asleep;
  return state;
}

}  // namespace

nlohmann::ordered_json body_states_json(std::span<const BodyState> states) {
  auto list = nlohmann::ordered_json::array();
  for (const BodyState& s : states) {
    const glm::dquat& q = s.placement.orientation;
    list.push_back({{"body", {s.id.slot, s.id.generation}},
                    {"position", vector_json(s.placement.position)},
                    {"orientation", {q.w, q.x, q.y, q.z}},
                    {"velocity", vector_json(s.motion.velocity)},
                    {"spin", vector_json(s.motion.spin)},
                    {"quiet", s.motion.quiet},
                    {"asleep", s.motion.asleep}});
  }
  return list;
}

Result<std::vector<BodyState>> parse_body_states(const JsonValue& value) {
  if (!value.json().is_array()) return value.wrong("must be a list");
  std::vector<BodyState> states;
  for (size_t i = 0; i < value.json().size(); ++i) {
    auto state = parse_body_state(value[i]);
    if (!state) return state.error();
    states.push_back(std::move(*state));
  }
  return states;
}

}  // namespace kerf
