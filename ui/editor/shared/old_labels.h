#pragma once

#include <nlohmann/json_fwd.hpp>

namespace kerf {

// Replaces the labels in settings of version 1, whose keys they were, by the ids of actions, panels and tabs.
// Keys that are not labels of that version stay.
void convert_labels(nlohmann::json& settings);

}  // namespace kerf
