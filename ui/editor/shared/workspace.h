#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/base/platform.h"
#include "ui/editor/shared/document_session.h"
#include "ui/editor/shared/file_browser.h"
#include "ui/editor/shared/laser_controls.h"
#include "ui/editor/shared/laser_tool.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/statistics.h"
#include "ui/editor/shared/thumbnails.h"
#include "ui/editor/shared/user_input.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shared/world_changes.h"
#include "ui/screen/live_picture.h"
#include "ui/window/layout.h"
#include "ui/window/status_message.h"
#include "ui/window/window.h"

namespace kerf {

// The ids of the tools.
inline constexpr const char *kLaserTool = "laser", *kPickTool = "pick", *kInspectTool = "inspect",
                            *kRulerTool = "ruler", *kPathTool = "path";

// State shared by all features: the open document and its view, the use of the mouse, and the queue of
// requested changes. State of a single feature is a member of that feature.
struct Workspace {
  Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  OpenWork work;
  Opening opening;
  ViewState view;
  Settings settings;
  PanelPlaces panels{settings};
  Thumbnails thumbnails{state_folder() / "thumbnails"};
  Message message;
  Statistics statistics;
  FileBrowser browser;

  LaserControls laser;    // settings of the next stroke
  LaserTool beam;         // the stroke being drawn
  bool cut_once = false;  // hints are no longer needed
  Badges badges;          // of modes, in the viewport

  std::string tool = kLaserTool;      // of the left button, by its id
  Vec2 pointer{0};                    // screen coordinates
  bool over_picture = false;          // pointer over the viewport, and no panel or menu uses it
  std::unique_ptr<Interaction> held;  // the current use of the mouse; null: no button is held

  WorldChanges changes{*this};
  LivePicture* picture = nullptr;  // null in tests without a window, as are the next two
  const Window* window = nullptr;
  const WindowClock* clock = nullptr;
  double background_wait = 0;            // s, that a frame waits for work in the background
  std::optional<World> so_far;           // partial replay, shown on the empty stage
  const World* second = nullptr;         // in the right half of a split view; null: not split
  double cut_until = 0;                  // s of the clock, end of cutting in this frame
  double cut_seconds = 0;                // spent cutting in this frame
  const Landmarks* landmarks = nullptr;  // of the parts of the window drawn in this frame
  bool plays = false;                    // the simulation is running
  bool cools = false;                    // hot material cools as time passes
  bool cools_unseen = false;             // and the queued cooling changes nothing visible

  // Links between independent features: reasons why time cannot pass, a sentence each or null, and whether
  // the next step of the document waits for the user.
  std::vector<std::function<const char*()>> time_holds;
  std::function<bool()> holds_back = [] { return false; };

  // Features that open files of their own take them out of the files to be opened.
  std::vector<std::function<bool(const std::filesystem::path&)>> file_takers;
  // Opens files in place of the open work, as bodies of one scene. Set by the feature that opens files.
  std::function<void(std::vector<std::filesystem::path>)> open;
  // Returns the files that no feature takes.
  std::vector<std::filesystem::path> not_taken(std::vector<std::filesystem::path> files) const;
  // Called after another document was opened.
  std::function<void()> replaced = [] {};
  // Ends the editor, once the user has decided about unsaved work. Set by the same feature.
  std::function<void()> quit;
  enum class Leaves { kNot, kForGood, kForTheGame };
  Leaves leaves = Leaves::kNot;
  std::string title;            // of the window
  bool messages_shown = false;  // the message log is open

  static constexpr double kLongestStep = 0.05;  // s, maximum time step of animations

  const World& world() const { return work.document.world(); }
  // The world in the viewport: the open document, or a partial replay while none is open.
  const World& shown_world() const { return so_far ? *so_far : world(); }
  // Returns true if no button is held and the pointer is over the viewport.
  bool points() const { return over_picture && !held; }
  // The place of the pointer if it is over the viewport, else one far from all handles.
  Vec2 pointer_over_picture() const { return over_picture ? pointer : Vec2(-1); }
  // Returns true if the last stroke waits for the user before its first stage.
  bool stroke_waits() const {
    return holds_back() && !view.look.stage && work.document.history().last().waiting();
  }
  // Returns true if a stroke is drawn by hand, or still being cut.
  bool cutting() const { return (held && held->cuts()) || work.document.queue().pending().holds_beam(); }
  // Returns the reason why time cannot pass, or null.
  const char* why_time_stands_still() const;
};

// Ends the stroke being drawn, if any; its cut stays. Returns true if there was one.
bool cancel_stroke(Workspace& workspace);

// Ends the exploded view, because pieces are cut and moved at their true places.
void stand_together(Workspace& workspace);

// Returns the action that activates a tool, "tool.ID", and unfolds the panel of the same id if there is one.
// Ends a stroke drawn by hand.
UserAction tool_action(Workspace& workspace, const char* tool, const char* name, const char* shortcut,
                       const char* tip, bool has_panel = false);

// Returns an action that changes the view. Its state and disabled reason can be added.
UserAction picture_action(ViewState& view, const char* id, const char* name, const char* tip,
                          std::function<void()> change);
// Returns the action that flips a flag of the view.
UserAction flag_action(ViewState& view, const char* id, const char* name, bool& flag, const char* tip);

}  // namespace kerf
