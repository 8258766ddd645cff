#include "ui/window/desktop_window.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <span>
#include <utility>

#include <backends/imgui_impl_glfw.h>

#include "core/base/assert.h"
#include "ui/gl/context.h"

namespace kerf {

// The callbacks of GLFW. ImGui's backend has none: it is fed from the queue of events.
struct DesktopWindow::Callbacks {
  static DesktopWindow& of(GLFWwindow* w) {
    return *static_cast<DesktopWindow*>(glfwGetWindowUserPointer(w));
  }
  // GLFW would query the current position, and the pointer may have moved before a slow frame processes a
  // press.
  static Vec2 pointer(GLFWwindow* w) { return of(w).pointer_; }
  static void put(GLFWwindow* w, InputEvent event) {
    event.seconds = glfwGetTime();
    of(w).events_.push_back(event);
    of(w).activity_ = true;
  }
  // GLFW passes modifiers with keys and buttons, but not with pointer moves.
  static int modifiers(GLFWwindow* w) {
    const auto held = [w](int left, int right, int mod) {
      return glfwGetKey(w, left) == GLFW_PRESS || glfwGetKey(w, right) == GLFW_PRESS ? mod : 0;
    };
    return held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL, GLFW_MOD_CONTROL) |
           held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT, GLFW_MOD_SHIFT) |
           held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT, GLFW_MOD_ALT);
  }
  static void cursor(GLFWwindow* w, double x, double y) {
    of(w).pointer_ = {x, y};
    put(w, {InputEvent::Kind::kMove, {x, y}, 0, modifiers(w)});
  }
  static void button(GLFWwindow* w, int button, int action, int mods) {
    const auto kind = action == GLFW_PRESS ? InputEvent::Kind::kPress : InputEvent::Kind::kRelease;
    put(w, {kind, pointer(w), button, mods});
  }
  static void scroll(GLFWwindow* w, double x, double y) {
    put(w, {.kind = InputEvent::Kind::kWheel, .at = pointer(w), .wheel = y, .wheel_aside = x});
  }
  static void key(GLFWwindow* w, int key, int, int action, int mods) {
    const auto kind = action == GLFW_RELEASE ? InputEvent::Kind::kKeyUp : InputEvent::Kind::kKey;
    put(w, {kind, pointer(w), key, mods, 0, action == GLFW_REPEAT});
  }
  static void character(GLFWwindow* w, unsigned character) {
    put(w, {.kind = InputEvent::Kind::kText, .at = pointer(w), .character = character});
  }
  static void enter(GLFWwindow* w, int entered) {
    if (of(w).has_gui_) ImGui_ImplGlfw_CursorEnterCallback(w, entered);
    of(w).activity_ = true;
  }
  static void drop(GLFWwindow* w, int count, const char** files) {
    of(w).drops_.assign(files, files + count);
    of(w).activity_ = true;
  }
  template <typename... Ignored>
  static void wake(GLFWwindow* w, Ignored...) {
    of(w).activity_ = true;
  }
};

DesktopWindow::DesktopWindow(GLFWwindow* window) : window_(window) {
  glfwSetWindowUserPointer(window, this);
  glfwGetCursorPos(window, &pointer_.x, &pointer_.y);
  glfwSetCursorPosCallback(window, Callbacks::cursor);
  glfwSetMouseButtonCallback(window, Callbacks::button);
  glfwSetScrollCallback(window, Callbacks::scroll);
  glfwSetKeyCallback(window, Callbacks::key);
  glfwSetCharCallback(window, Callbacks::character);
  glfwSetCursorEnterCallback(window, Callbacks::enter);
  glfwSetDropCallback(window, Callbacks::drop);
  glfwSetWindowRefreshCallback(window, Callbacks::wake<>);
  glfwSetFramebufferSizeCallback(window, Callbacks::wake<int, int>);
  glfwSetWindowCloseCallback(window, Callbacks::wake<>);
  glfwSetWindowFocusCallback(window, Callbacks::wake<int>);
}

DesktopWindow::~DesktopWindow() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

// Limits a size to the work area of the screen.
static void fit_into_screen(int& width, int& height) {
  GLFWmonitor* screen = glfwGetPrimaryMonitor();
  if (screen == nullptr) return;
  int x = 0, y = 0, wide = 0, high = 0;
  glfwGetMonitorWorkarea(screen, &x, &y, &wide, &high);
  if (wide > 0) width = std::min(width, wide);
  if (high > 0) height = std::min(height, high);
}

Result<std::unique_ptr<Window>> DesktopWindow::open(int width, int height, const std::string& title) {
  glfwSetErrorCallback(nullptr);
  if (!glfwInit())
    return failed("there is no display for a window; use `kerf render` or `kerf play --headless`");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  fit_into_screen(width, height);
  GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window == nullptr) {
    glfwTerminate();
    return failed("the display does not support OpenGL 3.3; `kerf render` needs no display");
  }
  glfwSetWindowSizeLimits(window, 480, 360, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(window);
  glfwSwapInterval(1);
  gl::report_gl_errors();
  return std::unique_ptr<Window>(new DesktopWindow(window));
}

Vec2 DesktopWindow::size() const {
  int w = 0, h = 0;
  glfwGetWindowSize(window_, &w, &h);
  return {w, h};
}

Vec2 DesktopWindow::pixel_size() const {
  int w = 0, h = 0;
  glfwGetFramebufferSize(window_, &w, &h);
  return {w, h};
}

float DesktopWindow::scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return std::clamp(x, 0.75f, 4.0f);
}

void DesktopWindow::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

void DesktopWindow::swap() { glfwSwapBuffers(window_); }

// Input

void DesktopWindow::wait(double seconds) {
  KERF_ASSERT(seconds >= 0);
  const size_t previous_count = events_.size();
  glfwPollEvents();
  const double now = glfwGetTime();
  spread_times(std::span(events_).subspan(previous_count), listened_, now);
  if (seconds > 0 && !activity_) glfwWaitEventsTimeout(seconds);
  listened_ = glfwGetTime();
}

std::vector<InputEvent> DesktopWindow::take_events() { return std::exchange(events_, {}); }

std::vector<std::filesystem::path> DesktopWindow::take_drops() { return std::exchange(drops_, {}); }

bool DesktopWindow::take_close() {
  const bool wanted = glfwWindowShouldClose(window_) != 0;
  glfwSetWindowShouldClose(window_, 0);
  return wanted;
}

bool DesktopWindow::take_activity() { return std::exchange(activity_, false); }

bool DesktopWindow::is_key_held(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

bool DesktopWindow::is_button_held(int button) const {
  return glfwGetMouseButton(window_, button) == GLFW_PRESS;
}

bool DesktopWindow::has_focus() const { return glfwGetWindowAttrib(window_, GLFW_FOCUSED) == GLFW_TRUE; }

void DesktopWindow::catch_pointer(bool caught) {
  glfwSetInputMode(window_, GLFW_CURSOR, caught ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
}

double DesktopWindow::Clock::seconds() const { return glfwGetTime(); }

// ImGui

void DesktopWindow::attach_gui() {
  ImGui_ImplGlfw_InitForOpenGL(window_, false);
  has_gui_ = true;
}

void DesktopWindow::detach_gui() {
  has_gui_ = false;
  ImGui_ImplGlfw_Shutdown();
}

void DesktopWindow::begin_gui_frame() { ImGui_ImplGlfw_NewFrame(); }

}  // namespace kerf
