#include "core/document/journal/autosave.h"

#include <unistd.h>

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".kerf";

size_t count_strokes(const Journal& journal) {
  return static_cast<size_t>(
      std::count_if(journal.commands.begin(), journal.commands.end(),
                    [](const Command& c) { return std::holds_alternative<BeginStroke>(c); }));
}

}  // namespace

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

Status Autosave::follow(const Document& document, std::span<const StateMark> marks) {
  const std::span<const Command> commands = std::span(document.journal()).first(document.final_commands());
  if (file_ && commands.size() == commands_ && marks.size() == marks_) {
    flush();
    return Done{};
  }
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
    return failed(folder_.string() + ": the folder for unsaved work cannot be made: " + error.message());
  const std::string stem = "unsaved-" + std::to_string(::getpid()) + "-";
  size_t number = 1;
  while (fs::exists(folder_ / (stem + std::to_string(number) + kEnding), error)) ++number;
  return LockedFile::create(folder_ / (stem + std::to_string(number) + kEnding), text);
}

std::vector<LeftWork> find_left_work(const fs::path& folder, std::vector<std::string>& faults) {
  std::vector<LeftWork> left;
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
    const size_t strokes = count_strokes(*journal);
    std::error_code unknown;
    left.push_back({std::move(*file), std::move(*journal), strokes, fs::last_write_time(path, unknown)});
  }
  std::sort(left.begin(), left.end(),
            [](const LeftWork& a, const LeftWork& b) { return a.last_change > b.last_change; });
  return left;
}

}  // namespace kerf
