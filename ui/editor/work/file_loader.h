#pragma once

#include <atomic>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/work.h"
#include "ui/render/prepared_body.h"

namespace kerf {

// What is to be opened in place of what is open.
struct LoadOrder {
  // Scenes and meshes, together as one scene, or a journal alone.
  std::vector<std::filesystem::path> files;
  // Work that an editor left, in place of files.
  std::optional<Journal> left;
  size_t history_bytes = 0;  // see Document::set_window

  // For people: "bunny.ply and 1 more".
  std::string name() const;
};

// Files that were read: the document as it stood, and what pictures of it need.
struct LoadedFiles {
  LoadOrder order;
  SceneDescription scene;
  Document document;               // the strokes of the scene are cut, the journal is replayed
  std::optional<World> as_loaded;  // a copy, where the world is not too large for one
  PreparedBodies prepared;
  std::vector<StateMark> marks;
  bool damaged = false;                 // not all of the journal could be read
  std::string notes;                    // what was put right in the first file that needed it
  std::string fault;                    // of the strokes or the journal, a sentence or empty
  std::optional<Error> cannot_be_kept;  // why the work cannot be saved
};

// Reads it, lets happen what it says. Where there is one file, its view is the scene's. `progress` may be
// null.
Result<LoadedFiles> load_files(LoadOrder order, const Progress* progress);

// Reads files on a thread of its own, into a world of its own, while the editor goes on.
class FileLoader {
 public:
  // Gives up what is being read, and reads these.
  void start(LoadOrder order);
  // Gives up what is being read. Its thread ends when it next tells how far it is.
  void cancel();
  bool busy() const { return job_ != nullptr; }
  // Waits so long for its end (s); whether that came.
  bool is_over(double seconds) const;

  // What is being read.
  const LoadOrder& order() const { return job_->order; }
  // How far it is, 0 to 1.
  double fraction() const { return job_->fraction; }

  // What was read or why it could not be, once.
  std::optional<Result<LoadedFiles>> take();

 private:
  struct Job {
    LoadOrder order;
    std::atomic<double> fraction = 0;
    std::atomic<bool> given_up = false;
    std::future<Result<LoadedFiles>> result;
  };
  std::unique_ptr<Job> job_;
  std::vector<std::unique_ptr<Job>> given_up_;  // until their threads have ended
};

}  // namespace kerf
