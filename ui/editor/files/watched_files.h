#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ui/editor/shared/document_session.h"
#include "ui/window/layout.h"

namespace kerf {

// Detects changes to files by other programs, by their size and the time of their last modification.
class WatchedFiles {
 public:
  // Records the present state of the files. Files that cannot be read count as changed once they can.
  void watch(const std::vector<std::filesystem::path>& files);
  // Returns the files whose state differs from the recorded one. A file counts once its state is the same in
  // two successive calls, i.e. the other program has finished writing, and if it exists. O(files).
  std::vector<std::filesystem::path> changed();
  // Returns true if the last call of changed() found a new state, which the next call may report.
  bool awaits_check() const { return awaits_check_; }

 private:
  struct State {
    int64_t time = 0;  // ticks of the clock of files; 0: no such file
    uint64_t size = 0;
    friend bool operator==(const State&, const State&) = default;
  };
  struct File {
    std::filesystem::path path;
    State known, seen;
  };
  static State state_of(const std::filesystem::path& file);

  std::vector<File> files_;
  bool awaits_check_ = false;
};

// Returns the files of the open document: its journal or the files from which it was opened, and its meshes.
std::vector<std::filesystem::path> files_of(const DocumentSession& session);

// Returns the files that a mesh file refers to, as its reader finds them: libraries of materials (MTL) and
// their images, buffers and images of glTF. They need not exist. References beyond the first 4 MB of a file
// are left out, so that this takes a bounded time.
std::vector<std::filesystem::path> side_files_of(const std::filesystem::path& mesh);

// Returns the files that open the document again: its journal, or those from which it was opened.
std::vector<std::filesystem::path> files_to_reload(const DocumentSession& session);

// Returns the first of the changed files that is a mesh of the open document and no longer has the content by
// which its journal refers to it; nullopt if there is none. Reads these meshes.
std::optional<std::filesystem::path> mismatched_mesh(const DocumentSession& session,
                                                     const std::set<std::filesystem::path>& changed);

// Returns the first of the changed files that is a buffer (.bin) of a glTF mesh of the open document; nullopt
// if there is none. A journal stores no hash of it, so that it opens with the new content.
std::optional<std::filesystem::path> changed_buffer(const DocumentSession& session,
                                                    const std::set<std::filesystem::path>& changed);

// "car.obj was changed by another program.", or with the number of further files.
std::string words_on_changed(const std::vector<std::filesystem::path>& files);

enum class ReloadChoice { kNone, kReload, kKeep };

// Draws a card that offers to reload changed files, at the right border of the viewport under the axes gizmo.
// Not modal.
ReloadChoice draw_reload_card(const std::vector<std::filesystem::path>& changed, const Area& viewport);

}  // namespace kerf
