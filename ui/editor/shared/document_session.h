#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/assert.h"
#include "core/base/result.h"
#include "core/document/autosave.h"
#include "core/document/document.h"
#include "core/document/input_files.h"
#include "core/document/journal.h"
#include "core/document/scene.h"
#include "core/world/world.h"
#include "ui/render/bodies/prepared_body.h"
#include "ui/window/status_message.h"

namespace kerf {

// Entries of features in the head of a document, beside those that a scene has anyway
// (SceneDescription::others).

// The entry of a key; null where there is none.
nlohmann::json head_entry(const SceneDescription& scene, const char* key);
// Sets an entry; null removes it.
void set_head_entry(SceneDescription& scene, const char* key, const nlohmann::json& entry);

// A world of which not everything is cut again yet, with the data for drawing it.
struct CutSoFar {
  SceneDescription scene;
  World world;  // a copy
  PreparedBodies prepared;
};

// What a thread that reads files says on the way to the thread that waits for it.
class LoadNews {
 public:
  // By the reader: what is being done, in a word or two.
  void say(const char* what) { doing_ = what; }
  // By the reader, after every step that cuts: shows a copy of the world, unless nobody watches, it is too
  // large for one (see Document::kMaxFacesToCopy), the last copy was not taken yet, or copying would take
  // more than a small part of the time. `shadings` has the bodies as loaded. O(faces) for a copy.
  void show(const SceneDescription& scene, const World& world, const LoadedShadings& shadings);

  // By whoever waits: he wants to be shown copies. Before the reader begins.
  void watch() { watched_ = true; }
  const char* doing() const { return doing_; }
  // The last copy that was shown, once.
  std::optional<CutSoFar> take();

 private:
  using Clock = std::chrono::steady_clock;

  std::atomic<const char*> doing_ = "reading";
  bool watched_ = false;
  Clock::time_point next_ = Clock::now();  // the reader copies no earlier; known to it alone
  std::mutex mutex_;
  std::optional<CutSoFar> so_far_;  // guarded by the mutex
};

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

// What is open: its document, where that came from, and how much of it is saved.
struct OpenWork {
  Document document;
  std::vector<std::filesystem::path> files;  // that the document was read from
  std::optional<World> as_loaded;            // a copy, where the world is not too large for one
  std::map<std::string, Paint> paints;

  SceneDescription scene;      // as it was opened
  std::filesystem::path file;  // the journal that Save writes to; empty: none yet
  std::vector<StateMark> marks;
  size_t saved_commands = 0;        // of the document's journal; kNothing: not even as it was opened
  std::vector<Light> saved_lights;  // that are in the file
  std::string saved_head = "{}";    // SceneDescription::others that is in the file

  static constexpr size_t kNothing = static_cast<size_t>(-1);
};

// The files that the document was read from, and its meshes.
inline InputFiles inputs_of(const OpenWork& work) {
  InputFiles inputs = input_files(work.files);
  inputs.add_meshes(work.scene);
  inputs.add_meshes(work.document.journal());
  return inputs;
}

// Files that are being read, and work that waits to be opened.
struct Opening {
  FileLoader loader;
  std::vector<LeftWork> left_work;  // of editors that died, about which the user was not asked yet
};

// Gives up what is being read and says so; what is open stays as it is. Precondition: the loader is busy.
void cancel_opening(Opening& opening, Message& message);

}  // namespace kerf
