#include "core/base/platform.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

namespace kerf {

namespace fs = std::filesystem;

namespace {

Error write_error(const std::filesystem::path& path, int code) {
  std::string reason = std::generic_category().message(code);
  std::error_code unknown;
  const std::filesystem::path folder = path.parent_path();
  if (code == ENOENT && !folder.empty() && !std::filesystem::exists(folder, unknown))
    reason = "there is no folder " + folder.string();
  return failed("cannot write " + path.string() + ": " + reason + ".");
}

// Returns the file to which symbolic links lead, whether it exists or not.
fs::path link_target(fs::path path) {
  constexpr int kMaxLinks = 40;  // as many as Linux follows
  std::error_code fault;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(path, fault); ++i) {
    const fs::path to = fs::read_symlink(path, fault);
    if (!fault) path = path.parent_path() / to;
  }
  return path;
}

// Returns the path of a new hidden file in the directory of the target, and its descriptor. The umask
// determines the permissions of the file. A negative descriptor means failure, with the reason in errno.
std::pair<std::filesystem::path, int> open_beside(const std::filesystem::path& target) {
  constexpr size_t kMaxStem = 200;  // of the 255 bytes that a file name may have
  const std::string stem =
      "." + target.filename().string().substr(0, kMaxStem) + "." + std::to_string(::getpid());
  for (int attempt = 0;; ++attempt) {
    const std::filesystem::path path = target.parent_path() / (stem + "-" + std::to_string(attempt) + ".tmp");
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST || attempt == 1000) return {path, file};
  }
}

// Returns a duplicate of standard output or error if it is redirected to this file, else -1.
int stream_to(const struct stat& file) {
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat own {};
    if (::fstat(stream, &own) == 0 && own.st_dev == file.st_dev && own.st_ino == file.st_ino)
      return ::fcntl(stream, F_DUPFD_CLOEXEC, 0);
  }
  return -1;
}

fs::path folder_by(const char* variable, const char* below_home) {
  const char* named = std::getenv(variable);
  if (named != nullptr && fs::path(named).is_absolute()) return fs::path(named) / "kerf";
  const fs::path home = home_folder();
  return (home.empty() ? fs::path("/") : home) / below_home / "kerf";
}

constexpr uint64_t kNone = std::numeric_limits<uint64_t>::max();

uint64_t physical_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), bytes = ::sysconf(_SC_PAGE_SIZE);
  return pages > 0 && bytes > 0 ? static_cast<uint64_t>(pages) * static_cast<uint64_t>(bytes) : kNone;
}

// Returns the limit of the control group as a container sees it; "max" is no number and means no limit.
uint64_t limit_in(const char* file) {
  std::ifstream in(file);
  uint64_t bytes = 0;
  return in >> bytes ? bytes : kNone;
}

uint64_t resource_limit() {
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY ? limit.rlim_cur : kNone;
}

}  // namespace

// Writes at most 1 GiB at once, because the kernel accepts no more than 2 GiB.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), std::min(bytes.size(), size_t{1} << 30));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return 0;
}

// Not every file system can flush; one that reports so has nothing to lose.
int flush_file(int file) { return ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno; }

// A folder with write but without read permission cannot be opened and hence not flushed; this is no error.
int flush_folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return errno == EACCES ? 0 : errno;
  const int code = flush_file(descriptor);
  ::close(descriptor);
  return code;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      beside_(std::exchange(other.beside_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!beside_.empty()) ::unlink(beside_.c_str());
}

Result<AtomicFile> AtomicFile::open(const std::filesystem::path& path) {
  if (!path.has_filename()) return write_error(path, path.empty() ? ENOENT : EISDIR);
  struct stat there {};
  const bool exists = ::stat(path.c_str(), &there) == 0;
  if (exists && S_ISDIR(there.st_mode)) return write_error(path, EISDIR);
  // rename() would replace a file without permission to write it.
  if (exists && ::access(path.c_str(), W_OK) != 0) return write_error(path, errno);
  AtomicFile file;
  file.path_ = file.target_ = path;
  if (exists && !S_ISREG(there.st_mode)) {
    file.descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file.descriptor_ < 0) return write_error(path, errno);
    return file;
  }
  // Replacing it would lose what the stream has written or appends to.
  if (exists) file.descriptor_ = stream_to(there);
  if (file.descriptor_ >= 0) return file;
  std::error_code unresolved;
  const std::filesystem::path target = std::filesystem::canonical(path, unresolved);
  if (exists && !unresolved) file.target_ = target;
  if (!exists) file.target_ = link_target(path);
  const auto [beside, descriptor] = open_beside(file.target_);
  if (descriptor < 0) return write_error(exists ? path : file.target_, errno);
  file.beside_ = beside;
  file.descriptor_ = descriptor;
  // Fails if the user may write the file but does not own it; the file is then written without its
  // permissions.
  if (exists) std::ignore = ::fchmod(descriptor, there.st_mode & 07777);
  return file;
}

Status AtomicFile::append(std::string_view bytes) {
  const int code = write_all(descriptor_, bytes);
  if (code != 0) return write_error(path_, code);
  return Done{};
}

Status AtomicFile::commit() {
  int code = flush_file(descriptor_);
  if (::close(std::exchange(descriptor_, -1)) != 0 && code == 0) code = errno;
  if (code == 0 && !beside_.empty()) {
    if (::rename(beside_.c_str(), target_.c_str()) != 0) return write_error(path_, errno);
    beside_.clear();
    code = flush_folder_of(target_);
  }
  if (code != 0) return write_error(path_, code);
  return Done{};
}

Status check_writable(const std::filesystem::path& path) {
  std::error_code unknown;
  if (fs::is_other(path, unknown)) return Done{};
  const auto trial = AtomicFile::open(path);
  return trial ? Status(Done{}) : trial.error();
}

Status write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  return write_file_atomically(path, [&](const ByteSink& sink) { sink(bytes); });
}

Status write_file_atomically(const std::filesystem::path& path,
                             const std::function<void(const ByteSink&)>& produce) {
  auto file = AtomicFile::open(path);
  if (!file) return file.error();
  Status written = Done{};
  produce([&](std::string_view bytes) {
    written = file->append(bytes);
    return written.ok();
  });
  return written ? file->commit() : written;
}

fs::path settings_folder() { return folder_by("XDG_CONFIG_HOME", ".config"); }

fs::path state_folder() { return folder_by("XDG_STATE_HOME", ".local/state"); }

fs::path home_folder() {
  const char* home = std::getenv("HOME");
  return home != nullptr ? home : "";
}

uint64_t machine_memory() {
  return std::min({physical_memory(), limit_in("/sys/fs/cgroup/memory.max"),
                   limit_in("/sys/fs/cgroup/memory/memory.limit_in_bytes"), resource_limit()});
}

}  // namespace kerf
