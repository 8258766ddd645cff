#pragma once

#include <cstdint>
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

// A body as a file names it.
struct SceneBody {
  std::filesystem::path mesh;  // as it can be opened from here
  std::string name;
  Placement placement;
  std::optional<uint64_t> hash;  // of the mesh file's bytes, see file_hash
  std::string others = "{}";     // JSON: keys that this version does not know
};

// The body that a mesh file makes by itself: named after the file, as it stands there.
SceneBody body_of_file(const std::filesystem::path& mesh);

// What a scene file or the head of a journal says, before any mesh is loaded: {"version": 1,
// "bodies": [{"mesh": "../meshes/car.obj", "name": "car", "position": [..], "orientation": [w,x,y,z]}],
// "paints": {"tyre": {"colour": "#202224", "gloss": 0.1}}, "view": {"eye": [..], "target": [..]},
// "lights": [{"direction": [..] or "position": [..], "colour": "#fff2d8", "intensity": 2}], "show":
// ["silhouette"], "strokes": [...]}. Only "bodies" and "mesh" must be there.
struct SceneDescription {
  std::vector<SceneBody> bodies;
  std::map<std::string, Paint> paints;  // by material name
  std::optional<View> view;
  std::vector<Light> lights;  // up to kMostLights; none: the key light of the workshop
  std::string show;           // names as `render --show` takes them, with commas, for when none are asked for
  std::vector<StrokePath> strokes;  // cut before the scene is shown
  std::string others = "{}";        // JSON: keys that this version does not know
};

// With its meshes loaded, a body of the world for each of its bodies, in their order.
struct Scene : SceneDescription {
  World world;
};

// Loads the meshes. A mesh that is missing or broken, and one whose bytes are not those that the description
// knows by their hash, is bad input. O(n log n) in their faces.
Result<Scene> load_scene(SceneDescription description, const Progress* progress = nullptr);

// Reads a scene (.json) or any mesh file, which makes a scene of that one body. Mesh paths in a scene file
// are relative to it.
Result<Scene> read_scene(const std::filesystem::path& file, const Progress* progress = nullptr);

// Notes the hash of every mesh file that has none yet, so that a journal can hold the scene.
Status note_hashes(SceneDescription& description, const Progress* progress = nullptr);

}  // namespace kerf
