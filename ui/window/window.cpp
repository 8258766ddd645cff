#include "ui/window/window.h"

#include <backends/imgui_impl_glfw.h>
#include <GLFW/glfw3.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <map>
#include <utility>

#include "core/base/assert.h"
#include "core/base/platform.h"
#include "ui/gl/context.h"
#include "ui/window/scripted_window.h"

namespace kerf {

class DesktopWindow final : public Window {
 public:
  // Opens a window of a size in screen coordinates, which `scaled` multiplies by the scale of the display if
  // these are its pixels. Fails if there is no display or no OpenGL 3.3.
  static Result<std::unique_ptr<Window>> open(int width, int height, bool scaled, const std::string& title);
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
  std::map<int, int> keys_;  // the key of each place at its last press
  bool activity_ = true, has_gui_ = false;
  Vec2 pointer_{0};      // at the last event
  double listened_ = 0;  // s, end of the last call of wait()
};

void spread_times(std::span<InputEvent> events, double from, double to) {
  KERF_ASSERT(from <= to);
  const auto count = static_cast<double>(events.size());
  for (size_t i = 0; i < events.size(); ++i)
    events[i].seconds = from + (to - from) * (static_cast<double>(i + 1) / count);
}

namespace fs = std::filesystem;

namespace {

struct Name {
  int key;
  const char* text;
};
constexpr std::array kKeys{
    Name{GLFW_KEY_SPACE, "Space"},
    Name{GLFW_KEY_TAB, "Tab"},
    Name{GLFW_KEY_BACKSPACE, "Backspace"},
    Name{GLFW_KEY_INSERT, "Ins"},
    Name{GLFW_KEY_DELETE, "Del"},
    Name{GLFW_KEY_HOME, "Home"},
    Name{GLFW_KEY_END, "End"},
    Name{GLFW_KEY_PAGE_UP, "PgUp"},
    Name{GLFW_KEY_PAGE_DOWN, "PgDn"},
    Name{GLFW_KEY_UP, "Up"},
    Name{GLFW_KEY_DOWN, "Down"},
    Name{GLFW_KEY_LEFT, "Left"},
    Name{GLFW_KEY_RIGHT, "Right"},
    Name{GLFW_KEY_ENTER, "Enter"},
    Name{GLFW_KEY_PAUSE, "Pause"},
    Name{GLFW_KEY_KP_ADD, "Num +"},
    Name{GLFW_KEY_KP_SUBTRACT, "Num -"},
    Name{GLFW_KEY_KP_MULTIPLY, "Num *"},
};
// In writing order.
constexpr std::array kMods{Name{GLFW_MOD_CONTROL, "Ctrl+"}, Name{GLFW_MOD_SHIFT, "Shift+"},
                           Name{GLFW_MOD_ALT, "Alt+"}};

// GLFW's keys of printable characters are these characters, letters as capitals.
bool is_character(int key) { return key > ' ' && key <= GLFW_KEY_GRAVE_ACCENT && key != '+'; }

std::string key_text(int key) {
  for (const Name& name : kKeys) {
    if (name.key == key) return name.text;
  }
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  return is_character(key) ? std::string(1, static_cast<char>(key)) : "";
}

std::string stamp() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 64> text{};
  const size_t length = std::strftime(text.data(), text.size(), "kerf-%Y-%m-%d-%H%M%S", &local);
  return {text.data(), length};
}

fs::path free_name(const fs::path& folder) {
  const std::string name = stamp();
  fs::path file = folder / (name + ".png");
  std::error_code error;
  for (int i = 2; fs::exists(file, error); ++i) file = folder / (name + "-" + std::to_string(i) + ".png");
  return file;
}

}  // namespace

std::string chord_text(const KeyChord& chord) {
  const std::string key = key_text(chord.key);
  if (key.empty()) return "";
  std::string text;
  for (const Name& mod : kMods) {
    if ((chord.mods & mod.key) != 0) text += mod.text;
  }
  return text + key;
}

std::optional<KeyChord> parse_chord(std::string_view text) {
  KeyChord chord;
  for (const Name& mod : kMods) {
    if (!text.starts_with(mod.text)) continue;
    chord.mods |= mod.key;
    text.remove_prefix(std::string_view(mod.text).size());
  }
  for (chord.key = ' '; chord.key <= GLFW_KEY_LAST; ++chord.key) {
    if (!text.empty() && key_text(chord.key) == text) return chord;
  }
  return std::nullopt;
}

