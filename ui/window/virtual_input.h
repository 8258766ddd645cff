#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/document/text/json_value.h"
#include "ui/window/input_event.h"

namespace kerf {

// The mouse, the keyboard and the frame of a window that a script drives.
class VirtualInput {
 public:
  // What came since it was taken last.
  struct Heard {
    std::vector<InputEvent> events;
    std::vector<std::filesystem::path> drops;
    bool close = false;
  };

  explicit VirtualInput(Vec2 size) : size_(size) {}

  // Hears a step of the script, an object with one key (see event_script.h). Fails, and changes nothing, if
  // there is no such step or its value is wrong.
  Status hear(const std::string& name, const JsonValue& value);

  Heard& heard() { return heard_; }
  Vec2 size() const { return size_; }
  Vec2 pointer() const { return pointer_; }
  const std::set<int>& keys() const { return keys_; }        // that are held down, GLFW_KEY_*
  const std::set<int>& buttons() const { return buttons_; }  // GLFW_MOUSE_BUTTON_*
  int mods() const;                                          // GLFW_MOD_*
  bool has_focus() const { return focus_; }

 private:
  Status move(const JsonValue& value);
  Status hold_button(const JsonValue& value, bool down);
  Status hold_key(const JsonValue& value, bool down);
  Status turn_wheel(const JsonValue& value);
  Status type(const JsonValue& value);
  Status drop(const JsonValue& value);
  Status resize(const JsonValue& value);
  Status focus(const JsonValue& value);
  Status close(const JsonValue& value);
  InputEvent& put(InputEvent::Kind kind, int button = 0);

  Heard heard_;
  Vec2 size_, pointer_{0};
  std::set<int> keys_, buttons_;
  bool focus_ = true;
};

}  // namespace kerf
