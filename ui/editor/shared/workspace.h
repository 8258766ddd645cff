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

// What every feature of the editor works on: the open document and how it is looked at, what the user holds,
// and where changes are asked for. What only one feature knows is a member of that feature.
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

  LaserControls laser;    // with which the next stroke begins
  LaserTool beam;         // the stroke that is drawn
  bool cut_once = false;  // hints are no longer needed
  Badges badges;          // of modes, in the viewport

  std::string tool = "Laser";         // what the left button does, by the name of the action that takes it
  Vec2 pointer{0};                    // screen coordinates
  bool over_picture = false;          // the pointer is, and no panel or menu wants it
  std::unique_ptr<Interaction> held;  // what the mouse does; null: no button is held

  WorldChanges changes{*this};
  LivePicture* picture = nullptr;  // null in tests without a window, as are the next two
  const Window* window = nullptr;
  const WindowClock* clock = nullptr;
  double background_wait = 0;            // s, that a frame waits for work in the background
  std::optional<World> so_far;           // shown on the empty stage while its file is cut again
  const World* second = nullptr;         // in the right half of a split picture; null: it is not split
  double cut_until = 0;                  // s of the clock, until when a frame may cut
  double cut_seconds = 0;                // that this frame has cut for
  const Landmarks* landmarks = nullptr;  // the parts of the window that this frame has drawn
  bool plays = false;                    // time passes for the bodies
  bool cools = false;                    // something hot cools down as time passes
  bool cools_unseen = false;             // and what waits in the queue of that changes nothing in the picture

  // What features say about each other's work without knowing each other: why time cannot pass, a sentence
  // each or null, and whether the next step of the document waits for the user.
  std::vector<std::function<const char*()>> time_holds;
  std::function<bool()> holds_back = [] { return false; };

  // Features that open files of their own take these from the files that are to be opened.
  std::vector<std::function<bool(const std::filesystem::path&)>> file_takers;
  // Opens files in place of what is open, as bodies of one scene. Set by the feature that opens files.
  std::function<void(std::vector<std::filesystem::path>)> open;
  // The files that no feature takes for its own.
  std::vector<std::filesystem::path> not_taken(std::vector<std::filesystem::path> files) const;
  // Called when another document was opened.
  std::function<void()> replaced = [] {};
  // Ends the editor, once the user has decided what becomes of unsaved work. Set by the same feature.
  std::function<void()> quit;
  enum class Leaves { kNot, kForGood, kForTheGame };
  Leaves leaves = Leaves::kNot;
  std::string title;            // of the window
  bool messages_shown = false;  // the log of them

  static constexpr double kLongestStep = 0.05;  // s, of what moves on the screen, in a frame

  const World& world() const { return work.document.world(); }
  // What the picture shows: the open document, or what is cut again while none is open.
  const World& shown_world() const { return so_far ? *so_far : world(); }
  // Whether no button is held and the pointer is over the picture.
  bool points() const { return over_picture && !held; }
  // The place of the pointer if it is over the picture, else one that no handle is near.
  Vec2 pointer_over_picture() const { return over_picture ? pointer : Vec2(-1); }
  // Whether the last stroke waits for the user before its first stage.
  bool stroke_waits() const {
    return holds_back() && !view.look.stage && work.document.history().last().waiting();
  }
  // Whether a stroke is drawn by hand, or still being cut.
  bool cutting() const { return (held && held->cuts()) || work.document.execution().beam_waits(); }
  // The sentence why time cannot pass at the moment, or null.
  const char* why_time_stands_still() const;
};

// Ends the stroke that is drawn, if one is; what was cut stays cut. Returns whether there was one.
bool cancel_stroke(Workspace& workspace);

// Draws pieces that are drawn apart where they stand, as they are cut and moved there.
void stand_together(Workspace& workspace);

// The action that takes a tool, and unfolds its panel where it has one of the same name. A stroke by hand
// ends.
UserAction tool_action(Workspace& workspace, const char* name, const char* shortcut, const char* tip,
                       bool has_panel = false);

// An action that changes what the picture shows, and is not in a menu. Whether it is a switch, and why it is
// impossible at the moment, can be added.
UserAction picture_action(ViewState& view, const char* name, const char* tip, std::function<void()> change);
// The action that flips a flag of the picture.
UserAction flag_action(ViewState& view, const char* name, bool& flag, const char* tip);

}  // namespace kerf
