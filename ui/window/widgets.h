#pragma once

#include <imgui.h>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"

namespace kerf {

// Texts for a limited width [pixels]. They are shortened at a character boundary rather than clipped by the
// edge of their widget.

// The width of a text; by default in the current font of ImGui.
using TextWidth = std::function<float(std::string_view)>;
float width_of_text(std::string_view text);

// Returns the text, or its beginning and an ellipsis. Empty if not even the ellipsis fits. O(size of the
// text).
std::string fitted_text(std::string_view text, float width, const TextWidth& width_of = width_of_text);

// Returns the text, or an ellipsis and its end. O(square of the size of the text).
std::string fitted_end(std::string_view text, float width, const TextWidth& width_of = width_of_text);

// Copies a text into the buffer of ImGui::InputText(), truncated at a character boundary if it is too long.
// Precondition: the buffer is not empty.
void fill_field(std::span<char> buffer, std::string_view text);

// Returns the number with its unit as number_text() formats it; if that is too wide, with fewer digits,
// then without the unit; an ellipsis if no digit fits.
std::string fitted_number(double value, const RealFormat& format, std::string_view unit, double scale,
                          float width, const TextWidth& width_of = width_of_text);

// Returns the label of an ImGui widget with its visible part fitted; its ID is unchanged.
std::string fitted_label(const std::string& label, float width);
std::string visible_part(const std::string& label);

// ImGui::BeginCombo() with the selected value fitted into it, shown with any "##" in it.
bool begin_fitted_combo(const char* id, const std::string& preview);

// Returns a label that shows the whole text: ImGui hides "##" and what follows it. An "##id" may be appended.
std::string whole_label(std::string text);

// Draws an item with the text, fitted into `width`, or into the rest of the row if that is 0. A shortened
// text begins the tooltip in full. `meaning` is the rest of the tooltip, and may be null.
void draw_fitted_text(const std::string& text, const char* meaning = nullptr, float width = 0);

// Rows of a panel with labels at the left and widgets in a column at the right. Between begin_properties(),
// if it returns true, and end_properties(), each row calls property() and then draws its one widget,
// optionally followed by tooltip(). Outside of a table, label and widget share a line, as in the header of a
// tool, and the width of the widget is that of ImGui::PushItemWidth().
bool begin_properties(const char* id);
void property(const char* label);
void end_properties();

// An image below the text of a tooltip: a texture of the current context, and its size (screen
// coordinates).
struct TipPicture {
  unsigned texture = 0;
  Vec2 size{0};
};

// Shows a tooltip if the pointer has rested on the last item, even a disabled one, for half a second with
// no button held. Placed next to the item's window if there is space, so that it covers no other widget.
void tooltip(const char* text, const std::optional<TipPicture>& picture = std::nullopt);

void figure_row(const char* name, const std::string& value, const char* meaning);

struct Slider {
  const char* name;     // in messages
  const char* id;       // of ImGui
  const char* meaning;  // tooltip
  bool logarithmic = false;
  bool takes_text = true;  // double click, a click on the value or Tab make it a field (see NumberFields)
};

// Draws a slider as wide as the next item. The value is shown at the left of the track, shortened to fit;
// the tooltip then has it in full. The track is the last item. Typed values are limited to the range, with a
// message. Returns true if the value changed. A non-empty `text` replaces the shown number.
bool real_slider(const Slider& slider, double& value, double low, double high, const RealFormat& format,
                 const NumberUnit& unit = {}, const std::string& text = "");
bool whole_slider(const Slider& slider, int& value, int low, int high, const std::string& text,
                  const NumberUnit& unit = {});

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

// Formats the progress of running work, rounded down: "40 %", at most "99 %"; empty if it has not begun.
std::string progress_text(double fraction);

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
