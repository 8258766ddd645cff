#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace kerf {

// A file that one program works on: while this lives, no other can lock it, and when the program ends,
// however it ends, the lock is gone. Other programs can still read, rename and remove it.
class LockedFile {
 public:
  // A new file that appears under its name, locked and with these bytes in it, in one go.
  static Result<LockedFile> create(const std::filesystem::path& path, std::string_view bytes);
  // One that is there; fails where another program has it locked.
  static Result<LockedFile> open(const std::filesystem::path& path);

  LockedFile(LockedFile&& other) noexcept;
  LockedFile& operator=(LockedFile&& other) noexcept;
  ~LockedFile();

  const std::filesystem::path& path() const { return path_; }

  // All of the bytes at the end of the file, or none. They outlive the program from here on.
  Status append(std::string_view bytes);
  // Sends what was appended on its way to the disk and does not wait for it; called again while that goes on,
  // it does nothing and says true: it must be called once more.
  bool flush();

  void remove();

 private:
  struct Handle;
  LockedFile(std::filesystem::path path, Handle* handle);
  std::filesystem::path path_;
  Handle* handle_ = nullptr;
};

}  // namespace kerf
