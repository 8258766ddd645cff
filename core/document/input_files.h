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
#include "core/document/scene.h"

namespace kerf {

// The files that a run reads and must not overwrite: the input would be lost, and a journal that names it
// could not be replayed. Files are compared by device and inode, so that links and other spellings of a
// path count as the same file. Paths that are no regular files are ignored, because writing to a device or
// a pipe loses nothing.
class InputFiles {
 public:
  // Adds a file, and for a glTF file its buffers and images.
  void add(const std::filesystem::path& file);
  void add_meshes(const SceneDescription& scene);
  void add_meshes(std::span<const Command> commands);

  // Bad input if an output is one of the files. `option` is the option that gave the output, e.g.
  // "--journal".
  Status check(const std::string& option, const std::filesystem::path& output) const;
  // Bad input if a file of a folder, whose name `is_output` accepts, is one of the files. Accepts a folder
  // that does not exist. O(files in the folder).
  Status check_folder(const std::string& option, const std::filesystem::path& folder,
                      const std::function<bool(std::string_view name)>& is_output) const;

 private:
  struct File {
    uint64_t device, inode;
    std::filesystem::path path;
  };
  std::vector<File> files_;
};

InputFiles input_files(std::span<const std::filesystem::path> files);

}  // namespace kerf
