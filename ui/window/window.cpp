#include "ui/window/window.h"

#include <GLFW/glfw3.h>
#include <array>
#include <chrono>
#include <ctime>

#include "core/base/assert.h"
#include "core/base/platform.h"
#include "ui/window/desktop_window.h"
#include "ui/window/scripted_window.h"

namespace kerf {

void spread_times(std::span<InputEvent> events, double from, double to) {
  KERF_ASSERT(from <= to);
  const auto count = static_cast<double>(events.size());
  for (size_t i = 0; i < events.size(); ++i)
    events[i].seconds = from + (to - from) * (static_cast<double>(i + 1) / count);
}

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

bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

Area pixels_of(const Area& area, const Window& window) {
  const Vec2 scale = window.pixel_size() / window.size();
  const Vec2 from = glm::floor(area.at * scale), to = glm::floor((area.at + area.size) * scale);
  return {from, glm::max(Vec2(1), to - from)};
}

Result<std::unique_ptr<Window>> open_window(const WindowOptions& options) {
  if (options.events) return ScriptedWindow::open(*options.events, options.width, options.height);
  return DesktopWindow::open(options.width, options.height, "Kerf");
}

namespace {

namespace fs = std::filesystem;

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

}  // namespace kerf
