#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/document/json_value.h"
#include "core/world/body_state.h"

namespace kerf {

// The states of bodies in a mark of a journal, a list of {"body": [slot, generation], "position": [..],
// "orientation": [..], "velocity": [..], "spin": [..], "quiet": ticks, "asleep": true}. Numbers come back to
// the bit.
nlohmann::ordered_json body_states_json(std::span<const BodyState> states);
Result<std::vector<BodyState>> parse_body_states(const JsonValue& value);

// The pairs of bodies in such a mark, a list of [slot, generation, slot, generation, touching, crossed], for
// the ground [slot, generation, touching, crossed]: 1 where they touch, and for how many ticks they have
// intersected. The list is read back sorted by the bodies.
nlohmann::ordered_json near_pairs_json(std::span<const NearPair> pairs);
Result<std::vector<NearPair>> parse_near_pairs(const JsonValue& value);

}  // namespace kerf
