#pragma once

#include <string>

#include "core/cut/cut_step.h"
#include "core/document/json_value.h"

namespace kerf {

// Settings of a stroke as a JSON object: everything that the result depends on, numbers exact.
// {"radius": 0.004, "range": [0.0, 10.0], "pattern": "volume", "power": 2000.0, "scheme": "longest-edge",
// "rule": "target-edge", "target-edge": 0.001, "tolerance": 0.0005, "depth": 4, "rim": "smooth",
// "most-faces": 20000000}; the last only where it is not as usual.
std::string settings_text(const CutSettings& settings);

// Takes that object; every key but the last must be there, and others make no sense.
Result<CutSettings> parse_settings(const JsonValue& value);

}  // namespace kerf
