#pragma once

#include <memory>

#include "core/base/result.h"
#include "ui/gl/offscreen_context.h"
#include "ui/window/event_script.h"
#include "ui/window/window.h"

namespace kerf {

// A window without a screen: a script is its user (see event_script.h), and a drawing surface in memory its
// picture.
class ScriptedWindow final : public Window {
 public:
  // Fails if the file cannot be read, or OpenGL 3.3 cannot be had without a screen.
  static Result<std::unique_ptr<Window>> open(const std::filesystem::path& events, int width, int height);

  Vec2 size() const override { return script_.input().size(); }
  Vec2 pixel_size() const override { return size(); }
  float scale() const override { return 1; }
  void set_title(const std::string& title) override { script_.set_title(title); }
  void swap() override {}
  void wait(double) override {}
  std::vector<InputEvent> take_events() override;
  std::vector<std::filesystem::path> take_drops() override;
  bool take_close() override;
  bool take_activity() override { return true; }
  bool is_key_held(int key) const override { return script_.input().keys().contains(key); }
  bool is_button_held(int button) const override { return script_.input().buttons().contains(button); }
  bool has_focus() const override { return script_.input().has_focus(); }
  void catch_pointer(bool) override {}
  const WindowClock& clock() const override { return clock_; }
  EventScript* script() override { return &script_; }
  bool draws() const override { return script_.draws(); }
  void attach_gui() override;
  void detach_gui() override {}
  void begin_gui_frame() override;

 private:
  // Work that is limited by time ends after so many readings of the clock, at every run after the same ones.
  class Clock final : public WindowClock {
   public:
    explicit Clock(const EventScript& script) : script_(script) {}
    double seconds() const override;

   private:
    const EventScript& script_;
    mutable double frame_ = 0;     // s, the beginning of the frame of the last reading
    mutable double readings_ = 0;  // in this frame
    mutable double latest_ = 0;    // s, what was read last
  };

  ScriptedWindow(EventScript script, gl::OffscreenContext context);

  EventScript script_;
  gl::OffscreenContext context_;
  Clock clock_;
  Vec2 surface_{0};  // the size of the drawing surface
};

}  // namespace kerf
