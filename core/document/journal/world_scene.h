#pragma once

#include "core/document/files/scene.h"

namespace kerf {

// Writes the visible bodies of a world as they are and where they are: an OBJ file for each, in world
// coordinates, and a scene file that names them. `description` gives all but the bodies. The folder is made
// if it is missing, and files in it that have these names are replaced. Returns the scene file. Fails if a
// file cannot be written; those that were written before stay. O(faces * log(faces)).
Result<std::filesystem::path> save_world_as_scene(const World& world, SceneDescription description,
                                                  const std::filesystem::path& folder);

}  // namespace kerf
