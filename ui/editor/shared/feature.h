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

// A panel below the header that bears its title. The title is also the key under which the settings keep
// whether it is unfolded, and where it is. Panels of the same title are drawn under one header, and the first
// of them says where.
struct Panel {
  const char* title;
  Tab tab;        // of the column at the right
  int place;      // among the panels, from top to bottom
  bool unfolded;  // at first
  std::function<void()> draw;
  Dock dock = Dock::kColumn;  // at first
};

// Actions that follow each other in a menu, and the place of the group among all of them.
struct ActionGroup {
  int place;
  const char* menu;  // of the actions that name no other
  std::vector<UserAction> actions;
};

// A part of the editor that people can name: what it shows in panels and over the picture, what menus, keys
// and the mouse do with it. Features do not know each other; what they share is in Workspace. The frame loop
// calls each of these functions for all features, in the order of features.cpp.
class Feature {
 public:
  virtual ~Feature() = default;

  // Called once, at the start. What they return may refer to the feature.
  virtual std::vector<Panel> panels() { return {}; }
  virtual std::vector<ActionGroup> actions() { return {}; }
  virtual std::vector<Gesture> gestures() const { return {}; }

  // Input. The first feature that returns true keeps an event from all that comes after it: keys from the
  // actions, the mouse from interactions. `in_picture`: the pointer is over the picture and no panel.
  virtual bool handle_event(const InputEvent&, bool /*in_picture*/) { return false; }
  // What a press begins; null: not the business of this feature.
  virtual std::unique_ptr<Interaction> begin_interaction(const Press&) { return nullptr; }
  // Esc. All features end what is at work; if none did anything, the first that returns true has undone a
  // choice.
  virtual bool cancel() { return false; }
  virtual bool clear_selection() { return false; }
  // Whether it has opened something with a text field that has to have the keyboard: until it has, what is
  // typed waits.
  virtual bool awaits_focus() const { return false; }
  // What the left button does at the moment, for the status bar; null: nothing to tell of.
  virtual const char* status_hint() const { return nullptr; }

  // The editor begins, waits for input, and ends.
  virtual Status on_start(const EditorOptions&) { return Done{}; }
  virtual void on_idle() {}
  virtual void on_exit(bool /*left_by_user*/) {}

  // Once a frame, after the changes that were asked for: lets time pass (s).
  virtual void update(double /*seconds*/) {}
  // Once a frame, after the queue of the document was worked on.
  virtual void after_queue(double /*seconds*/) {}
  // Whether the next frame has to come without input.
  virtual bool needs_redraw() const { return false; }

  // The open world has changed by this.
  virtual void on_world_changed(const Delta&) {}
  // Another document is open: what belonged to the last one ends.
  virtual void on_document_opened() {}

  // Draws over the picture.
  virtual void draw_overlay(ImDrawList&) {}
  // Windows of its own, and what belongs over the panels.
  virtual void draw_windows() {}
  // The picture without the panels, or all of the window, is drawn and not displayed yet.
  enum class Captured { kPicture, kWindow };
  virtual void on_captured(Captured) {}
  // Names the places of handles, for tests.
  virtual void add_landmarks(Landmarks&) const {}
  // Adds to the report of the session.
  virtual void write_session_log(nlohmann::ordered_json&) const {}
};

}  // namespace kerf
