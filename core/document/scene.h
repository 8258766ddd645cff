#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/vec3.h"
#include "core/document/path_file.h"
#include "core/shadow/light.h"
#include "core/world/world.h"

namespace kerf {

// How a material looks: linear RGB from the file's "#rrggbb" (sRGB), and how polished it is.
struct Paint {
  Vec3 colour{0.20, 0.27, 0.33};
  double gloss = 0.5;  // 0 matt .. 1 polished
};

// As many lights as are drawn.
inline constexpr size_t kMostLights = 4;

struct View {
  Vec3 eye{0}, target{0};  // m
};

// What a scene file holds, read and loaded: {"bodies": [{"mesh": "../meshes/car.obj", "name": "car"}],
// "paints": {"tyre": {"colour": "#202224", "gloss": 0.1}}, "view": {"eye": [..], "target": [..]},
// "lights": [{"direction": [..] or "position": [..], "colour": "#fff2d8", "intensity": 2}], "show":
// ["silhouette"], "strokes": [...]}. Mesh paths are relative to the scene file.
struct Scene {
  World world;
  std::map<std::string, Paint> paints;  // by material name
  std::optional<View> view;
  std::vector<Light> lights;  // up to kMostLights; none: the key light of the workshop
  std::string show;           // names as `render --show` takes them, with commas, for when none are asked for
  std::vector<StrokePath> strokes;  // cut before the scene is shown
};

// Reads a scene (.json) or any mesh file, which makes a scene of that one body.
Result<Scene> read_scene(const std::filesystem::path& file, const Progress* progress = nullptr);

}  // namespace kerf
