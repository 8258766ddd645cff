#pragma once

#include <chrono>
#include <optional>

#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/locked_file.h"

namespace kerf {

// Where editors keep journals of what is not saved: kerf under $XDG_STATE_HOME, or under ~/.local/state where
// that is not set.
std::filesystem::path state_folder();

// Keeps the unsaved work of one editor in a journal of its own, which outlives the editor if that dies.
// Editors do not touch each other's: each has its own locked.
class Autosave {
 public:
  explicit Autosave(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // From now on it keeps a document with this scene, whose meshes must have hashes. What it kept of another
  // is removed.
  void begin(SceneDescription scene, std::filesystem::path work_of);

  // Appends what the document did since the last call; the first call writes all of it to a new file. On
  // failure nothing is lost that was kept before, and the next call tries again. Costs what is new; what was
  // written reaches the disk by itself soon after, provided that this, or flush, is called again within the
  // second that it may take.
  Status follow(const Document& document, std::span<const StateMark> marks);
  // Whether there is something left to flush.
  bool flush() { return file_ && file_->flush(); }

  // The work is saved or not wanted: its file goes. The next follow makes a new one.
  void drop();

  bool keeps() const { return file_.has_value() || replaced_.has_value(); }

 private:
  Result<LockedFile> create(std::string_view text) const;

  std::filesystem::path folder_;
  SceneDescription scene_;
  std::filesystem::path work_of_;
  std::optional<LockedFile> file_, replaced_;
  size_t commands_ = 0, marks_ = 0;  // that are in it
};

// Unsaved work that an editor left when it died. Nobody else is offered it while this lives.
struct LeftWork {
  LockedFile file;
  Journal journal;
  size_t strokes = 0;
  std::filesystem::file_time_type last_change;
};

// What dead editors left in the folder, the latest first. Files of living editors are not looked at. Files
// that cannot be read are left as they are, each with a sentence in `faults`.
std::vector<LeftWork> find_left_work(const std::filesystem::path& folder, std::vector<std::string>& faults);

}  // namespace kerf
