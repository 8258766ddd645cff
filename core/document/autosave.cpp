#include "core/document/autosave.h"

#include <aio.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <memory>
#include <system_error>
#include <tuple>
#include <utility>

#include "core/base/assert.h"
#include "core/base/platform.h"
#include "core/document/command_log.h"

namespace kerf {

// The C library flushes on its own thread, so the request must not move.
struct LockedFile::Handle {
  int descriptor = -1;
  off_t size = 0;
  bool flushing = false, appended = false;  // appended: since the last flush began
  std::unique_ptr<aiocb> request = std::make_unique<aiocb>();

  ~Handle() {
    if (flushing) {
      const aiocb* const wait_for = request.get();
      while (::aio_error(request.get()) == EINPROGRESS) ::aio_suspend(&wait_for, 1, nullptr);
      ::aio_return(request.get());
    }
    ::close(descriptor);  // this releases the lock
  }
};

namespace fs = std::filesystem;

namespace {

Error file_error(const std::filesystem::path& path, const char* what, int code) {
  return failed(path.string() + ": " + what + ": " + std::generic_category().message(code));
}

// Creates a file under a temporary name and locks it. Returns the error number, or 0. Does not touch
// temporary files of crashed programs.
int open_new(const std::filesystem::path& path, std::filesystem::path& nameless, int& descriptor) {
  for (int attempt = 0;; ++attempt) {
    nameless = path.parent_path() / ("." + path.filename().string() + "." + std::to_string(attempt) + ".new");
    descriptor = ::open(nameless.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0600);
    if (descriptor >= 0) return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    if (errno != EEXIST || attempt == 1000) return errno;
  }
}

// Moves a file to its name if no such file exists; if the file system does not support links, in any case.
// Returns the error number, or 0.
int give_name(const std::filesystem::path& nameless, const std::filesystem::path& path) {
  if (::link(nameless.c_str(), path.c_str()) == 0) return 0;
  if (errno != EPERM && errno != ENOTSUP && errno != ENOSYS) return errno;
  return ::rename(nameless.c_str(), path.c_str()) == 0 ? 0 : errno;
}

constexpr const char* kEnding = ".kerf";

bool is_cut(const Command& command) {
  return std::holds_alternative<BeginStroke>(command) || std::holds_alternative<Recut>(command) ||
         std::holds_alternative<CutPlane>(command) || std::holds_alternative<CutPath>(command);
}

size_t count_cuts(const Journal& journal) {
  const std::vector<bool> lasting = lasting_commands(journal.commands);
  size_t cuts = 0;
  for (size_t i = 0; i < journal.commands.size(); ++i) cuts += lasting[i] && is_cut(journal.commands[i]);
  return cuts;
}

}  // namespace

LockedFile::LockedFile(std::filesystem::path path, Handle* handle)
    : path_(std::move(path)), handle_(handle) {}

LockedFile::LockedFile(LockedFile&& other) noexcept
    : path_(std::move(other.path_)), handle_(std::exchange(other.handle_, nullptr)) {}

LockedFile& LockedFile::operator=(LockedFile&& other) noexcept {
  path_.swap(other.path_);
  std::swap(handle_, other.handle_);
  return *this;
}

LockedFile::~LockedFile() { delete handle_; }

Result<LockedFile> LockedFile::create(const std::filesystem::path& path, std::string_view bytes) {
  // The file gets its name when it is locked and complete, so that no program mistakes it for an abandoned
  // one.
  std::filesystem::path nameless;
  int descriptor = -1;
  int code = open_new(path, nameless, descriptor);
  if (descriptor < 0) return file_error(path, "cannot be created", code);
  LockedFile file(path, new Handle{descriptor});
  if (code == 0) code = write_all(descriptor, bytes);
  if (code == 0) code = flush_file(descriptor);
  if (code == 0) code = give_name(nameless, path);
  ::unlink(nameless.c_str());
  if (code == 0) {
    code = flush_folder_of(path);
    if (code != 0) ::unlink(path.c_str());
  }
  if (code != 0) return file_error(path, "cannot be written", code);
  file.handle_->size = static_cast<off_t>(bytes.size());
  return file;
}

Result<LockedFile> LockedFile::open(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor < 0) return file_error(path, "cannot be opened", errno);
  LockedFile file(path, new Handle{descriptor});
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return file_error(path, "cannot be locked", errno);
  struct stat there {};
  if (::fstat(descriptor, &there) != 0) return file_error(path, "cannot be inspected", errno);
  if (there.st_nlink == 0)
    return file_error(path, "cannot be opened", ENOENT);  // removed by the program that had locked it
  file.handle_->size = there.st_size;
  return file;
}

