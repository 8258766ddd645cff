#pragma once

#include "core/document/journal.h"

namespace kerf {

// Where save_file keeps the version before the last: "car.kerf~" for "car.kerf".
std::filesystem::path previous_version(const std::filesystem::path& file);

// Writes a file that people made, whole or not at all (see write_file_atomically); what was there before is
// kept as its previous version, and the version before that is gone. A link is followed.
Status save_file(const std::filesystem::path& file, std::string_view bytes);

// Writes a journal with save_file. The scene's meshes must have hashes, see note_hashes; `damage` is left
// out.
Status save_journal(const std::filesystem::path& file, const SceneDescription& scene,
                    std::span<const Command> commands, std::span<const StateMark> marks);

// Writes a scene (.json) with save_file. What was done to it since is not in it.
Status save_scene(const std::filesystem::path& file, const SceneDescription& scene);

}  // namespace kerf
