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
#include <utility>

namespace kerf {
namespace {

Error write_error(const std::filesystem::path& path, int code) {
  const std::string reason = std::generic_category().message(code);
  return failed("cannot write " + path.string() + ": " + reason + ".");
}

// Not every file system can flush; one that says so has nothing to lose.
int flush(int file) { return ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno; }

using Produce = std::function<void(const ByteSink&)>;

// An open file, closed at the latest with its scope.
class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  int descriptor() const { return descriptor_; }
  // The error number, or 0.
  int fill(const Produce& produce) const {
    int code = 0;
    produce([&](std::string_view bytes) { return (code = write_all(descriptor_, bytes)) == 0; });
    return code != 0 ? code : flush(descriptor_);
  }
  int close() { return ::close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno; }

 private:
  int descriptor_;
};

// Fills and closes a file. The error number, or 0.
int write_and_close(OpenFile& file, const Produce& produce) {
  const int code = file.fill(produce), closing = file.close();
  return code != 0 ? code : closing;
}

Status write_in_place(const std::filesystem::path& path, const Produce& produce) {
  OpenFile file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  const int code = file.descriptor() < 0 ? errno : write_and_close(file, produce);
  if (code != 0) return write_error(path, code);
  return Done{};
}

// The path of a new hidden file beside the target, and its descriptor; the file has the permissions that the
// user's mask gives to new files. A negative descriptor: errno says why there is none.
std::pair<std::filesystem::path, int> open_beside(const std::filesystem::path& target) {
  constexpr size_t kLongestStem = 200;  // of the 255 bytes that a file name may have
  const std::string stem =
      "." + target.filename().string().substr(0, kLongestStem) + "." + std::to_string(::getpid());
  for (int attempt = 0;; ++attempt) {
    const std::filesystem::path path = target.parent_path() / (stem + "-" + std::to_string(attempt) + ".tmp");
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST || attempt == 1000) return {path, file};
  }
}

// Removes a file with its scope, unless it was kept.
class Removal {
 public:
  explicit Removal(std::filesystem::path path) : path_(std::move(path)) {}
  Removal(const Removal&) = delete;
  Removal& operator=(const Removal&) = delete;
  ~Removal() {
    if (!kept_) ::unlink(path_.c_str());
  }
  void keep() { kept_ = true; }

 private:
  std::filesystem::path path_;
  bool kept_ = false;
};

Status replace(const std::filesystem::path& path, const Produce& produce, std::optional<mode_t> mode) {
  const auto [beside, descriptor] = open_beside(path);
  if (descriptor < 0) return write_error(path, errno);
  OpenFile file(descriptor);
  Removal removal(beside);
  // A user who may write a file but does not own it cannot give its permissions to another file; writing goes
  // on without them.
  if (mode) std::ignore = ::fchmod(descriptor, *mode);
  int code = write_and_close(file, produce);
  if (code == 0 && ::rename(beside.c_str(), path.c_str()) != 0) code = errno;
  if (code != 0) return write_error(path, code);
  removal.keep();
  return Done{};
}

}  // namespace

// One write takes 1 GiB at most, because the kernel takes no more than 2 GiB.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), std::min(bytes.size(), size_t{1} << 30));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return 0;
}

Status write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  return write_file_atomically(path, [&](const ByteSink& sink) { sink(bytes); });
}

Status write_file_atomically(const std::filesystem::path& path, const Produce& produce) {
  if (!path.has_filename()) return write_error(path, path.empty() ? ENOENT : EISDIR);
  struct stat there {};
  if (::stat(path.c_str(), &there) != 0) return replace(path, produce, std::nullopt);
  if (S_ISDIR(there.st_mode)) return write_error(path, EISDIR);
  if (!S_ISREG(there.st_mode)) return write_in_place(path, produce);
  std::error_code unresolved;
  const std::filesystem::path target = std::filesystem::canonical(path, unresolved);
  return replace(unresolved ? path : target, produce, there.st_mode & 07777);
}

}  // namespace kerf