Status LockedFile::append(std::string_view bytes) {
  KERF_ASSERT(handle_);
  const int code = write_all(handle_->descriptor, bytes);
  if (code != 0) {
    std::ignore = ::ftruncate(handle_->descriptor, handle_->size);
    return file_error(path_, "cannot be written", code);
  }
  handle_->size += static_cast<off_t>(bytes.size());
  handle_->appended = handle_->appended || !bytes.empty();
  return Done{};
}

bool LockedFile::flush() {
  KERF_ASSERT(handle_);
  Handle& h = *handle_;
  if (h.flushing && ::aio_error(h.request.get()) == EINPROGRESS) return true;
  if (h.flushing) ::aio_return(h.request.get());
  h.flushing = false;
  if (!h.appended) return false;
  *h.request = {};
  h.request->aio_fildes = h.descriptor;
  h.request->aio_sigevent.sigev_notify = SIGEV_NONE;
  h.flushing = ::aio_fsync(O_DSYNC, h.request.get()) == 0;
  h.appended = !h.flushing;
  return h.flushing;
}

bool LockedFile::is_removed() const {
  KERF_ASSERT(handle_);
  struct stat there {};
  return ::fstat(handle_->descriptor, &there) == 0 && there.st_nlink == 0;
}

// A file that was removed by another program may have a successor of the same name.
void LockedFile::remove() {
  if (!is_removed()) ::unlink(path_.c_str());
}

void Autosave::begin(SceneDescription scene, fs::path work_of, std::vector<fs::path> opened) {
  if (file_) replaced_ = std::move(*file_);
  file_.reset();
  commands_ = marks_ = 0;
  scene_ = std::move(scene);
  work_of_ = std::move(work_of);
  opened_ = std::move(opened);
}

void Autosave::drop() {
  for (std::optional<LockedFile>* file : {&file_, &replaced_}) {
    if (*file) (*file)->remove();
    file->reset();
  }
  commands_ = marks_ = 0;
}

bool Autosave::is_behind(const Document& document, std::span<const StateMark> marks) const {
  return !file_ || document.final_commands() != commands_ || marks.size() != marks_ || file_->is_removed();
}

Status Autosave::follow(const Document& document, std::span<const StateMark> marks) {
  if (!is_behind(document, marks)) {
    flush();
    return Done{};
  }
  if (file_ && file_->is_removed()) {
    file_.reset();
    commands_ = marks_ = 0;
  }
  const std::span<const Command> commands = std::span(document.journal()).first(document.final_commands());
  KERF_ASSERT(commands.size() >= commands_ && marks.size() >= marks_);
  // Marks count commands from the start of the document.
  std::vector<StateMark> fresh(marks.begin() + static_cast<std::ptrdiff_t>(marks_), marks.end());
  for (StateMark& mark : fresh) mark.commands -= commands_;
  const auto lines = journal_lines(commands.subspan(commands_), fresh, {});
  if (!lines) return lines.error();
  if (file_) {
    if (const auto appended = file_->append(*lines); !appended) return appended;
  } else {
    const auto head = journal_head(scene_, work_of_, {}, opened_);
    if (!head) return head.error();
    auto file = create(*head + *lines);
    if (!file) return file.error();
    file_ = std::move(*file);
    if (replaced_) replaced_->remove();
    replaced_.reset();
  }
  commands_ = commands.size();
  marks_ = marks.size();
  flush();
  return Done{};
}

Result<LockedFile> Autosave::create(std::string_view text) const {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error)
    return failed(folder_.string() + ": cannot create the folder for unsaved work: " + error.message());
  const std::string stem = "unsaved-" + std::to_string(::getpid()) + "-";
  size_t number = 1;
  while (fs::exists(folder_ / (stem + std::to_string(number) + kEnding), error)) ++number;
  return LockedFile::create(folder_ / (stem + std::to_string(number) + kEnding), text);
}

std::vector<RecoverableDocument> find_recoverable_documents(const fs::path& folder,
                                                            std::vector<std::string>& faults) {
  std::vector<RecoverableDocument> left;
  std::error_code error;
  fs::directory_iterator at(folder, error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    const fs::path path = at->path();
    if (path.extension() != kEnding || path.filename().string().starts_with('.')) continue;
    auto file = LockedFile::open(path);
    if (!file) continue;  // the editor that wrote it is running
    auto journal = read_journal(path);
    if (!journal) {
      faults.push_back(journal.error().message);
      continue;
    }
    const size_t cuts = count_cuts(*journal);
    std::error_code unknown;
    left.push_back({std::move(*file), std::move(*journal), cuts, fs::last_write_time(path, unknown)});
  }
  std::sort(left.begin(), left.end(), [](const RecoverableDocument& a, const RecoverableDocument& b) {
    return a.last_change > b.last_change;
  });
  return left;
}

}  // namespace kerf
