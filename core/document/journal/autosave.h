#pragma once

#include <chrono>
#include <optional>

#include "core/document/files/locked_file.h"
#include "core/document/history/document.h"
#include "core/document/journal/journal.h"

namespace kerf {

// Keeps the unsaved work of one editor in a journal file that survives if the editor crashes. Each editor
// holds a lock on its own file and does not touch those of others.
class Autosave {
 public:
  explicit Autosave(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // Starts to keep a document with this scene, which was last saved to `work_of` (may be empty) and opened
  // from the files `opened`. The file of the previous document is removed once the new one is written.
  // Precondition: the meshes have hashes (see note_hashes).
  void begin(SceneDescription scene, std::filesystem::path work_of,
             std::vector<std::filesystem::path> opened = {});

  // Appends the final commands (see Document::final_commands) and marks since the last call; the first call
  // writes all of them to a new file. So time that passes is less than a second behind. On failure everything
  // written before is kept, and the next call tries again. The cost is proportional to what is new. The data
  // reach the disk asynchronously, for which follow or flush has to be called again within about a second.
  // Precondition: `document` and `marks` continue those of the last call.
  Status follow(const Document& document, std::span<const StateMark> marks);
  // Continues flushing to the disk. Returns whether anything is left to flush.
  bool flush() { return file_ && file_->flush(); }

  // Removes the file, because the work was saved or discarded. The next call of follow creates a new one.
  void drop();

  // Whether a file with unsaved work exists.
  bool keeps() const { return file_.has_value() || replaced_.has_value(); }

 private:
  Result<LockedFile> create(std::string_view text) const;

  std::filesystem::path folder_;
  SceneDescription scene_;
  std::filesystem::path work_of_;
  std::vector<std::filesystem::path> opened_;
  std::optional<LockedFile> file_, replaced_;
  size_t commands_ = 0, marks_ = 0;  // numbers written to the file
};

// Unsaved work that a crashed editor left behind. No other editor finds it while this object holds the lock.
struct LeftWork {
  LockedFile file;
  Journal journal;
  size_t strokes = 0;
  std::filesystem::file_time_type last_change;
};

// Finds the work that crashed editors left in the folder, the latest first. Files of running editors are
// locked and are skipped. A file that cannot be read is left unchanged and adds a sentence to `faults`.
std::vector<LeftWork> find_left_work(const std::filesystem::path& folder, std::vector<std::string>& faults);

}  // namespace kerf
