#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace kerf {

// A key with modifiers.
struct KeyChord {
  int key = 0;   // GLFW_KEY_*; 0: none
  int mods = 0;  // GLFW_MOD_CONTROL, SHIFT, ALT
  friend bool operator==(const KeyChord&, const KeyChord&) = default;
};

// The chord as menus and settings write it: "Ctrl+Shift+Z", "Del", "F4"; empty for a key without a name.
std::string chord_text(const KeyChord& chord);

// The chord of such a text; nothing where it names none. The inverse of chord_text().
std::optional<KeyChord> parse_chord(std::string_view text);

// Whether the key (GLFW_KEY_*) is Shift, Ctrl, Alt or Super.
bool is_modifier(int key);

}  // namespace kerf
