#pragma once

#include <atomic>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/assert.h"
#include "core/base/result.h"
#include "core/document/history/document.h"
#include "core/document/journal/journal.h"
#include "core/document/journal/opened_file.h"
#include "ui/editor/shared/files/load_news.h"
#include "ui/render/bodies/prepared_body.h"

namespace kerf {

// What is to be opened in place of the open work.
struct LoadOrder {
  // Scenes and meshes that form one scene, or a single journal. Of several, those that cannot be read are
  // left out.
  std::vector<std::filesystem::path> files;
  // Work that a crashed editor left, instead of files.
  std::optional<Journal> left;
  size_t history_bytes = 0;  // see Document::set_window

  // A name for the user: "bunny.ply and 1 more".
  std::string name() const;
};

// Files that were read: the document in its saved state, and the data for drawing it.
struct LoadedFiles {
  LoadOrder order;                   // with the files that were read
  std::vector<std::string> refused;  // why others of its files were not, a sentence each
  SceneDescription scene;
  Document document;               // the strokes of the scene are cut, the journal is replayed
  std::optional<World> as_loaded;  // a copy, where the world is not too large for one
  PreparedBodies prepared;
  bool shadows_later = false;  // the shadow casters of a large world are not prepared
  std::vector<StateMark> marks;
  bool damaged = false;                 // not all of the journal could be read
  Ticks skipped = 0;                    // for which bodies were not moved, but put where they came to be
  std::string notes;                    // what was put right in the first file that needed it
  std::string fault;                    // of the strokes or the journal, a sentence or empty
  std::optional<Error> cannot_be_kept;  // why the work cannot be saved
};

// Reads the files and applies their strokes or commands. The view of a single file is kept. Fails if none of
// the files can be read. `progress` may be null. `news`, unless null, hears what is being done, and is shown
// the world while it is cut again. Precondition: there are files or left work.
Result<LoadedFiles> load_files(LoadOrder order, const Progress* progress, LoadNews* news = nullptr);

// Reads files on a background thread into a separate world while the editor goes on.
class FileLoader {
 public:
  // Cancels the current job and starts reading these files. `watched`: take_so_far() will be called.
  void start(LoadOrder order, bool watched = false);
  // Cancels the current job; its thread ends at its next report of progress.
  void cancel();
  bool busy() const { return job_ != nullptr; }
  // Waits for the end for at most the given time (s). Returns whether it has ended. Precondition: busy().
  bool is_over(double seconds) const;

  // What is being read. Precondition: busy().
  const LoadOrder& order() const {
    KERF_ASSERT(busy());
    return job_->order;
  }
  // The progress from 0 to 1. Precondition: busy().
  double fraction() const { return job_->fraction; }
  // What is being done: "reading". Precondition: busy().
  const char* doing() const { return job_->news.doing(); }
  // The world as far as it is cut again, once for each state that was shown. Precondition: busy().
  std::optional<CutSoFar> take_so_far() { return job_->news.take(); }

  // The result of a finished job, once; nothing otherwise.
  std::optional<Result<LoadedFiles>> take();

 private:
  struct Job {
    LoadOrder order;
    std::atomic<double> fraction = 0;
    LoadNews news;
    std::atomic<bool> given_up = false;
    std::future<Result<LoadedFiles>> result;
  };
  std::unique_ptr<Job> job_;
  std::vector<std::unique_ptr<Job>> given_up_;  // until their threads have ended
};

}  // namespace kerf
