#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/document/document.h"
#include "core/document/journal.h"
#include "ui/render/bodies/base_faces.h"

namespace kerf {

// A change of the document that takes longer than a frame.
struct LongChange {
  std::string title;  // shown to the user
  std::function<Outcome(Document&, const Progress&)> run;
  std::function<void(const Outcome&)> then;  // on the thread that finishes it
};

// Runs a long change on a background thread. Until it is finished, only that thread may access the document.
class ChangeThread {
 public:
  ChangeThread() = default;
  ChangeThread(ChangeThread&&) = default;
  ChangeThread& operator=(ChangeThread&&) = default;
  ~ChangeThread();

  // Starts a change. Preconditions: none is running, the document outlives it, and both functions are set.
  void start(Document& document, LongChange change);
  bool busy() const { return job_ != nullptr; }

  // The title of the running change. Precondition of this and the following: busy().
  const std::string& title() const { return job_->change.title; }
  // Returns true if the change has reported progress, so that it can be stopped.
  bool can_stop() const { return job_->told && !job_->stopped; }
  double fraction() const { return job_->fraction; }  // 0 to 1

  // Requests a stop; the change ends at its next report of progress.
  void stop() { job_->stopped = true; }
  // Waits for the end, at most `seconds`. Returns true if it has ended.
  bool is_over(double seconds) const;
  // Waits for the end and calls the continuation of the change.
  void finish();

 private:
  struct Job {
    LongChange change;
    std::atomic<double> fraction = 0;
    std::atomic<bool> told = false, stopped = false;
    std::future<Outcome> result;
  };
  std::unique_ptr<Job> job_;
};

// Returns true if the world is so small that changes of its bodies take only a part of a frame.
bool is_small(const Document& document);

// Returns true if a command takes only a part of a frame.
bool is_quick(const Document& document, const Command& command);

// Describes the next step of the document in a few words if it has to run in the background, because it
// makes bodies or colliders of many faces; otherwise returns null. O(pieces).
const char* background_reason(const Document& document);

// Consecutive history steps of one user action, such as hiding several pieces, undone together and listed as
// one. The document does not store groups: they last as long as the editor is open.
class StepGroups {
 public:
  struct Group {
    size_t from = 0, to = 0;  // positions of the history
    std::string name;
    bool is_marked = false;  // in the journal
  };

  // Drops groups with steps that are no longer in the history. Called at least once per frame. O(new
  // commands). Precondition: it is always the same document.
  void follow(const Document& document);
  // Groups the steps from a position up to that of the document, if there is more than one.
  void add(size_t from, const Document& document, std::string name);
  // Appends marks with the groups that have none, unless a stroke is being drawn or cut.
  void mark(Document& document, std::vector<StateMark>& marks);
  // Replaces the groups by those of the marks of a journal. O(commands).
  void restore(const Document& document, std::span<const StateMark> marks);
  // Returns true if the list of the history has a row for a position: not within a group.
  bool has_row(size_t position) const;
  // Returns the group that an undo (`back`) or a redo from a position covers, or null. Valid until the next
  // call of follow() or add().
  const Group* at(size_t position, bool back) const;

 private:
  std::vector<Group> groups_;
  size_t position_ = 0, commands_ = 0;  // of the history and of the journal, at the last follow()
};

class Renderer;
struct Workspace;

// Changes the open document and updates the viewport, the pieces and the statistics. Errors are shown in the
// status bar. A change that takes longer than a frame becomes pending; no function that changes the world
// may be called until the pending change was taken and completed.
class WorldChanges {
 public:
  // The workspace must outlive it and its pending changes.
  explicit WorldChanges(Workspace& workspace) : workspace_(workspace) {}
  WorldChanges(const WorldChanges&) = delete;
  WorldChanges& operator=(const WorldChanges&) = delete;

  // The queue
  // ------------------------------------------------------------------------------------------------------

