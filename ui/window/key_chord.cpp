#include "ui/window/key_chord.h"

#include <GLFW/glfw3.h>

#include <array>

namespace kerf {

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
// In the order in which they are written.
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

}  // namespace kerf
