#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/document/stroke_path.h"
#include "core/shadow/light.h"
#include "core/world/world.h"

namespace kerf {

// A joint in a scene file, between two parts of one mesh, each named as the mesh file names it (see
// MeshPart). In the list "joints" of a body:
//
//   {"kind": "hinge", "parts": ["door", "frame"], "anchor": [..], "axis": [..], "limits": [0, 70],
//    "near": [[..], [..]], "radius": 0.08}
//
// Only "kind", "parts" and "anchor" are required, and "axis" for hinges and hubs. The first part turns about
// the axis against the second one, by the right-hand rule.
struct SceneJoint {
  Joint::Kind kind = Joint::Kind::kWeld;
  std::array<std::string, 2> parts;
  Vec3 anchor{0};                           // m, in the frame of the body
  Vec3 axis{0, 1, 0};                       // not zero; of a hinge or a hub
  std::optional<Interval> limits;           // degrees, from -180 to 180 and containing 0; of a hinge
  std::optional<std::array<Vec3, 2>> near;  // m, a point of each part; the anchor if they are not given
  // m, the distance from its point up to which the faces of a part carry the joint. If it is not given, all
  // faces of the part do that hang together with the nearest one.
  std::optional<double> radius;
};

// The joint for a body as loaded, which has the id `id`. Fails if the mesh names no such part, if none of its
// faces is within the radius, if a face would carry both sides, or if the anchor is more than a hundred times
// the size of the mesh away from it. O(faces of the body).
Result<Joint> make_joint(const SceneJoint& joint, BodyId id, const Body& body);

// The appearance of a material.
struct Paint {
  Vec3 colour{0.20, 0.27, 0.33};  // linear RGB; "#rrggbb" (sRGB) in the file
  double gloss = 0.5;             // 0 matt .. 1 polished
};

// The largest number of lights of a scene.
inline constexpr size_t kMaxLights = 4;

// A view of a scene.
struct View {
  Vec3 eye{0}, target{0};  // m
};

// Whether a body is solid: its faces are a sheet, they enclose a volume, or they do where every connected
// part of the loaded mesh is closed.
enum class Solidity { kSheet, kSolid, kAuto };

// A body in a scene file.
struct SceneBody {
  std::filesystem::path mesh;  // as it can be opened from the current folder
  std::string name;
  Placement placement;
  std::optional<uint64_t> hash;  // of the mesh file's bytes, see file_hash
  Sheet sheet;
  Solidity solid = Solidity::kSheet;
  std::vector<SceneJoint> joints;
};

// The body for a single mesh file, with the name of the file and an identity placement.
SceneBody body_of_file(const std::filesystem::path& mesh);

// Keys of a scene whose values the editor alone reads and writes.
inline constexpr std::array kEditorKeys{"emitter", "path", "rulers", "shown"};

// The content of a scene file or of the head of a journal, without the meshes: {"version": 1, "bodies":
// [{"mesh": "../meshes/car.obj", "name": "car", "position": [..], "orientation": [w,x,y,z],
// "thickness": 0.0008, "density": 7850, "solid": true, false or "auto", "joints": [..]}], "paints": {"tyre":
// {"colour": "#202224", "gloss": 0.1}}, "view": {"eye": [..], "target": [..]}, "lights":
// [{"direction": [..] or "position": [..], "colour": "#fff2d8", "intensity": 2}], "show": ["silhouette"],
// "strokes": [...]}. Only "bodies" and "mesh" are required.
struct SceneDescription {
  std::vector<SceneBody> bodies;
  std::map<std::string, Paint> paints;  // by material name
  std::optional<View> view;
  std::vector<Light> lights;        // up to kMaxLights; if empty, the default key light
  std::string show;                 // default of `render --show`, in its syntax
  std::vector<StrokePath> strokes;  // cut when the scene is opened
  std::string others = "{}";        // JSON: the values of kEditorKeys
};

// A scene with its meshes loaded: the world has one body for each body of the description, in the same order.
struct Scene : SceneDescription {
  World world;
};

// Reads the description of a scene (.json), or that of a mesh file as a scene of one body. Mesh paths in a
// scene file are relative to the file. Fails if the file is not a valid scene; a mesh file is not read.
Result<SceneDescription> read_description(const std::filesystem::path& file);

// Adds the loaded mesh of a description to a world, with its placement, its sheet and its joints, solid or
// not. Fails if a joint cannot be made (see make_joint); then the world is not to be used. O(joints * faces).
Result<BodyId> add_scene_body(const SceneBody& description, Body body, World& world);

// Loads the meshes of a description. Fails if a mesh is missing, cannot be read, or does not match its hash;
// fails with cancelled() when stopped. `progress` may be null. O(n log n) in the number of faces.
Result<Scene> load_scene(SceneDescription description, const Progress* progress = nullptr);

// Reads a description with read_description and loads it with load_scene. Fails like these.
Result<Scene> read_scene(const std::filesystem::path& file, const Progress* progress = nullptr);

// Computes the hash of every mesh file that has none yet, as journals require. Fails if a file cannot be
// read.
Status record_hashes(SceneDescription& description, const Progress* progress = nullptr);

}  // namespace kerf
