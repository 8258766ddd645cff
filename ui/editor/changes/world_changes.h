#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "ui/editor/changes/long_change.h"
#include "ui/editor/figures/figures.h"
#include "ui/editor/tools/hand.h"
#include "ui/editor/view/view_state.h"
#include "ui/editor/work/open_work.h"
#include "ui/editor/work/preparation.h"
#include "ui/render/renderer.h"
#include "ui/window/message.h"

namespace kerf {

// The reason why the last stroke of a document cannot be cut again, in one sentence, or null if it can.
const char* why_no_recut(const Document& document);
// The same for isolating the selected pieces, and for showing the others again.
const char* why_no_isolation(const World& world, const ViewState& view);

// Changes the open document and updates the picture, the pieces and the figures. Errors are shown in the
// status bar. A change that takes too long for a frame becomes pending; no function that changes the world
// may be called until the pending change was taken and completed.
class WorldChanges {
 public:
  struct Parts {
    OpenWork& work;
    ViewState& view;
    Hand& hand;
    Figures& figures;
    Message& message;
    Renderer& renderer;  // of the open document
  };
  // The parts must outlive it and the changes that it leaves pending.
  explicit WorldChanges(const Parts& parts) : on_(parts) {}
  WorldChanges(const WorldChanges&) = delete;
  WorldChanges& operator=(const WorldChanges&) = delete;

  bool is_pending() const { return pending_.has_value(); }
  std::optional<LongChange> take_pending() { return std::exchange(pending_, std::nullopt); }

  // Applies a command.
  void apply(const Command& command);
  // Goes to a position of the history, and says `said` then. Strokes that have to be cut again are cut during
  // the next frames.
  void travel_to(size_t position, const std::string& said = "");
  // Undoes or redoes one step of the history, and says which. Ends a stroke in progress.
  void step_through_history(bool back);
  // Hides or deletes the selected pieces, with one command each. Returns whether some are left because one
  // became pending.
  bool hide_chosen();
  bool delete_chosen();
  // Pins the selected pieces where they are, or lets them move again; they stay selected.
  void pin_chosen(bool pinned);
  // Gives the selected pieces this sheet, or all pieces if none is selected.
  void set_sheet(const Sheet& sheet);
  // Simplifies, subdivides or smooths the selected pieces, or all pieces if none is selected: all of them, or
  // none if one fails or the user stops it. Precondition: why_no_preparation() gives no reason.
  void prepare_chosen(const Preparation& preparation);
  // Adds a copy of the selected piece where it stands. Precondition: a piece is selected.
  void duplicate_chosen();
  void show_hidden();
  // Hides all pieces but the selected ones; the next call shows again those that were hidden by it, and no
  // others.
  void isolate_chosen();
  // Undoes the last stroke and queues it again at the current resolution, and with `radius` with the current
  // radius; its other settings stay. It is cut
  // during the next frames. Consecutive recuts are one step of the history. Does nothing if why_no_recut()
  // gives a reason.
  void recut_last_stroke(bool radius);

  // Ends the stroke that is being cut where it is, and takes back those that wait behind it.
  void stop_cutting();

  // Executes commands of strokes on a thread of its own: all of them, or none if the user stops it.
  void run_path(std::vector<Command> commands);

  // Executes a part of the queue by Document::step or SingleStep. Returns false if that failed, or became
  // pending because it makes bodies of many faces.
  using Part = std::function<Result<StepResult>(Document&)>;
  bool step(const Part& part);

  // Changes the document by `what`, which may report no progress if it is called with null. A change that is
  // not `quick` becomes pending, and is called by the title. Says `said` once it is done, and all strokes
  // that it queued are cut (see tell_done).
  using Change = std::function<Outcome(Document&, const Progress*)>;
  void change(const std::string& title, bool quick, const Change& what, const std::string& said = "");

  // To be called once a frame: says what is done by now.
  void tell_done();

  // Makes a renderer show a world derived from the open document. Smooth normals are those of the faces as
  // loaded, however they were cut since.
  void show_world(const World& world, Renderer& renderer) const;

 private:
  template <typename Make>
  bool change_chosen(Make command_for);
  bool do_beside(const Part& part);
  void follow_step(const StepResult& step, PreparedBodies prepared = {});
  void follow_released(const Delta& delta);
  void show_failed_step(const Error& error);
  void show_outcome(const Outcome& outcome, PreparedBodies prepared = {}, const std::string& said = "");
  void show_change(const Delta& delta, PreparedBodies prepared);

  Parts on_;
  std::optional<LongChange> pending_;
  std::string said_later_;                            // once nothing is left to be cut
  std::optional<std::vector<BodyId>> hidden_before_;  // an isolation that is going on
};

}  // namespace kerf
