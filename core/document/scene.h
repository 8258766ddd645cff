#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/document/stroke_path.h"
#include "core/document/text/json.h"
#include "core/joints/joint_description.h"
#include "core/mesh/files/mesh_format.h"
#include "core/shadow/shadow_volume.h"
#include "core/world/world.h"

namespace kerf {

struct Paint {
  Vec3 colour{0.20, 0.27, 0.33};  // linear RGB; "#rrggbb" (sRGB) in the file
  double gloss = 0.5;             // 0 matt .. 1 polished
};

inline constexpr size_t kMaxLights = 4;

struct View {
  Vec3 eye{0}, target{0};  // m
};

// Whether the faces of a body are a sheet or enclose a volume; kAuto: they enclose a volume if every
// connected part of the loaded mesh is closed.
enum class Solidity { kSheet, kSolid, kAuto };

struct SceneBody {
  std::filesystem::path mesh;  // relative to the current folder, or absolute
  std::string name;
  Placement placement;
  std::optional<uint64_t> hash;      // of the mesh file's bytes, see file_hash
  FileUnit unit = FileUnit::kMetre;  // of a mesh file that states none
  Sheet sheet;
  Solidity solid = Solidity::kSheet;
  std::string cut_material = "cut";  // of the walls of a solid body; may be one of the mesh
  std::vector<JointDescription> joints;
};

// The description for a single mesh file, with the name of the file and an identity placement.
SceneBody body_of_file(const std::filesystem::path& mesh);

// Keys of a scene whose values only the editor reads and writes.
inline constexpr std::array kEditorKeys{"emitter", "path", "rulers", "shown"};

// The content of a scene file or of the head of a journal, without the meshes:
//
//   {"version": 1,
//    "bodies": [{"mesh": "../meshes/car.obj", "unit": "mm", "cm", "m" or "in", "name": "car",
//                "position": [..], "orientation": [w,x,y,z],
//                "thickness": 0.0008, "density": 7850, "solid": true, false or "auto", "cut_material": "cut",
//                "joints": [..]}],
//    "paints": {"tyre": {"colour": "#202224", "gloss": 0.1}}, "view": {"eye": [..], "target": [..]},
//    "lights": [{"direction": [..] or "position": [..], "colour": "#fff2d8", "intensity": 2}],
//    "show": ["silhouette"], "strokes": [...]}
//
// Only "bodies" and "mesh" are required.
struct SceneDescription {
  std::vector<SceneBody> bodies;
  std::map<std::string, Paint> paints;  // by material name
  std::optional<View> view;
  std::vector<Light> lights;        // at most kMaxLights; if empty, the default key light
  std::string show;                 // default of `render --show`, in its syntax
  std::vector<StrokePath> strokes;  // cut when the scene is opened
  std::string others = "{}";        // JSON: the values of kEditorKeys
};

// A scene with its meshes loaded: the world has one body per body of the description, in the same order.
struct Scene : SceneDescription {
  World world;
};

// Reads the description of a scene (.json), or describes a mesh file as a scene of one body, whose unit is
// `unit` if the file states none. Mesh paths in a scene file are relative to the file. Fails if the file is
// not a valid scene, or if a unit other than the metre is given for a scene; does not read meshes.
Result<SceneDescription> read_description(const std::filesystem::path& file,
                                          FileUnit unit = FileUnit::kMetre);

// Adds the loaded mesh of a description to a world, with its placement, sheet, solidity and joints. Fails
// if a joint cannot be made (see make_joint); the world must not be used then. O(joints * faces).
Result<BodyId> add_scene_body(const SceneBody& description, Body body, World& world);

// Loads the meshes of a description. Fails if a mesh is missing, cannot be read, or does not match its hash;
// fails with cancelled() when stopped. `progress` may be null. O(n log n) in the number of faces.
Result<Scene> load_scene(SceneDescription description, const Progress* progress = nullptr);

// Reads and loads a scene: read_description(), then load_scene(), with their errors.
Result<Scene> read_scene(const std::filesystem::path& file, const Progress* progress = nullptr,
                         FileUnit unit = FileUnit::kMetre);
// The error of a unit other than the metre for a scene or a journal.
Error states_units(const std::filesystem::path& file);

// Fails with bad input if the mesh file of a body has another hash than its description states.
Status check_hash(const SceneBody& body, const Progress* progress = nullptr);
// Computes the missing hashes of mesh files, as journals require. Fails if a file cannot be read.
Status record_hashes(SceneDescription& description, const Progress* progress = nullptr);

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
// A joint in the list "joints" of a body:
//
//   {"kind": "hinge", "parts": ["door", "frame"], "anchor": [..], "axis": [..], "limits": [0, 70],
//    "near": [[..], [..]], "radius": 0.08}
//
// Only "kind", "anchor" and either "parts" or "near" are required, and "axis" for hinges and hubs.
void describe(Fields& f, JointDescription& joint);
void describe(Fields& f, Paint& paint);
void describe(Fields& f, View& view);
void describe(Fields& f, Light& light);
void lights_field(Fields& f, const char* key, std::vector<Light>& lights);

}  // namespace kerf
