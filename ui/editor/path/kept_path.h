#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/document/files/locked_file.h"
#include "ui/editor/path/path_work.h"

namespace kerf {

// Keeps a path that is not saved in a file of its own, so that the next editor shows it again, however this
// one ended. Each editor holds a lock on its file and does not touch those of others.
class KeptPath {
 public:
  // The file lies in this folder, which is made where it is missing.
  explicit KeptPath(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // The path that an editor left last, if one did; it stays kept until follow() knows better. Files of
  // running editors and files that cannot be read are left alone.
  std::optional<std::vector<StrokePath>> adopt();

  // Writes the path when it has changed and is not saved, at most twice a second; drops the file when the
  // path is saved or empty. `time` is that of a clock (s). Call it once a frame, and while the editor waits.
  // On failure what was kept before stays, and the next change tries again.
  Status follow(const PathWork& path, double time);
  // The same at once.
  Status follow(const PathWork& path) { return follow(path, written_at_ + kBetweenFiles); }

 private:
  static constexpr double kBetweenFiles = 0.5;  // s

  Status write(const std::vector<StrokePath>& strokes);

  std::filesystem::path folder_;
  std::optional<LockedFile> file_;
  size_t written_ = 0;  // the number of changes of the path that the file holds
  size_t number_ = 0;   // of the last file
  double written_at_ = -kBetweenFiles;
};

}  // namespace kerf
