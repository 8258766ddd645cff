#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/geometry.h"
#include "core/document/scene.h"
#include "core/document/text/json.h"

namespace kerf {

// Converts "#rrggbb" (sRGB) to linear RGB in 0 .. 1. Returns nothing for any other text.
std::optional<Vec3> parse_colour(std::string_view text);

// Converts linear RGB to the nearest "#rrggbb". A colour that parse_colour returned is converted back to its
// text in lower case.
std::string colour_text(const Vec3& linear);

class Fields;

// The version of the scene format.
inline constexpr uint64_t kSceneVersion = 1;

// Parses the JSON of a scene file. Relative mesh paths refer to `folder`. The error names the first wrong
// value, or the first unknown key, by its JSON pointer.
Result<SceneDescription> parse_scene(const JsonValue& root, const std::filesystem::path& folder);

// The JSON of a scene for a file in `folder`, with meshes named as path_text() does. Texts that are not UTF-8
// are accepted here and make dump_json fail.
nlohmann::ordered_json scene_json(const SceneDescription& scene, const std::filesystem::path& folder);

// The tables of fields of a scene and of its parts.
void describe(Fields& f, SceneDescription& scene);
void describe(Fields& f, SceneBody& body);
void describe(Fields& f, SceneJoint& joint);
void describe(Fields& f, Paint& paint);
void describe(Fields& f, View& view);
void describe(Fields& f, Light& light);
// The list of at most kMaxLights lights.
void lights_field(Fields& f, const char* key, std::vector<Light>& lights);

}  // namespace kerf
