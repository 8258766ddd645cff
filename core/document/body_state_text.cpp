#include "core/document/body_state_text.h"

#include <algorithm>

namespace kerf {

namespace {

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

nlohmann::ordered_json near_pairs_json(std::span<const NearPair> pairs) {
  auto list = nlohmann::ordered_json::array();
  for (const NearPair& p : pairs) {
    auto& entry = list.emplace_back(nlohmann::ordered_json{p.first.slot, p.first.generation});
    if (p.second.valid()) {
      entry.push_back(p.second.slot);
      entry.push_back(p.second.generation);
    }
    entry.push_back(p.touching ? 1 : 0);
    entry.push_back(p.crossed);
  }
  return list;
}

Result<std::vector<NearPair>> parse_near_pairs(const JsonValue& value) {
  if (!value.json().is_array()) return value.wrong("must be a list");
  std::vector<NearPair> pairs;
  for (size_t i = 0; i < value.json().size(); ++i) {
    const nlohmann::json& entry = value[i].json();
    const bool ground = holds_whole_numbers(entry, 4);
    if (!ground && !holds_whole_numbers(entry, 6))
      return value[i].wrong("must be four or six whole numbers: one body or two, and how they touch");
    NearPair& pair = pairs.emplace_back();
    pair.first = {entry[0], entry[1]};
    if (!ground) pair.second = {entry[2], entry[3]};
    const size_t state = ground ? 2 : 4;
    pair.touching = entry[state] != 0;
    pair.crossed = entry[state + 1];
  }
  std::sort(pairs.begin(), pairs.end(), [](const NearPair& a, const NearPair& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  return pairs;
}

}  // namespace kerf
