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

// A point of the window in the type of ImGui.
inline ImVec2 to_im(Vec2 p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

// A texture of OpenGL in the type of ImGui.
inline ImTextureID to_im_texture(unsigned name) {
  return reinterpret_cast<ImTextureID>(static_cast<uintptr_t>(name));
}

// A button that takes one of `shares` equal parts of the width of a panel. With a reason `disabled_reason` it
// is disabled, and its tooltip says why; otherwise the tooltip is `meaning`. Returns whether it was pressed.
bool row_button(const char* label, int shares, const char* disabled_reason, const char* meaning);

// Widgets that choose the unit and the upward axis of a file, as landmarks "unit" and "up axis". They return
// whether the user has changed it.
bool unit_combo(FileUnit& unit);
bool up_axis_combo(UpAxis& up);

// Draws over the lower edge of a picture what is being done, how far it is (0 to 1), and a button that stops
// it where it can be stopped. Returns whether the button was pressed.
bool draw_progress(const Area& picture, const std::string& title, double fraction, bool can_stop);

// What the user did to a splitter in a frame.
struct SplitterMove {
  std::optional<double> dragged;  // the coordinate across it that it was dragged to, screen coordinates
  bool reset = false;             // it was double-clicked
};

// Draws a vertical strip of the given height at `top` that can be dragged sideways. `tip` is its tooltip.
SplitterMove splitter(const char* id, Vec2 top, double height, const char* tip);
// Draws a horizontal strip of the given width from `left` that can be dragged up and down.
SplitterMove splitter_across(const char* id, Vec2 left, double width, const char* tip);

// A window in the middle of the screen that cannot be moved, of a size in sizes of the text or as large as
// the screen allows. `shown` becomes false when the user closes it. Returns whether its content is visible;
// end_centred_window() has to be called in any case. The window is a landmark.
bool begin_centred_window(const char* title, const char* landmark, bool& shown, float width_ems,
                          float height_ems);
void end_centred_window();

// Something that the user has to decide before anything else goes on: a window in the middle with one button
// for each choice. Enter takes the first choice, Esc the last, and a choice may have a letter.
struct Question {
  struct Choice {
    std::string label;
    std::string tip;
    char letter = 0;  // a capital, or 0: a key that is pressed by chance must not take this choice
  };

  std::string title, text;
  std::vector<Choice> choices;   // empty: nothing is asked
  std::optional<size_t> answer;  // the index of the choice that was taken

  bool open() const { return !choices.empty(); }
};

// Takes a key (GLFW_KEY_*) that was pressed while the question is open.
void question_key(Question& question, int key);

// Draws the question as a modal window where it is open.
void draw_question(Question& question);

}  // namespace kerf
