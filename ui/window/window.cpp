#include "ui/window/window.h"

#include <epoxy/gl.h>
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace kerf {

void spread_times(std::span<InputEvent> events, double from, double to) {
  assert(from <= to);
  const auto count = static_cast<double>(events.size());
  for (size_t i = 0; i < events.size(); ++i)
    events[i].seconds = from + (to - from) * (static_cast<double>(i + 1) / count);
}

Window::Inner::~Inner() {
  if (window != nullptr) glfwDestroyWindow(window);
  glfwTerminate();
}

// What GLFW calls; set before ImGui's, which call on to these.
struct Window::Callbacks {
  static Inner& inner(GLFWwindow* w) { return *static_cast<Inner*>(glfwGetWindowUserPointer(w)); }
  // GLFW asks the display where the pointer is at the moment; when a slow frame hears of a press, it has gone
  // on.
  static Vec2 pointer(GLFWwindow* w) { return inner(w).pointer; }
  static void put(GLFWwindow* w, InputEvent event) {
    event.seconds = glfwGetTime();
    inner(w).events.push_back(event);
    inner(w).activity = true;
  }
  static void cursor(GLFWwindow* w, double x, double y) {
    inner(w).pointer = {x, y};
    put(w, {InputEvent::Kind::kMove, {x, y}});
  }
  static void button(GLFWwindow* w, int button, int action, int mods) {
    const auto kind = action == GLFW_PRESS ? InputEvent::Kind::kPress : InputEvent::Kind::kRelease;
    put(w, {kind, pointer(w), button, mods});
  }
  static void scroll(GLFWwindow* w, double, double y) {
    put(w, {InputEvent::Kind::kWheel, pointer(w), 0, 0, y});
  }
  static void key(GLFWwindow* w, int key, int, int action, int mods) {
    if (action != GLFW_RELEASE)
      put(w, {InputEvent::Kind::kKey, pointer(w), key, mods, 0, action == GLFW_REPEAT});
    inner(w).activity = true;
  }
  static void drop(GLFWwindow* w, int count, const char** files) {
    inner(w).drops.assign(files, files + count);
    inner(w).activity = true;
  }
  static void refresh(GLFWwindow* w) { inner(w).activity = true; }
  static void close(GLFWwindow* w) { inner(w).activity = true; }
  static void resize(GLFWwindow* w, int, int) { inner(w).activity = true; }
  static void focus(GLFWwindow* w, int) { inner(w).activity = true; }
};

Result<Window> Window::open(int width, int height, const std::string& title) {
  glfwSetErrorCallback(nullptr);
  if (!glfwInit()) return failed("a window needs a display; `kerf render` draws without one, and `kerf play --headless` plays");
  auto inner = std::make_unique<Inner>();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  inner->window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (inner->window == nullptr)
    return failed("this display offers no OpenGL 3.3; `kerf render` draws without it");
  glfwSetWindowSizeLimits(inner->window, 480, 360, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(inner->window);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(inner->window, inner.get());
  glfwGetCursorPos(inner->window, &inner->pointer.x, &inner->pointer.y);
  glfwSetCursorPosCallback(inner->window, Callbacks::cursor);
  glfwSetMouseButtonCallback(inner->window, Callbacks::button);
  glfwSetScrollCallback(inner->window, Callbacks::scroll);
  glfwSetKeyCallback(inner->window, Callbacks::key);
  glfwSetDropCallback(inner->window, Callbacks::drop);
  glfwSetWindowRefreshCallback(inner->window, Callbacks::refresh);
  glfwSetFramebufferSizeCallback(inner->window, Callbacks::resize);
  glfwSetWindowCloseCallback(inner->window, Callbacks::close);
  glfwSetWindowFocusCallback(inner->window, Callbacks::focus);
  return Window(std::move(inner));
}

bool Window::take_close() {
  const bool wanted = glfwWindowShouldClose(handle()) != 0;
  glfwSetWindowShouldClose(handle(), 0);
  return wanted;
}

Vec2 Window::size() const {
  int w = 0, h = 0;
  glfwGetWindowSize(handle(), &w, &h);
  return {w, h};
}

Vec2 Window::pixel_size() const {
  int w = 0, h = 0;
  glfwGetFramebufferSize(handle(), &w, &h);
  return {w, h};
}

float Window::scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(handle(), &x, &y);
  return std::clamp(x, 0.75f, 4.0f);
}

void Window::set_title(const std::string& title) { glfwSetWindowTitle(handle(), title.c_str()); }

void Window::swap() { glfwSwapBuffers(handle()); }

void Window::wait(double seconds) {
  std::vector<InputEvent>& events = inner_->events;
  const size_t heard = events.size();
  glfwPollEvents();
  const double now = glfwGetTime();
  spread_times(std::span(events).subspan(heard), inner_->listened, now);
  if (seconds > 0 && !inner_->activity) glfwWaitEventsTimeout(seconds);
  inner_->listened = glfwGetTime();
}

std::vector<InputEvent> Window::take_events() { return std::exchange(inner_->events, {}); }

std::vector<std::filesystem::path> Window::take_drops() { return std::exchange(inner_->drops, {}); }

bool Window::take_activity() { return std::exchange(inner_->activity, false); }

Area pixels_of(const Area& area, const Window& window) {
  const Vec2 scale = window.pixel_size() / window.size();
  const Vec2 from = glm::floor(area.at * scale), to = glm::floor((area.at + area.size) * scale);
  return {from, glm::max(Vec2(1), to - from)};
}

}  // namespace kerf
