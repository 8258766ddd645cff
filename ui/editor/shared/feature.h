#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/base/result.h"
#include "core/world/world_delta.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/user_input.h"
#include "ui/editor/shared/workspace.h"
#include "ui/window/layout.h"

struct ImDrawList;

namespace kerf {

struct EditorOptions;

// The content of a panel, or of a part of one; catalogue.h assigns it to a panel.
struct PanelPart {
  const char* id;  // "laser.beam"
  std::function<void()> draw;
};

// An option of a tool, drawn as one row (see property()) in the header of the viewport.
struct ToolOption {
  const char* id;   // "laser.radius"
  float width_ems;  // of its widget, without the label
  std::function<void()> draw;
  std::function<bool()> is_shown = [] { return true; };
};

// A feature of the editor with its panels, overlay, actions, keys and mouse input. Features are independent
// of each other; they share parts of the Workspace. The frame loop calls each function for all features, in
// the order of make_features().
class Feature {
 public:
  virtual ~Feature() = default;

  // Called once at startup, in any order. The results may refer to the feature.
  virtual std::vector<PanelPart> panel_parts() { return {}; }
  virtual std::vector<ToolOption> tool_options() { return {}; }
  virtual std::vector<UserAction> actions() { return {}; }
  virtual std::vector<Gesture> gestures() const { return {}; }

  // Handles an input event. The first feature that returns true consumes it: keys before actions, mouse
  // events before interactions. `in_picture`: the pointer is over the viewport and not over a panel.
  virtual bool handle_event(const InputEvent&, bool /*in_picture*/) { return false; }
  // Begins the interaction of a press; null if this feature does not handle it.
  virtual std::unique_ptr<Interaction> begin_interaction(const Press&) { return nullptr; }
  // Called on Esc: cancel() for all features, to cancel work in progress; if all return false and no
  // interaction is cancelled, discard_draft() until one returns true, which discards what the user has drawn
  // but not applied; if none does, clear_selection() until one returns true. All return true if they had an
  // effect.
  virtual bool cancel() { return false; }
  virtual bool discard_draft() { return false; }
  virtual bool clear_selection() { return false; }
  // Returns true while a new text field waits for the keyboard focus; typed keys are deferred meanwhile.
  virtual bool awaits_focus() const { return false; }
  // Returns the action of the left button for the status bar; null if there is none.
  virtual const char* status_hint() const { return nullptr; }

  // Called at startup, before the frame loop waits for input, and at exit.
  virtual Status on_start(const EditorOptions&) { return Done{}; }
  virtual void on_idle() {}
  virtual void on_exit(bool /*left_by_user*/) {}

  // Called once per frame, after requests were processed: advances time by `seconds`.
  virtual void update(double /*seconds*/) {}
  // Called once per frame, after the queue of the document was processed.
  virtual void after_queue(double /*seconds*/) {}
  // Returns true if the next frame is needed without input.
  virtual bool needs_redraw() const { return false; }

  virtual void on_world_changed(const Delta&) {}
  // Called after another document was opened; resets the state of the previous one.
  virtual void on_document_opened() {}

  virtual void draw_overlay(ImDrawList&) {}
  // Draws windows and other items above the panels.
  virtual void draw_windows() {}
  // Called when the viewport without panels, or the whole window, has been drawn but is not displayed yet.
  enum class Captured { kPicture, kWindow };
  virtual void on_captured(Captured) {}
  virtual void add_landmarks(Landmarks&) const {}
  virtual void write_session_log(nlohmann::ordered_json&) const {}
};

// Opening, saving and closing the work, recovery of unsaved work, and screenshots.
std::unique_ptr<Feature> files_feature(Workspace& workspace);
// Recent files: a menu of them, and their thumbnails.
std::unique_ptr<Feature> recent_feature(Workspace& workspace);
// The welcome window of the first launch: the car, recent files, scenes, and a guided tour. Any key or press
// outside closes it; the Help menu opens it again.
std::unique_ptr<Feature> welcome_feature(Workspace& workspace);
// The steps of the history: undo, redo, and jumps to any step.
std::unique_ptr<Feature> history_feature(Workspace& workspace);
// The laser at the pointer: its beam and resolution, the stroke being drawn, and the recut of the last
// stroke.
std::unique_ptr<Feature> laser_feature(Workspace& workspace);
// The knife: cuts along a line drawn over the viewport, or at the section plane.
std::unique_ptr<Feature> knife_feature(Workspace& workspace);
// The sheet of the pieces, and how the beam heats it.
std::unique_ptr<Feature> material_feature(Workspace& workspace);
// The split view: the last stroke at a second resolution, in the right half of the viewport.
std::unique_ptr<Feature> split_feature(Workspace& workspace);
// The path of the laser, drawn point by point over the surface and then run.
std::unique_ptr<Feature> path_feature(Workspace& workspace);
// A drawing (SVG or DXF) that is placed over the surface and then cut.
std::unique_ptr<Feature> drawing_feature(Workspace& workspace);
// A laser fixed in the scene that fires while switched on, continuously or in pulses.
std::unique_ptr<Feature> emitter_feature(Workspace& workspace);
// Stepping through the last stroke, forwards and back, and through the nodes of the last tree query.
std::unique_ptr<Feature> single_step_feature(Workspace& workspace);
// The simulation: falling bodies and springs that drag them; hot material cools even while it is paused.
std::unique_ptr<Feature> time_feature(Workspace& workspace);
// The pieces: their list, their selection, hiding, isolating, deleting, renaming, and the exploded view.
std::unique_ptr<Feature> pieces_feature(Workspace& workspace);
// Moves, rotates and duplicates the selected piece: by handles, by keys and by numbers.
std::unique_ptr<Feature> transform_feature(Workspace& workspace);
// Simplifies, subdivides and smooths the meshes of pieces before they are cut.
std::unique_ptr<Feature> prepare_feature(Workspace& workspace);
// The view: the camera, the axes gizmo, the view options with their legends, and the theme of the panels.
std::unique_ptr<Feature> view_feature(Workspace& workspace);
// The lights and their shadows: their panel and, while it is unfolded, handles of the lights.
std::unique_ptr<Feature> light_feature(Workspace& workspace);
// The section plane: its handles in the viewport, its numbers in the View panel, and its actions.
std::unique_ptr<Feature> section_feature(Workspace& workspace);
// Properties of a face, the distance between two points, and the temperature of a point over time.
std::unique_ptr<Feature> inspect_feature(Workspace& workspace);
// The component graph of the last stroke or of a piece, with its traversal.
std::unique_ptr<Feature> graph_feature(Workspace& workspace);
// The AABB trees: the displayed boxes, and the sizes of the trees.
std::unique_ptr<Feature> tree_feature(Workspace& workspace);
// Times and changes of the last steps, and memory usage.
std::unique_ptr<Feature> statistics_feature(Workspace& workspace);
// Colours the faces by a quantity, with its histogram and an adjustable range.
std::unique_ptr<Feature> scalar_map_feature(Workspace& workspace);
// Persistent measurements between two points of surfaces, which can be named, moved, listed and exported as
// CSV. They are saved in the head of the document.
std::unique_ptr<Feature> ruler_feature(Workspace& workspace);

}  // namespace kerf
