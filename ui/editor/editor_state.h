#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/document/autosave.h"
#include "core/document/document.h"
#include "core/document/scene.h"
#include "ui/editor/changes/long_work.h"
#include "ui/editor/changes/twin_cut.h"
#include "ui/editor/figures/frame_statistics.h"
#include "ui/editor/figures/memory_figures.h"
#include "ui/editor/figures/step_history.h"
#include "ui/editor/frame/file_browser.h"
#include "ui/editor/frame/question.h"
#include "ui/editor/tools/laser_controls.h"
#include "ui/editor/tools/laser_tool.h"
#include "ui/editor/work/file_loader.h"
#include "ui/editor/work/settings.h"
#include "ui/editor/work/work_in_hand.h"
#include "ui/render/camera.h"
#include "ui/render/renderer.h"
#include "ui/window/layout.h"

namespace kerf {

// Numbers of the panels and the status bar; they follow the world four times a second, so that they can be
// read.
struct ShownFigures {
  size_t faces = 0, pieces = 0;
  size_t twin_faces = 0;  // of the right half
  double frame_ms = 0;
  size_t tree_nodes = 0;
  int tree_depth = 0;
  MemoryFigures memory;
  size_t faces_tested = 0, faces_of_step = 0;  // in the last step, and how many there were before it
};

// What the views of shadows found.
struct ShadowFigures {
  size_t differing = 0;  // pixels between two methods
  double traced = 0;     // share of the picture
  size_t wrong = 0;      // pixels that rays have otherwise
};

// What the left button does.
enum class Tool { kLaser, kPick };

// What a drag that has begun goes on doing. One that picks has not moved yet.
enum class Drag { kNone, kCut, kPick, kOrbit, kPan, kLight };

// What only the frame loop can do, asked for by menus, keys and panels; it is done once before the next
// picture.
struct Requests {
  std::vector<std::filesystem::path> open;  // in place of what is open, as bodies of one scene
  bool fresh = false;                       // the default scene in place of what is open
  bool quit = false;
  std::filesystem::path save_to;  // empty: nowhere
  bool recut = false;
  bool undo = false, redo = false;
  bool hide_chosen = false, show_hidden = false, delete_chosen = false;
  std::vector<Command> commands;
  std::optional<size_t> travel;  // to a position of the history

  // Whether the open work goes with it.
  bool leaves_work() const { return !open.empty() || fresh || quit; }
  enum class Screenshot { kNone, kPicture, kWindow };
  Screenshot screenshot = Screenshot::kNone;
};

// The right half of the picture: the last stroke at another resolution.
struct SplitView {
  bool shown = false;
  ResolutionControls resolution{.edge_fraction = 1};
  TwinCut twin;
};

// Everything that the editor's parts share: what is open, how it is looked at, what the user is doing.
struct EditorState {
  Document document;
  std::vector<std::filesystem::path> files;  // that the document came from
  WorkInHand work;
  std::vector<LeftWork> left_work;  // of editors that died, and about which the user was not asked yet
  std::optional<World> as_loaded;   // where a recut may need it, see recut.h
  std::map<std::string, Paint> paints;
  std::optional<View> home;  // the view that the scene asks for

  Camera camera;
  ViewOptions look;
  double spread = 0;  // how far pieces are drawn apart, in distances from the middle of the world
  Layout layout;
  SplitView split;

  LaserControls laser;
  LaserTool tool;
  Tool left_button = Tool::kLaser;
  Drag drag = Drag::kNone;
  size_t dragged_light = 0;
  Vec2 pointer{0}, pressed_at{0};  // screen coordinates
  bool pointer_over_picture = false;
  bool in_second = false;  // the pointer is in the right half, or the drag began there

  std::string message;  // of the last thing that happened, until the next action
  bool message_is_error = false;
  ShownFigures shown;
  ShadowFigures shadow_figures;
  FrameStatistics frames;
  FrameStatistics between_pictures;  // what frames took beside drawing
  // The same of frames in which something was cut.
  FrameStatistics cutting_frames, between_cutting_pictures;
  StepHistory history;
  StepFigures last_step, stroke_figures;
  size_t figures_of = 0;  // which stroke or recut of one stroke_figures are of
  size_t faces_before_step = 0;
  size_t recuts = 0, undos = 0;
  size_t history_shown = 0;  // the position that the list of the history was scrolled to

  Settings settings;
  FileBrowser browser;
  Question question;
  FileLoader loader;
  std::optional<LongChange> long_change;  // begins when this frame is shown
  LongWork long_work;                     // while it is busy the document is not touched
  Requests requests;
  std::optional<Requests> leaving;  // waits until it is known what becomes of the unsaved work

  double wanted_scale = 0;  // of the text, while its slider moves
  bool cut_once = false;    // hints are no longer needed
  bool show_shortcuts = false;
  bool quit = false;
  bool picture_old = true;    // the picture of the world has to be drawn anew
  bool world_changed = true;  // since the figures of the panels were taken

  // The half of the picture that the pointer is in; all of it where it is not split.
  const Area& pane() const { return in_second ? layout.second : layout.first; }
  double aspect() const { return pane().size.x / pane().size.y; }
  CameraView view() const { return camera.view(aspect()); }
  // A place of the window as CameraView::ray takes it, in this half.
  Vec2 in_picture(Vec2 at) const;
  void say(std::string text, bool error = false);
  // Takes a step into the figures of its stroke.
  void note_figures(const StepFigures& step);
};

}  // namespace kerf
