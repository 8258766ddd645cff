#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/document/commands.h"
#include "core/document/journal.h"
#include "core/document/scene.h"

namespace kerf {

// The files that a run reads and must not overwrite: the input would be lost, and a journal that names it
// could not be replayed. Files are compared by device and inode, so links and other spellings of a path count
// as the same file. Paths that are not regular files are ignored, because a device or a pipe cannot be
// overwritten.
class InputFiles {
 public:
  // Adds a file, for a glTF file its buffers and images, for a PLY file its texture, and for an OBJ file its
  // material libraries and images.
  void add(const std::filesystem::path& file);
  void add_meshes(const SceneDescription& scene);
  void add_meshes(std::span<const Command> commands);

  // Fails with bad input if an output is one of the files. `option` is the option that specified the output,
  // e.g. "--journal".
  Status check(const std::string& option, const std::filesystem::path& output) const;
  // Fails with bad input if a file in the folder whose name `is_output` accepts is one of the files. The
  // folder need not exist. O(files in the folder).
  Status check_folder(const std::string& option, const std::filesystem::path& folder,
                      const std::function<bool(std::string_view name)>& is_output) const;

 private:
  struct File {
    uint64_t device, inode;
    std::filesystem::path path;
  };
  mutable std::vector<File> files_;
  mutable std::vector<std::filesystem::path> objs_;  // whose libraries and images are not in the list yet
};

InputFiles input_files(std::span<const std::filesystem::path> files);

// Returns the file in which save_file keeps the previous version: "car.kerf~" for "car.kerf".
std::filesystem::path previous_version(const std::filesystem::path& file);

// Writes a file atomically (see write_file_atomically). An existing file becomes its previous version and
// replaces an earlier one. Follows a symbolic link. On failure the file is unchanged. Its previous version is
// also unchanged if the disk is full.
Status save_file(const std::filesystem::path& file, std::string_view bytes);

// Writes a journal with save_file. Fails with bad input if the file is a mesh that the journal names.
// Precondition: the meshes of the scene have hashes (see record_hashes).
Status save_journal(const std::filesystem::path& file, const SceneDescription& scene,
                    std::span<const Command> commands, std::span<const StateMark> marks);

// Writes a scene (.json) with save_file, without commands and hashes. Fails with bad input if the file is a
// mesh of the scene.
Status save_scene(const std::filesystem::path& file, const SceneDescription& scene);

// Writes a path file (.json) with save_file. Reading it restores the strokes to the bit.
Status save_path(const std::filesystem::path& file, std::span<const StrokePath> strokes);

// Writes the visible bodies of a world: for each an OBJ file in its frame, or a Kerf mesh (.kmesh) if it has
// looks, and a scene file that names them. `description` supplies everything except the bodies. Creates the
// folder if it is missing and overwrites files with these names. Returns the scene file. Fails if a file
// cannot be written; files written before remain. O(faces * log(faces)).
Result<std::filesystem::path> save_world_as_scene(const World& world, SceneDescription description,
                                                  const std::filesystem::path& folder);

}  // namespace kerf
