#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <string>
#include <system_error>
#include <tuple>

namespace kerf {
namespace {

Error write_error(const std::filesystem::path& path, int code) {
  const std::string reason = std::generic_category().message(code);
  return failed("cannot write " + path.string() + ": " + reason + ".");
}

// The error number, or 0. One write takes 1 GiB at most, because the kernel takes no more than 2 GiB.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), std::min(bytes.size(), size_t{1} << 30));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return 0;
}

// Not every file system can flush; one that says so has nothing to lose.
int flush(int file) { return ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno; }

// The error number, or 0. The file is closed either way.
int write_and_close(int file, std::string_view bytes) {
  int code = write_all(file, bytes);
  if (code == 0) code = flush(file);
  if (::close(file) != 0 && code == 0) code = errno;
  return code;
}

Status write_in_place(const std::filesystem::path& path, std::string_view bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  const int code = file < 0 ? errno : write_and_close(file, bytes);
  if (code != 0) return write_error(path, code);
  return Done{};
}

struct TemporaryFile {
  std::filesystem::path path;
  int descriptor = -1;  // negative: errno says why there is none
};

// A new hidden file beside the target, with the permissions that the user's mask gives to new files.
TemporaryFile open_beside(const std::filesystem::path& target) {
  constexpr size_t kLongestStem = 200;  // of the 255 bytes that a file name may have
  const std::string stem =
      "." + target.filename().string().substr(0, kLongestStem) + "." + std::to_string(::getpid());
  for (int attempt = 0;; ++attempt) {
    const std::filesystem::path path = target.parent_path() / (stem + "-" + std::to_string(attempt) + ".tmp");
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST || attempt == 1000) return {path, file};
  }
}

Status replace(const std::filesystem::path& path, std::string_view bytes, std::optional<mode_t> mode) {
  const TemporaryFile temporary = open_beside(path);
  if (temporary.descriptor < 0) return write_error(path, errno);
  // Who may write a file but does not own it cannot give its permissions to another; that is no reason to
  // fail.
  if (mode) std::ignore = ::fchmod(temporary.descriptor, *mode);
  int code = write_and_close(temporary.descriptor, bytes);
  if (code == 0 && ::rename(temporary.path.c_str(), path.c_str()) != 0) code = errno;
  if (code == 0) return Done{};
  ::unlink(temporary.path.c_str());
  return write_error(path, code);
}

}  // namespace

Status write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  if (!path.has_filename()) return write_error(path, path.empty() ? ENOENT : EISDIR);
  struct stat there {};
  if (::stat(path.c_str(), &there) != 0) return replace(path, bytes, std::nullopt);
  if (S_ISDIR(there.st_mode)) return write_error(path, EISDIR);
  if (!S_ISREG(there.st_mode)) return write_in_place(path, bytes);
  std::error_code unresolved;
  const std::filesystem::path target = std::filesystem::canonical(path, unresolved);
  return replace(unresolved ? path : target, bytes, there.st_mode & 07777);
}

}  // namespace kerf
