#pragma once

#include <imgui.h>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/window/layout.h"

namespace kerf {

inline ImVec2 to_im(Vec2 p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

inline ImTextureID to_im_texture(unsigned name) {
  return reinterpret_cast<ImTextureID>(static_cast<uintptr_t>(name));
}

// A button that takes one of `shares` equal parts of a panel's width. A `disabled_reason` disables it and
// becomes its tooltip; otherwise the tooltip is `meaning`. Returns true if it was pressed.
bool row_button(const char* label, int shares, const char* disabled_reason, const char* meaning);

// Combo boxes for the unit and the up axis of a file, as landmarks "unit" and "up axis". They return true
// on a change.
bool unit_combo(FileUnit& unit);
bool up_axis_combo(UpAxis& up);

// Draws a progress bar over the lower edge of the viewport: title, fraction (0 to 1) and, if `can_stop`, a
// stop button. Returns true if the button was pressed.
bool draw_progress(const Area& picture, const std::string& title, double fraction, bool can_stop);

struct SplitterMove {
  std::optional<double> dragged;  // new coordinate across the splitter, screen coordinates
  bool reset = false;             // double-clicked
};

// Draws a vertical splitter of the given height at `top`, to be dragged sideways. `tip` is its tooltip.
SplitterMove splitter(const char* id, Vec2 top, double height, const char* tip);
// Draws a horizontal splitter of the given width from `left`, to be dragged up and down.
SplitterMove splitter_across(const char* id, Vec2 left, double width, const char* tip);

// A fixed window in the middle of the screen, with a size in em, limited by the screen. `shown` becomes
// false when the user closes it. Returns true if its content is visible; end_centred_window() must be
// called in any case. The window is a landmark.
bool begin_centred_window(const char* title, const char* landmark, bool& shown, float width_ems,
                          float height_ems);
void end_centred_window();

// A modal question to the user: a window in the middle with one button per choice. Enter takes the first
// choice, Esc the last; a choice may have a letter as a shortcut.
struct Question {
  struct Choice {
    std::string label;
    std::string tip;
    char letter = 0;  // a capital; 0: no shortcut, so that an accidental key press cannot take it
  };

  std::string title, text;
  std::vector<Choice> choices;   // empty: no question
  std::optional<size_t> answer;  // index of the selected choice

  bool open() const { return !choices.empty(); }
};

// Processes a key press (GLFW_KEY_*) while the question is open.
void question_key(Question& question, int key);

void draw_question(Question& question);

}  // namespace kerf
