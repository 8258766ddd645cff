#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/geometry.h"
#include "core/document/scene.h"
#include "core/document/text/json.h"

namespace kerf {

// Converts "#rrggbb" (sRGB) to linear RGB in 0 .. 1. Returns nullopt for any other text.
std::optional<Vec3> parse_colour(std::string_view text);

// Converts linear RGB to the nearest "#rrggbb", the inverse of parse_colour in lower case.
std::string colour_text(const Vec3& linear);

class Fields;

inline constexpr uint64_t kSceneVersion = 1;

// Parses the JSON of a scene file. Mesh paths are relative to `folder`. The error names the first wrong
// value, or the first unknown key, by its JSON pointer.
Result<SceneDescription> parse_scene(const JsonValue& root, const std::filesystem::path& folder);

// The JSON of a scene for a file in `folder`, with meshes named as in path_text(). Accepts texts that are
// not UTF-8, for which dump_json fails.
nlohmann::ordered_json scene_json(const SceneDescription& scene, const std::filesystem::path& folder);

void describe(Fields& f, SceneDescription& scene);
void describe(Fields& f, SceneBody& body);
void describe(Fields& f, SceneJoint& joint);
void describe(Fields& f, Paint& paint);
void describe(Fields& f, View& view);
void describe(Fields& f, Light& light);
void lights_field(Fields& f, const char* key, std::vector<Light>& lights);

}  // namespace kerf
