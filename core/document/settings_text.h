#pragma once

#include <string>

#include "core/cut/cut_step.h"
#include "core/document/json_value.h"

namespace kerf {

// The settings of a stroke as a JSON object with everything that the result of the cut depends on; numbers
// are exact: {"radius": 0.004, "range": [0.0, 10.0], "pattern": "volume", "power": 2000.0, "scheme":
// "longest-edge", "rule": "target-edge", "target-edge": 0.001, "tolerance": 0.0005, "depth": 4, "rim":
// "smooth"}; and of "model": "thermal", "heat-width", "wavelength", "focus", "pulse-rate", "duty" and
// "most-faces" those that differ from their defaults.
std::string settings_text(const CutSettings& settings);

// Parses that object. The keys that are always written are required. The error names the first missing,
// unknown or wrong one by its JSON pointer.
Result<CutSettings> parse_settings(const JsonValue& value);

}  // namespace kerf
