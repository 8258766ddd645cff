#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "ui/window/window.h"

struct GLFWwindow;

namespace kerf {

class DesktopWindow final : public Window {
 public:
  // Opens a window of a size in screen coordinates. Fails if there is no display or no OpenGL 3.3.
  static Result<std::unique_ptr<Window>> open(int width, int height, const std::string& title);
  ~DesktopWindow() override;

  Vec2 size() const override;
  Vec2 pixel_size() const override;
  float scale() const override;
  void set_title(const std::string& title) override;
  void swap() override;
  // GLFW reports no event times: events between two calls get times spread evenly over that interval.
  void wait(double seconds) override;
  std::vector<InputEvent> take_events() override;
  std::vector<std::filesystem::path> take_drops() override;
  bool take_close() override;
  bool take_activity() override;
  bool is_key_held(int key) const override;
  bool is_button_held(int button) const override;
  bool has_focus() const override;
  void catch_pointer(bool caught) override;
  const WindowClock& clock() const override { return clock_; }
  void attach_gui() override;
  void detach_gui() override;
  void begin_gui_frame() override;

 private:
  struct Callbacks;
  struct Clock final : WindowClock {
    double seconds() const override;
  };

  explicit DesktopWindow(GLFWwindow* window);

  GLFWwindow* window_;
  Clock clock_;
  std::vector<InputEvent> events_;
  std::vector<std::filesystem::path> drops_;
  bool activity_ = true, has_gui_ = false;
  Vec2 pointer_{0};      // at the last event
  double listened_ = 0;  // s, end of the last call of wait()
};

}  // namespace kerf
