#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/world/world_delta.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/user_input.h"
#include "ui/window/layout.h"

struct ImDrawList;

namespace kerf {

struct EditorOptions;

// Content of a panel, or of a part of one. layout_table.h states the panel.
struct PanelPart {
  const char* id;  // "laser.beam"
  std::function<void()> draw;
};

// A part of the editor with its panels, overlay, actions, keys and mouse input. Features are independent of
// each other; they share parts of the Workspace. The frame loop calls each function for all features, in
// the order of make_features().
class Feature {
 public:
  virtual ~Feature() = default;

  // Called once, at the start, in any order. The results may refer to the feature.
  virtual std::vector<PanelPart> panel_parts() { return {}; }
  virtual std::vector<UserAction> actions() { return {}; }
  virtual std::vector<Gesture> gestures() const { return {}; }

  // Input. The first feature that returns true consumes an event: keys before actions, mouse events before
  // interactions. `in_picture`: the pointer is over the viewport and no panel.
  virtual bool handle_event(const InputEvent&, bool /*in_picture*/) { return false; }
  // Begins the interaction of a press; null: not handled by this feature.
  virtual std::unique_ptr<Interaction> begin_interaction(const Press&) { return nullptr; }
  // Esc. All features cancel work in progress; if none did, the first that clears a selection returns true.
  virtual bool cancel() { return false; }
  virtual bool clear_selection() { return false; }
  // Returns true while a new text field waits for the keyboard focus, which holds back typed keys.
  virtual bool awaits_focus() const { return false; }
  // Action of the left button, for the status bar; null: none.
  virtual const char* status_hint() const { return nullptr; }

  // Called at the start, before waiting for input, and at the end.
  virtual Status on_start(const EditorOptions&) { return Done{}; }
  virtual void on_idle() {}
  virtual void on_exit(bool /*left_by_user*/) {}

  // Once a frame, after the requested changes: advances time [s].
  virtual void update(double /*seconds*/) {}
  // Once a frame, after the queue of the document was processed.
  virtual void after_queue(double /*seconds*/) {}
  // Returns true if the next frame is needed without input.
  virtual bool needs_redraw() const { return false; }

  virtual void on_world_changed(const Delta&) {}
  // Called after another document was opened; resets state of the last one.
  virtual void on_document_opened() {}

  virtual void draw_overlay(ImDrawList&) {}
  // Draws windows, and everything above the panels.
  virtual void draw_windows() {}
  // Called when the viewport without panels, or the whole window, is drawn but not displayed yet.
  enum class Captured { kPicture, kWindow };
  virtual void on_captured(Captured) {}
  virtual void add_landmarks(Landmarks&) const {}
  virtual void write_session_log(nlohmann::ordered_json&) const {}
};

}  // namespace kerf
