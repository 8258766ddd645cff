#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ui/editor/path/emitter.h"

namespace kerf {

// The key of the emitter in the head of a document.
inline constexpr const char* kEmitterKey = "emitter";

// The entry of the emitter in the head of a document: {"at": [x, y, z], "target": [x, y, z] (m), "in_shots",
// "pace": shots/s}; null where none stands in the scene.
nlohmann::json emitter_entry(const Emitter& emitter);

// The emitter of such an entry, switched off; one that is not placed where the entry cannot be read.
Emitter emitter_of_entry(const nlohmann::json& entry);

}  // namespace kerf
