#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/document/files/scene.h"

namespace kerf {

// Entries of features in the head of a document, beside those that a scene has anyway
// (SceneDescription::others).

// The entry of a key; null where there is none.
nlohmann::json head_entry(const SceneDescription& scene, const char* key);
// Sets an entry; null removes it.
void set_head_entry(SceneDescription& scene, const char* key, const nlohmann::json& entry);

}  // namespace kerf
