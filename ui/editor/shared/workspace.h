#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/base/platform.h"
#include "ui/editor/shared/document_session.h"
#include "ui/editor/shared/file_browser.h"
#include "ui/editor/shared/laser_controls.h"
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
                            *kRulerTool = "ruler", *kPathTool = "path", *kKnifeTool = "knife",
                            *kDrawingTool = "drawing";

// State of the mouse input.
struct PointerInput {
  std::string tool = kLaserTool;      // of the left button, by its id
  Vec2 pointer{0};                    // screen coordinates
  bool viewport_hovered = false;      // pointer over the viewport, and no panel or menu uses it
  std::unique_ptr<Interaction> held;  // the current interaction; null: no button is held
  int held_button = 0;                // that began it
  bool asks_for_menu = false;         // the context menu opens in the next frame

  bool picks() const { return tool == kPickTool; }
  // Returns true if no button is held and the pointer is over the viewport.
  bool points() const { return viewport_hovered && !held; }
  // Returns the place of the pointer if it is over the viewport, else one far from all handles.
  Vec2 pointer_in_viewport() const { return viewport_hovered ? pointer : Vec2(-1); }
};

struct Services {
  explicit Services(Settings& settings) : panels(settings) {}

  PanelPlaces panels;
  Thumbnails thumbnails{state_folder() / "thumbnails"};
  bool messages_shown = false;  // the message log is open
  Badges badges;                // of modes, in the viewport
  Statistics statistics;
  FileBrowser browser;
};

// The window, and the time of the current frame. The pointers are null in tests without a window.
struct ScreenContext {
  LivePicture* picture = nullptr;
  const Window* window = nullptr;
  const WindowClock* clock = nullptr;
  const Landmarks* landmarks = nullptr;  // of the parts of the window drawn in this frame
  std::string title;                     // of the window
  double background_wait = 0;            // s, maximum time that a frame waits for background work
  double cut_until = 0;                  // s of the clock, deadline for cutting in this frame
  double cut_seconds = 0;                // spent cutting in this frame
};

enum class Leaves { kNot, kForGood, kForTheGame };

// Links between independent features.
struct FeatureLinks {
  bool cut_once = false;       // the user has cut, so hints are no longer needed
  bool plays = false;          // the simulation is running
  bool cools = false;          // hot material cools as time passes
  bool cools_unseen = false;   // hot material cools, but the queued cooling changes nothing visible
  bool stops_emitter = false;  // requests that the emitter is switched off
  // Functions that return the reason why time cannot pass, as a sentence, or null.
  std::vector<std::function<const char*()>> time_holds;
  // Returns true if the next step of the document waits for the user.
  std::function<bool()> holds_back = [] { return false; };
  // Handlers of features for files of their own type.
  struct FileTaker {
    std::function<bool(const std::filesystem::path&)> accepts;
    std::function<void(const std::filesystem::path&)> take;
  };
  std::vector<FileTaker> file_takers;
  // Opens files in place of the open document, as bodies of one scene. Set by files_feature().
  std::function<void(std::vector<std::filesystem::path>)> open;
  // Called after another document was opened.
  std::function<void()> replaced = [] {};
  // Ends the editor, after the user has decided about unsaved changes. Set by files_feature().
  std::function<void()> quit;
  Leaves leaves = Leaves::kNot;

  // Removes the files that a feature accepts, and returns them.
  std::vector<std::filesystem::path> extract_accepted(std::vector<std::filesystem::path>& files) const;
  // Passes each file to the feature that accepts it, if any.
  void take(const std::vector<std::filesystem::path>& files) const;
};

// Returns true while a stroke is drawn by hand or is still being cut.
inline bool is_cutting(const PointerInput& input, const Document& document) {
  return (input.held && input.held->cuts()) || document.queue().pending().holds_beam();
}

// State shared by all features, grouped by purpose. A feature uses the parts that it needs. State of a single
// feature is a member of that feature.
struct Workspace {
  Workspace() = default;
  Workspace(const Workspace&) = delete;

  DocumentSession session;
  Opening opening;
  ViewState view;
  PointerInput input;
  LaserControls laser;  // settings of the next stroke
  LaserTool beam;       // the stroke being drawn
  Settings settings;
  Message message;
  Services services{settings};
  ScreenContext screen;
  FeatureLinks links;
  WorldChanges changes{*this};

  static constexpr double kLongestStep = 0.05;  // s, maximum time step of animations

  const World& world() const { return session.world(); }
  // The world in the viewport: the open document, or a partial replay while none is open.
  const World& shown_world() const { return opening.partial_world ? *opening.partial_world : world(); }
  // Returns true if the last stroke waits for the user before its first stage.
  bool stroke_waits() const {
    return links.holds_back() && !view.look.stage && session.document.history().last().waiting();
  }
  bool cutting() const { return is_cutting(input, session.document); }
  // Returns the reason why time cannot pass, or null.
  const char* time_disabled_reason() const;
};

// Ends the stroke being drawn, if any; its cut is kept. Returns true if there was one.
bool cancel_stroke(Workspace& workspace);

inline constexpr auto kExplodedViewEnded =
    "The exploded view has ended: points are measured at their true positions.";

// Ends the exploded view, because pieces are cut, moved and measured at their true positions. Returns true if
// there was one.
bool end_exploded_view(const World& world, ViewState& view);

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
