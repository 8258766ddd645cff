#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

#include "core/base/result.h"

namespace kerf {

// Receives the next bytes of a file or stream, which are valid during the call only. Returns false if no more
// bytes are wanted, because writing failed.
using ByteSink = std::function<bool(std::string_view)>;

// A file that is written in parts, and appears complete or not at all: the bytes are written to a temporary
// file in the target's directory, which commit() flushes to the disk and renames over the target; then it
// flushes the directory, so that a power failure does not bring the previous file back. Symbolic links are
// followed, and a replaced file keeps its permissions. A device, a pipe (/dev/stdout), or a file to which
// standard output or error is redirected is written to directly. Each error is one sentence that names the
// target.
class AtomicFile {
 public:
  // Creates the temporary file. Fails if the target is a directory, is read-only or cannot be written.
  static Result<AtomicFile> open(const std::filesystem::path& path);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  // Without a commit(), removes the temporary file and leaves the target unchanged.
  ~AtomicFile();

  Status append(std::string_view bytes);
  // Must be called once, after the last append(). The file is written even if flushing the directory fails.
  Status commit();

 private:
  AtomicFile() = default;

  std::filesystem::path path_, target_;  // as named; with links followed
  std::filesystem::path beside_;         // the temporary file; empty if there is none
  int descriptor_ = -1;
};

// Fails like AtomicFile::open if a file cannot be written, and leaves it unchanged. Does not open a device or
// a pipe, which has a reader.
Status check_writable(const std::filesystem::path& path);

// Writes a whole file by AtomicFile, or leaves the previous contents untouched.
Status write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

// Likewise for bytes in parts. `produce` passes the parts to the sink and returns early if the sink returns
// false. An exception of `produce` is passed on, and leaves no temporary file.
Status write_file_atomically(const std::filesystem::path& path,
                             const std::function<void(const ByteSink&)>& produce);

// Write all of the bytes to an open file; wait until an open file is on the disk; wait until the names in the
// folder of a file are. Each returns the error number, or 0 on success.
int write_all(int file, std::string_view bytes);
int flush_file(int file);
int flush_folder_of(const std::filesystem::path& file);

// Folders of a user's files, by the XDG Base Directory Specification; they need not exist. Settings: kerf
// under $XDG_CONFIG_HOME or, if that is no absolute path, under ~/.config.
std::filesystem::path settings_folder();
// Unsaved work and scores: kerf under $XDG_STATE_HOME or ~/.local/state.
std::filesystem::path state_folder();
// $HOME, or empty if it is not set.
std::filesystem::path home_folder();

// The folder of materials, shaders, scenes and meshes. If Kerf is installed: share/kerf next to the folder of
// the program or library that contains this code, or next to a folder above that. Otherwise: `assets/` of the
// checkout from which it was built.
std::filesystem::path assets_folder();

// Returns the memory available to this process, in bytes: that of the machine, or the smallest of its
// resource limits and the limit of its container. Limits of other control groups do not count. Reads a few
// small files; call once.
uint64_t machine_memory();

}  // namespace kerf
