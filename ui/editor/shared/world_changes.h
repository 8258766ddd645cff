#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/document/document.h"
#include "ui/render/bodies/prepared_body.h"

namespace kerf {

// A change of the document that takes too long for a frame.
struct LongChange {
  std::string title;  // what happens, for the user
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

  // Starts a change. Preconditions: none is running, the document outlives it, and both of its functions are
  // set.
  void start(Document& document, LongChange change);
  bool busy() const { return job_ != nullptr; }

  // The title of the running change. Precondition of this and of what follows: busy().
  const std::string& title() const { return job_->change.title; }
  // Whether the change has reported progress, so that it can be stopped.
  bool can_stop() const { return job_->told && !job_->stopped; }
  double fraction() const { return job_->fraction; }  // 0 to 1

  // Asks the change to stop; it ends at its next report of progress.
  void stop() { job_->stopped = true; }
  // Waits for the end for at most the given time (s). Returns whether it has ended.
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

// Whether the world is so small that changes of its bodies take no longer than a part of a frame.
bool is_small(const Document& document);

// Whether a command takes no longer than that.
bool is_quick(const Document& document, const Command& command);

// What the next step of the document does, in a few words, if it takes so long that it has to run beside the
// frames because it makes bodies or colliders of many faces. Null for any other step. O(pieces).
const char* why_beside(const Document& document);

// Consecutive steps of the history that the user made at once, such as one for each piece that was hidden, so
// that one undo takes all of them back. The document knows nothing of groups: they last as long as the editor
// is open.
class StepGroups {
 public:
  struct Group {
    size_t from = 0, to = 0;  // positions of the history
    std::string name;
    bool is_one_row = false;  // in the list of the history
  };

  // Drops the groups that contain steps that are no longer in the history. To be called at least once in a
  // frame. Costs time in proportion to the new commands. Precondition: it is always the same document.
  void follow(const Document& document);
  // Makes the steps from a position up to that of the document a group, if there is more than one.
  void add(size_t from, const Document& document, std::string name, bool is_one_row = false);
  // Whether the list of the history has a row for a position: not within a group that is one row.
  bool has_row(size_t position) const;
  // The group that an undo (`back`) or a redo from the position of the document goes through, or null. Valid
  // until the next call.
  const Group* at(const Document& document, bool back) const;

 private:
  std::vector<Group> groups_;
  size_t position_ = 0, commands_ = 0;  // of the history and of the journal, as seen last
};

class Renderer;
struct Workspace;

// Changes the open document and updates the picture, the pieces and the statistics. Errors are shown in the
// status bar. A change that takes too long for a frame becomes pending; no function that changes the world
// may be called until the pending change was taken and completed.
class WorldChanges {
 public:
  // The workspace must outlive it and the changes that it leaves pending.
  explicit WorldChanges(Workspace& workspace) : workspace_(workspace) {}
  WorldChanges(const WorldChanges&) = delete;
  WorldChanges& operator=(const WorldChanges&) = delete;

  // The queue
  // ------------------------------------------------------------------------------------------------------

  // What menus, keys and panels ask for; it is done between two frames, in the order in which it was asked
  // for.
  struct Asked {
    std::string name;  // one of the same name that waits already is replaced
    std::function<bool()>
        run;              // returns false where it is to be called again when what it left pending is done
    bool is_one = false;  // its steps of the history are undone as one, under this name
    bool always = false;  // also while a file is being opened; what changes the open world is dropped then
  };
  void ask(Asked change);
  // Asks for a change that is done by one call.
  void ask(std::string name, const std::function<void()>& run);
  // Asks for a command. It does not replace others.
  void ask(const Command& command);
  bool is_asked() const { return !asked_.empty(); }
  // To be called once a frame: does what was asked for, until a change becomes pending.
  void process_requests();

  bool is_pending() const { return pending_.has_value(); }
  std::optional<LongChange> take_pending() { return std::exchange(pending_, std::nullopt); }
  // To be called when the pending change is complete.
  void end_pending();
  // Begins a change on a thread of its own that leaves the document as it is. Precondition: none is pending.
  void begin(LongChange reading);

  // Steps of the history that undo and redo take as one.
  StepGroups& groups() { return groups_; }
  // Reports that another document is open, or about to be: what waits for the last one is dropped.
  void forget();

  // Changes
  // ------------------------------------------------------------------------------------------------------

  // Applies a command.
  void apply(const Command& command);
  // Goes to a position of the history, and says `said` then. Strokes that have to be cut again are cut during
  // the next frames.
  void travel_to(size_t position, const std::string& said = "");
  // Undoes or redoes one step of the history, or a group of steps, and says which. Ends a stroke in progress.
  void step_through_history(bool back);
  // Changes the document by `what`, which may report no progress if it is called with null. A change that is
  // not `quick` becomes pending, and is called by the title. Says `said` once it is done, and all strokes
  // that it queued are cut (see tell_done).
  using Change = std::function<Outcome(Document&, const Progress*)>;
  void change(const std::string& title, bool quick, const Change& what, const std::string& said = "");

  // Executes a part of the queue by Document::step or SingleStep. Returns false if that failed, or became
  // pending because it makes bodies of many faces.
  using Part = std::function<Result<StepResult>(Document&)>;
  bool step(const Part& part);
  // Executes queued moves until Workspace::cut_until, unless they wait for the user.
  void cut();
  // Whether moves are queued that it may cut.
  bool can_cut() const;

  // To be called once a frame: says what is done by now.
  void tell_done();

  // Makes a renderer show a world derived from the open document. Smooth normals are those of the faces as
  // loaded, however they were cut since.
  void show_world(const World& world, Renderer& renderer) const;

  // Called after every change of the world.
  std::function<void(const Delta&)> followed = [](const Delta&) {};

 private:
  // A change of several steps of the history that undo and redo take as one.
  struct OpenGroup {
    size_t from = 0;  // position of the history
    std::string name;
  };

  Renderer& renderer() const;
  void end_group();
  bool do_beside(const Part& part);
  void follow_step(const StepResult& step, PreparedBodies prepared = {});
  void follow_released(const Delta& delta);
  void show_failed_step(const Error& error);
  void tell_left_open(const Delta& delta);
  void show_outcome(const Outcome& outcome, PreparedBodies prepared = {}, const std::string& said = "");
  void show_change(const Delta& delta, PreparedBodies prepared);

  Workspace& workspace_;
  std::deque<Asked> asked_;
  std::optional<OpenGroup> group_;
  StepGroups groups_;
  std::optional<LongChange> pending_;
  std::string said_later_;  // once nothing is left to be cut
};

// Applies commands one after the other, for WorldChanges::change.
WorldChanges::Change apply_all(std::vector<Command> commands);

// Applies a command to pieces one after the other, because a piece may be part of another body after a
// command.
WorldChanges::Change edit_all(std::vector<PieceId> pieces,
                              std::function<Command(const PieceId&)> command_for);

}  // namespace kerf
