#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/document/scene.h"
#include "core/world/world.h"

namespace kerf {

// A loaded body, of which copies are added to worlds, and the joints within it.
struct ModelBody {
  Body body;
  std::vector<Joint> joints;  // of the body in the world to which it will be added
};

// Fails like make_joint.
Status add_joints(std::span<const SceneJoint> joints, ModelBody& model);

BodyId add_body(World& world, const ModelBody& model, uint32_t generation);

// Start of a vehicle: the origin of its frame and its heading.
struct Start {
  Vec3 position{0};    // m
  double heading = 0;  // rad, see direction_of
  Placement placement() const;
};

struct ArenaBody {
  SceneBody body;
  bool cuttable = false;  // otherwise beams end at it
};

// The content of an arena file; the initial values are the defaults of missing keys.
struct ArenaDescription {
  std::string name;
  double ground = 0;    // m, the height of the ground plane
  Vec2 size{100, 100};  // m along x and z, around the origin; a wall for all bodies
  std::vector<ArenaBody> bodies;
  std::map<std::string, Paint> paints;
  std::vector<Light> lamps;
  Start player;
  std::vector<Start> enemies;  // not empty
};

// Reads an arena file:
//
//   {"name": "yard", "ground": 0, "size": [90, 70],
//    "bodies": [{"mesh": "../meshes/ramp.obj", "name": "ramp", "position": [..], "orientation": [w,x,y,z],
//                "cuttable": false}],
//    "lamps": as the "lights" of scenes, "paints": as in scenes,
//    "starts": {"player": {"position": [..], "heading": 90}, "enemies": [{..}, {..}]}}
//
// A body may have its placement in an object "pose", and a "heading" in degrees instead of an orientation.
// Only "starts" is required. Bad input otherwise, with the file and the JSON pointer. Does not read meshes.
Result<ArenaDescription> read_arena(const std::filesystem::path& file);

// An arena with its meshes loaded. Cuttable bodies sleep until something touches them; the others are
// pinned.
struct Arena {
  ArenaDescription description;
  std::vector<ModelBody> bodies;  // in the order of the description
};

// Loads each mesh once. Fails like load_body, and if a joint does not fit. `progress` may be null.
Result<Arena> load_arena(ArenaDescription description, const Progress* progress = nullptr);

}  // namespace kerf
