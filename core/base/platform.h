#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

#include "core/base/result.h"

namespace kerf {

// Takes the next bytes of a file or stream, which are valid during the call only. Returns false when no more
// are wanted, because writing failed.
using ByteSink = std::function<bool(std::string_view)>;

// A file that is written in parts, and appears whole or not at all: the bytes go to a temporary file in the
// target's directory, which commit() flushes to the disk and renames over the target; then it flushes the
// directory, so that a loss of power does not bring the previous file back. A symbolic link is followed, and
// a replaced file keeps its permissions. A device or a pipe (/dev/stdout) is written to directly. Each error
// is one sentence that names the target.
class AtomicFile {
 public:
  // Makes the temporary file. Fails if the target is a directory or cannot be written.
  static Result<AtomicFile> open(const std::filesystem::path& path);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  // Without a commit(), the temporary file is removed and the target is as it was.
  ~AtomicFile();

  Status append(std::string_view bytes);
  // To be called once, after the last append(). If the directory cannot be flushed, the file is written
  // nevertheless.
  Status commit();

 private:
  AtomicFile() = default;

  std::filesystem::path path_, target_;  // as named; with links followed
  std::filesystem::path beside_;         // the temporary file; empty where there is none
  int descriptor_ = -1;
};

// Writes a whole file like that or leaves the previous contents untouched.
Status write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

// Writes a file like that from bytes that come in parts. `produce` hands the parts to the sink and returns
// early where the sink returns false. An exception of `produce` is passed on, and leaves no temporary file.
Status write_file_atomically(const std::filesystem::path& path,
                             const std::function<void(const ByteSink&)>& produce);

// Each returns the error number, or 0: writes all of the bytes to an open file; waits until an open file is
// on the disk; and until the names in the folder of a file are.
int write_all(int file, std::string_view bytes);
int flush_file(int file);
int flush_folder_of(const std::filesystem::path& file);

// Where Kerf keeps a user's files, by the XDG Base Directory Specification; the folders need not exist.
// Settings: kerf under $XDG_CONFIG_HOME or, if that is no absolute path, under ~/.config.
std::filesystem::path settings_folder();
// Unsaved work and scores: kerf under $XDG_STATE_HOME or ~/.local/state.
std::filesystem::path state_folder();
// $HOME, or empty if it is not set.
std::filesystem::path home_folder();

// The folder of materials, shaders, scenes and meshes: share/kerf beside the folder of the program or of the
// library that holds this code, or beside one of the folders above it, where Kerf is installed; otherwise
// `assets/` of the checkout from which it was built.
std::filesystem::path assets_folder();

// The memory that this process may use, in bytes: that of the machine, or the smallest of the limits that its
// control group and its resource limits set. Reads a few small files; to be asked once.
uint64_t machine_memory();

}  // namespace kerf
