#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/document/json_value.h"
#include "core/document/scene.h"

namespace kerf {

// The version of the scene format.
inline constexpr int kSceneVersion = 1;

// Parses the JSON of a scene file. Relative mesh paths refer to `folder`. Unknown keys are kept. The error
// names the first wrong value by its JSON pointer.
Result<SceneDescription> parse_scene(const JsonValue& root, const std::filesystem::path& folder);
// The same for one element of "bodies", and for the values of "paints" and "lights".
Result<SceneBody> parse_scene_body(const JsonValue& value, const std::filesystem::path& folder);
Result<std::map<std::string, Paint>> parse_paints(const JsonValue& value);
Result<std::vector<Light>> parse_lights(const JsonValue& value);

// The JSON of a scene for a file in `folder`. Meshes in or below the folder or its parent are named relative
// to it, others by their absolute path; if `folder` is empty, all paths are absolute. Texts that are not
// UTF-8 are accepted here and make dump_json fail.
nlohmann::ordered_json scene_json(const SceneDescription& scene, const std::filesystem::path& folder);

// The name of a mesh file in a file in `folder`, by the same rule.
std::string path_text(const std::filesystem::path& file, const std::filesystem::path& folder);

// Converts JSON to text. Fails if a string in it is not UTF-8.
Result<std::string> dump_json(const nlohmann::ordered_json& json, int indent = -1);

}  // namespace kerf
