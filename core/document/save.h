#pragma once

#include "core/document/journal.h"

namespace kerf {

// The file in which save_file keeps the previous version: "car.kerf~" for "car.kerf".
std::filesystem::path previous_version(const std::filesystem::path& file);

// Writes a file atomically (see write_file_atomically). An existing file becomes its previous version and
// replaces an earlier one. Follows a symbolic link. On failure the file is unchanged.
Status save_file(const std::filesystem::path& file, std::string_view bytes);

// Writes a journal with save_file. Bad input if the file is a mesh that the journal names. Precondition: the
// meshes of the scene have hashes (see record_hashes).
Status save_journal(const std::filesystem::path& file, const SceneDescription& scene,
                    std::span<const Command> commands, std::span<const StateMark> marks);

// Writes a scene (.json) with save_file, without commands and hashes. Bad input if the file is a mesh of it.
Status save_scene(const std::filesystem::path& file, const SceneDescription& scene);

// Writes a path file (.json) with save_file. Reading it restores the strokes to the bit.
Status save_path(const std::filesystem::path& file, std::span<const StrokePath> strokes);

// Writes the current visible bodies of a world: an OBJ file for each, in world coordinates, and a scene
// file that names them. `description` supplies everything except the bodies. Creates the folder if it is
// missing and overwrites files with these names. Returns the scene file. Fails if a file cannot be written;
// files written before remain. O(faces * log(faces)).
Result<std::filesystem::path> save_world_as_scene(const World& world, SceneDescription description,
                                                  const std::filesystem::path& folder);

}  // namespace kerf
