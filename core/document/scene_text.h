#pragma once

#include <filesystem>

#include "core/document/json_value.h"
#include "core/document/scene.h"

namespace kerf {

inline constexpr int kSceneVersion = 1;

// A scene from the JSON of its file. Relative mesh paths are taken from `folder`. Keys that this version does
// not know are kept; a value that makes no sense is one sentence with a JSON pointer.
Result<SceneDescription> parse_scene(const JsonValue& root, const std::filesystem::path& folder);

// The same scene as JSON for a file in `folder`: meshes in or below it, or beside it (one ".." and no more),
// are named relative to it, others by their whole path. An empty folder makes all paths whole ones. Throws
// nothing; but texts that are not UTF-8 make nlohmann's dump() fail, see dump_json.
nlohmann::ordered_json scene_json(const SceneDescription& scene, const std::filesystem::path& folder);

// A mesh file as it is named in a file in `folder`, as above.
std::string path_text(const std::filesystem::path& file, const std::filesystem::path& folder);

// The text of JSON; bad input where a text in it is not UTF-8, which JSON cannot hold.
Result<std::string> dump_json(const nlohmann::ordered_json& json, int indent = -1);

}  // namespace kerf
