#include "ui/editor/path/kept_path.h"

#include <unistd.h>

#include "core/document/files/path_text.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

bool is_kept_path(const fs::path& file) {
  return file.filename().string().starts_with("path-") && file.extension() == ".json";
}

}  // namespace

std::optional<std::vector<StrokePath>> KeptPath::adopt() {
  std::optional<std::vector<StrokePath>> left;
  fs::file_time_type latest = fs::file_time_type::min();
  std::error_code error;
  fs::directory_iterator at(folder_, error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    std::error_code unknown;
    const fs::file_time_type time = fs::last_write_time(at->path(), unknown);
    if (!is_kept_path(at->path()) || unknown || time <= latest) continue;
    auto file = LockedFile::open(at->path());
    if (!file) continue;  // the editor that wrote it is running
    auto strokes = read_path_file(at->path());
    if (!strokes) continue;
    left = std::move(*strokes);
    file_ = std::move(*file);
    latest = time;
  }
  return left;
}

Status KeptPath::follow(const PathWork& path, double time) {
  if (path.changes() == written_) {
    if (file_) file_->flush();
    return Done{};
  }
  if (time < written_at_ + kBetweenFiles) return Done{};
  written_ = path.changes();
  written_at_ = time;
  if (path.is_unsaved()) return write(path.strokes());
  if (file_) file_->remove();
  file_.reset();
  return Done{};
}

Status KeptPath::write(const std::vector<StrokePath>& strokes) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error)
    return failed(folder_.string() + ": the folder for unsaved work cannot be made: " + error.message());
  const std::string stem = "path-" + std::to_string(::getpid()) + "-";
  do {
    ++number_;
  } while (fs::exists(folder_ / (stem + std::to_string(number_) + ".json"), error));
  auto file =
      LockedFile::create(folder_ / (stem + std::to_string(number_) + ".json"), path_file_text(strokes));
  if (!file) return file.error();
  if (file_) file_->remove();
  file_ = std::move(*file);
  file_->flush();
  return Done{};
}

}  // namespace kerf
