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
#include <string>
#include <vector>

#include "core/base/assert.h"
#include "core/base/result.h"
#include "core/document/autosave.h"
#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/save.h"
#include "core/document/scene.h"
#include "core/world/world.h"
#include "ui/render/bodies/base_faces.h"
#include "ui/window/status_message.h"

namespace kerf {

// Entries that features store in the head of a document (SceneDescription::others).

// Returns the entry of a key, or null.
nlohmann::json head_entry(const SceneDescription& scene, const char* key);
// Sets an entry; null removes it.
void set_head_entry(SceneDescription& scene, const char* key, const nlohmann::json& entry);

// A partially replayed world with its render data.
struct PartialReplay {
  SceneDescription scene;
  World world;  // a copy
  PreparedBodies prepared;
};

// Status of a thread that reads files, for the thread that waits for it.
class LoadProgress {
 public:
  // Reader: sets the current task, a word or two.
  void set_task(const char* what) { doing_ = what; }
  // Reader, after every step that cuts: publishes a copy of the world. Skips this if it is not watched, the
  // world is too large (see Document::kMaxFacesToCopy), the last copy was not taken, or copying would take
  // too much of the time. `prepared` holds the bodies as loaded. O(faces) for a copy.
  void show(const SceneDescription& scene, const World& world, const PreparedBodies& prepared);

  // Waiting thread, before the reader starts: requests copies.
  void watch() { watched_ = true; }
  const char* doing() const { return doing_; }
  // Returns the last published copy, once.
  std::optional<PartialReplay> take();

 private:
  using Clock = std::chrono::steady_clock;

  std::atomic<const char*> doing_ = "reading";
  bool watched_ = false;
  Clock::time_point next_ = Clock::now();  // earliest time of the next copy; for the reader alone
  std::mutex mutex_;
  std::optional<PartialReplay> partial_replay_;  // guarded by mutex_
};

struct LoadRequest {
  // Scenes and meshes that form one scene, or a single journal. Unreadable ones of several are left out.
  std::vector<std::filesystem::path> files;
  // Recoverable work of a crashed editor, instead of files.
  std::optional<Journal> left;
  size_t history_bytes = 0;  // see Document::set_window
  // Mesh files that are read instead of others, which a journal or a scene names.
  std::map<std::filesystem::path, std::filesystem::path> moved{};
  std::filesystem::file_time_type left_at{};  // last change of the recoverable work

  // Returns the displayed name: "bunny.ply and 1 more".
  std::string name() const;
};

// Files that were read: the document in its saved state, and its render data.
struct LoadedFiles {
  LoadRequest order;                 // with the files that were read
  std::vector<std::string> refused;  // reasons for files left out, a sentence each
  SceneDescription scene;
  Document document;               // the strokes of the scene are cut, the journal is replayed
  std::optional<World> as_loaded;  // a copy; nullopt if the world is too large
  PreparedBodies prepared;         // also the bodies that commands of the journal created, as created
  bool shadows_later = false;      // shadow casters of a large world are not prepared yet
  std::vector<StateMark> marks;
  bool damaged = false;                 // part of the journal could not be read
  Ticks skipped = 0;                    // not simulated: bodies were set to their recorded states
  std::string notes;                    // repairs of the first file that needed any
  std::string fault;                    // of the strokes or the journal, a sentence or empty
  std::optional<Error> cannot_be_kept;  // reason why the work cannot be saved
};

// Returns the first mesh file that a single scene or journal, or recoverable work, names and that does not
// exist; nullopt if there is none. Reads the scene or journal.
std::optional<std::filesystem::path> missing_mesh(const LoadRequest& order);

// Reads the files and applies their strokes or commands. Keeps the view of a single file. Fails if no file
// can be read. `progress` may be null. `news`, unless null, receives the current task and copies of the
// world during a replay. Precondition: there are files or recoverable work.
Result<LoadedFiles> load_files(LoadRequest order, const Progress* progress, LoadProgress* news = nullptr);

// Returns the journal that Save writes once the files are open. Returns an empty path, so that Save asks for
// a name, if that would replace something that is not in the document: an unreadable part of the journal, a
// previous version (.kerf~), or changes saved after recoverable work was last changed.
std::filesystem::path file_to_save(const LoadedFiles& loaded);
// "Recovered unsaved work", and if its file was saved later, that Save asks for a name. Precondition:
// recoverable work.
std::string words_on_recovery(const LoadedFiles& loaded);

// Reads files on a background thread into a separate world.
class FileLoader {
 public:
  FileLoader() = default;
  FileLoader(const FileLoader&) = delete;
  FileLoader& operator=(const FileLoader&) = delete;
  // Cancels the current job, and waits for the threads to end.
  ~FileLoader() { cancel(); }

  // Cancels the current job and starts to read files. `watched`: take_partial_replay() will be called.
  void start(LoadRequest order, bool watched = false);
  // Cancels the current job; its thread ends at its next report of progress.
  void cancel();
  bool busy() const { return job_ != nullptr; }
  // Waits for the end, at most `seconds`. Returns true if the job has ended. Precondition: busy().
  bool is_over(double seconds) const;

  // The request being read. Precondition: busy().
  const LoadRequest& order() const {
    KERF_ASSERT(busy());
    return job_->order;
  }
  // Progress, 0 to 1. Precondition: busy().
  double fraction() const { return job_->fraction; }
  // The current task: "reading". Precondition: busy().
  const char* doing() const { return job_->news.doing(); }
  // Returns the latest partially replayed world, once for each published state. Precondition: busy().
  std::optional<PartialReplay> take_partial_replay() { return job_->news.take(); }

  // Returns the result of a finished job, once; otherwise nullopt.
  std::optional<Result<LoadedFiles>> take();

 private:
  struct Job {
    LoadRequest order;
    std::atomic<double> fraction = 0;
    LoadProgress news;
    std::atomic<bool> cancelled = false;
    std::future<Result<LoadedFiles>> result;
  };
  std::unique_ptr<Job> job_;
  std::vector<std::unique_ptr<Job>> cancelled_;  // until their threads end
};

// The open document, its origin and its saved state.
struct DocumentSession {
  Document document;
  std::vector<std::filesystem::path> files;  // files from which the document was read
  std::optional<World> as_loaded;            // a copy; nullopt if the world is too large
  std::map<std::string, Paint> paints;

  SceneDescription scene;      // as opened
  std::filesystem::path file;  // the journal that Save writes; empty: none yet
  std::vector<StateMark> marks;
  size_t saved_commands = 0;        // number of journal commands saved; kNothing: not even the opened state
  std::vector<Light> saved_lights;  // in the file, turned to the shown frame
  std::string saved_head = "{}";    // SceneDescription::others in the file

  static constexpr size_t kNothing = static_cast<size_t>(-1);
  const World& world() const { return document.world(); }
};

// The files that the document was read from, and its meshes.
inline InputFiles inputs_of(const DocumentSession& session) {
  InputFiles inputs = input_files(session.files);
  inputs.add_meshes(session.scene);
  inputs.add_meshes(session.document.journal());
  return inputs;
}

struct Opening {
  FileLoader loader;
  std::optional<World> partial_world;            // of a replay, shown on the empty stage
  std::vector<RecoverableDocument> recoverable;  // of crashed editors, not offered yet
};

// Cancels reading and reports it; the open document is unchanged. Precondition: the loader is busy.
void cancel_opening(Opening& opening, Message& message);

}  // namespace kerf
