#pragma once

#include <optional>
#include <span>

#include "ui/editor/changes/long_change.h"
#include "ui/editor/figures/figures.h"
#include "ui/editor/tools/hand.h"
#include "ui/editor/view/view_state.h"
#include "ui/editor/work/open_work.h"
#include "ui/render/renderer.h"
#include "ui/window/message.h"

namespace kerf {

// Why the last stroke of a document cannot be cut again, in one sentence; null where it can.
const char* why_no_recut(const Document& document);

// Changes the open document and lets the picture, the pieces and the figures follow. What went wrong is said
// in the status bar. A change that takes longer than a frame may wait becomes pending(); no function that
// changes the world may be called before that is taken and done.
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

  // Does a command.
  void apply(const Command& command);
  // Goes to a position of the history; strokes that have to be cut again are cut over the next frames.
  void travel_to(size_t position);
  // Goes one step of the history back, or forth; a stroke that is being drawn ends.
  void step_through_history(bool back);
  // Hides the chosen pieces or takes them out of the world, by a command each. Returns whether some are left
  // because one takes long.
  bool hide_chosen();
  bool delete_chosen();
  void show_hidden();
  // Takes the last stroke back and queues it again at the resolution that the laser is set to; its radius and
  // the rest stay. It is cut over the next frames as any stroke is. Cutting again what was just cut again is
  // one step of the history. Nothing happens where why_no_recut() says why.
  void recut_last_stroke();

  // Cuts up to so many moves that wait, as one step. Returns false where the step failed or has become
  // pending, because it closes the rim of a stroke among many faces.
  bool step(size_t moves);

  // Lets a renderer look anew at a world that comes from the open document. Smooth normals come from the
  // faces as they were loaded, whatever strokes have done to them.
  void show_world(const World& world, Renderer& renderer) const;

 private:
  using Change = std::function<Result<Delta>(Document&, const Progress*)>;

  void change(const std::string& title, bool quick, const Change& what);
  template <typename Make>
  bool change_chosen(Make command_for);
  bool close_rim_beside();
  void follow_step(const StepResult& step, size_t faces_before);
  void show_failed_step(const Error& error);
  void show_result(const Result<Delta>& delta, PreparedBodies prepared = {});
  void show_change(const Delta& delta, PreparedBodies prepared);

  Parts on_;
  std::optional<LongChange> pending_;
};

}  // namespace kerf