int character_key(int place, const char* name) {
  const bool is_digit = place >= GLFW_KEY_0 && place <= GLFW_KEY_9;
  if (place < GLFW_KEY_APOSTROPHE || place > GLFW_KEY_WORLD_2 || is_digit) return place;
  if (name == nullptr || name[0] == '\0' || name[1] != '\0') return place;
  if (name[0] >= 'a' && name[0] <= 'z') return GLFW_KEY_A + (name[0] - 'a');
  constexpr std::string_view kOthers = "'`,-./;=[]\\0123456789";  // GLFW's keys are these characters
  return kOthers.find(name[0]) != std::string_view::npos ? name[0] : place;
}

int character_key(int place) {
  return character_key(place, place == GLFW_KEY_UNKNOWN ? nullptr : glfwGetKeyName(place, 0));
}

bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

Area pixels_of(const Area& area, const Window& window) {
  const Vec2 scale = window.pixel_size() / window.size();
  const Vec2 from = glm::floor(area.at * scale), to = glm::floor((area.at + area.size) * scale);
  return {from, glm::max(Vec2(1), to - from)};
}

Result<std::unique_ptr<Window>> open_window(const WindowOptions& options) {
  const bool is_default = options.width == 0 || options.height == 0;
  const int width = is_default ? 1280 : options.width, height = is_default ? 800 : options.height;
  if (options.events) return ScriptedWindow::open(*options.events, width, height);
  return DesktopWindow::open(width, height, is_default, "Kerf");
}

Pixels window_pixels(Vec2 window, const Area& part) {
  const Pixels all = read_pixels(0, static_cast<int>(window.x), static_cast<int>(window.y));
  return cut_out(all, static_cast<int>(part.at.x), static_cast<int>(part.at.y), static_cast<int>(part.size.x),
                 static_cast<int>(part.size.y));
}

Result<fs::path> take_screenshot(Vec2 window, const Area& part) {
  const Pixels pixels = window_pixels(window, part);
  std::error_code error;
  const fs::path here = free_name(fs::current_path(error));
  const Status written = write_png(pixels, here);
  if (written) return here;
  if (home_folder().empty()) return written.error();
  const fs::path pictures = home_folder() / "Pictures";
  fs::create_directories(pictures, error);
  const fs::path there = free_name(pictures);
  const Status second = write_png(pixels, there);
  if (second) return there;
  return written.error();
}

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
  // The layout may change while a key is held.
  static int key_at(GLFWwindow* w, int place, int action) {
    const auto [key, is_new] = of(w).keys_.try_emplace(place);
    if (is_new || action == GLFW_PRESS) key->second = character_key(place);
    return key->second;
  }
  static void key(GLFWwindow* w, int place, int, int action, int mods) {
    const auto kind = action == GLFW_RELEASE ? InputEvent::Kind::kKeyUp : InputEvent::Kind::kKey;
    put(w, {.kind = kind,
            .at = pointer(w),
            .button = key_at(w, place, action),
            .mods = mods,
            .again = action == GLFW_REPEAT,
            .place = place});
  }
  static void character(GLFWwindow* w, unsigned character) {
    put(w, {.kind = InputEvent::Kind::kText, .at = pointer(w), .character = character});
  }
  static void enter(GLFWwindow* w, int entered) {
    if (of(w).has_gui_) ImGui_ImplGlfw_CursorEnterCallback(w, entered);
    of(w).activity_ = true;
  }
  static void drop(GLFWwindow* w, int count, const char** files) {
    of(w).drops_.insert(of(w).drops_.end(), files, files + count);
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

// Limits a size to the work area of the screen, also after a multiplication by the scale of the screen.
static void fit_into_screen(int& width, int& height, bool scaled) {
  GLFWmonitor* screen = glfwGetPrimaryMonitor();
  if (screen == nullptr) return;
  int x = 0, y = 0, wide = 0, high = 0;
  glfwGetMonitorWorkarea(screen, &x, &y, &wide, &high);
  float across = 1, down = 1;
  if (scaled) glfwGetMonitorContentScale(screen, &across, &down);
  const auto limit = [](int size, float scale) { return static_cast<int>(static_cast<float>(size) / scale); };
  if (wide > 0 && across >= 1) width = std::min(width, limit(wide, across));
  if (high > 0 && down >= 1) height = std::min(height, limit(high, down));
}

Result<std::unique_ptr<Window>> DesktopWindow::open(int width, int height, bool scaled,
                                                    const std::string& title) {
  glfwSetErrorCallback(nullptr);
  if (!glfwInit())
    return failed("there is no display for a window; use `kerf render` or `kerf play --headless`");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, scaled ? GLFW_TRUE : GLFW_FALSE);
  fit_into_screen(width, height, scaled);
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

// Under Wayland a screen coordinate has several pixels, and the size of text is in screen coordinates.
float DesktopWindow::scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  const double width = size().x, pixels = pixel_size().x;
  if (width > 0 && pixels > 0) x *= static_cast<float>(width / pixels);
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