  // A change requested by a menu, key or panel. Executed between two frames, in order.
  struct Request {
    std::string name;           // replaces a queued request of the same name that has not begun
    std::function<bool()> run;  // returns false if it goes on in the next frame without a pending change
    bool is_one = false;        // undone as one step, under this name
    bool always = false;        // kept while a file is being opened; others are dropped
    bool has_begun = false;     // set when `run` returns false
  };
  void enqueue(Request change);
  // Enqueues a change that takes one call.
  void enqueue(std::string name, const std::function<void()>& run);
  // Enqueues a command, which replaces no other request.
  void enqueue(const Command& command);
  bool has_requests() const { return !requests_.empty(); }
  // Called once per frame: executes requests until a change becomes pending.
  void process_requests();

  bool is_pending() const { return pending_.has_value(); }
  std::optional<LongChange> take_pending() { return std::exchange(pending_, std::nullopt); }
  // Called when the pending change is complete.
  void end_pending();
  // Starts background work that leaves the document unchanged. Precondition: none is pending.
  void begin(LongChange reading);

  // Groups of steps that undo and redo take as one.
  StepGroups& groups() { return groups_; }
  // Drops requests for the last document; called when another is open, or about to be.
  void forget();

  // Changes
  // ------------------------------------------------------------------------------------------------------

  void apply(const Command& command);
  // Goes to a position of the history, then shows `message`; meanwhile shows `title`. Strokes that need a
  // recut are cut during the next frames.
  void travel_to(size_t position, const std::string& title, const std::string& message = "");
  // Undoes or redoes a step or a group of steps, and reports it. Ends a stroke in progress.
  void step_through_history(bool back);
  // Changes the document by `what`, which must accept a null progress. A change that is not `quick` becomes
  // pending under the title. Shows `message` once it is done and the strokes that it queued are cut (see
  // report_done).
  using Change = std::function<Outcome(Document&, const Progress*)>;
  void change(const std::string& title, bool quick, const Change& what, const std::string& message = "");

  // Executes a part of the queue by Document::step or SingleStep. Returns false if that failed, or became
  // pending because it makes bodies of many faces.
  using Part = std::function<Result<StepResult>(Document&)>;
  bool step(const Part& part);
  // Executes queued moves until ScreenContext::cut_until, unless they wait for the user.
  void cut();
  // Returns true if moves are queued that cut() may execute.
  bool can_cut() const;

  // Called once per frame: shows the message of a completed change.
  void report_done();

  // Makes a renderer show a world derived from the open document, with the smooth normals as loaded.
  void show_world(const World& world, Renderer& renderer) const;

  // Called after every change of the world.
  std::function<void(const Delta&)> followed = [](const Delta&) {};

 private:
  // A change whose steps of the history undo and redo take as one.
  struct OpenGroup {
    size_t from = 0;  // position of the history
    std::string name;
  };

  Renderer& renderer() const;
  void end_group();
  bool run_in_background(const Part& part);
  void follow_step(const StepResult& step, PreparedBodies prepared = {});
  void follow_released(const Delta& delta);
  void show_failed_step(const Error& error);
  void report_left_open(const Delta& delta);
  void show_outcome(const Outcome& outcome, PreparedBodies prepared = {}, const std::string& message = "");
  void show_change(const Delta& delta, PreparedBodies prepared);

  Workspace& workspace_;
  std::deque<Request> requests_;
  std::optional<OpenGroup> group_;
  StepGroups groups_;
  std::optional<LongChange> pending_;
  std::string pending_message_;  // message to show once nothing is left to cut
};

// Returns a change that applies commands one after the other, for WorldChanges::change.
WorldChanges::Change apply_all(std::vector<Command> commands);

// Returns a change that draws the strokes and knife cuts of a path or a drawing as a whole (see
// Document::run_whole). Fails, and leaves no entry in the history, if it is stopped or if they meet no body.
// `what`: their name in messages, such as "Path".
WorldChanges::Change cut_along(std::vector<Command> commands, std::string what);

// Returns a change that applies a command to pieces in order, as each may move pieces to other bodies.
WorldChanges::Change edit_all(std::vector<PieceId> pieces,
                              std::function<Command(const PieceId&)> command_for);

}  // namespace kerf
