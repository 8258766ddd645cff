#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace kerf {

// A file that is locked by one program. No other program can lock it while this object exists; the system
// releases the lock when the program ends in any way. Other programs can still read, rename and remove the
// file.
class LockedFile {
 public:
  // Creates a file, which appears under its name atomically, locked and with these bytes, and is on the disk
  // then. Fails if it exists.
  static Result<LockedFile> create(const std::filesystem::path& path, std::string_view bytes);
  // Opens and locks an existing file. Fails if another program has locked it.
  static Result<LockedFile> open(const std::filesystem::path& path);

  LockedFile(LockedFile&& other) noexcept;
  LockedFile& operator=(LockedFile&& other) noexcept;
  ~LockedFile();

  const std::filesystem::path& path() const { return path_; }

  // Appends all of the bytes to the file, or none of them on failure. They survive the end of the program,
  // but a loss of power only after flush().
  Status append(std::string_view bytes);
  // Starts to write what was appended to the disk without waiting. Returns true while that is in progress or
  // was just started, and has to be called again then.
  bool flush();

  // Removes the file from its folder.
  void remove();

 private:
  struct Handle;
  LockedFile(std::filesystem::path path, Handle* handle);
  std::filesystem::path path_;
  Handle* handle_ = nullptr;
};

}  // namespace kerf
