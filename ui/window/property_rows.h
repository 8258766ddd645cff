#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/geometry.h"
#include "ui/window/number_text.h"

namespace kerf {

// Texts for a limited width, in pixels. What does not fit is shortened at a whole character: it is never cut
// off by the edge of its widget.

// The width of a text; by default in the present font of ImGui.
using TextWidth = std::function<float(std::string_view)>;
float width_of_text(std::string_view text);

// The text, or its beginning and an ellipsis. Empty if not even the ellipsis fits. O(size of the text).
std::string fitted_text(std::string_view text, float width, const TextWidth& width_of = width_of_text);

// The number with its unit as number_text() gives it, or with fewer digits, then without the unit; the
// ellipsis where not even one digit fits.
std::string fitted_number(double value, const RealFormat& format, std::string_view unit, double scale,
                          float width, const TextWidth& width_of = width_of_text);

// The label of a widget of ImGui with its visible part fitted; the widget keeps its identity.
std::string fitted_label(const std::string& label, float width);
// The visible part of a label.
std::string visible_part(const std::string& label);

// ImGui::BeginCombo() with the chosen value fitted in it.
bool begin_fitted_combo(const char* id, const std::string& preview);

// Draws an item with the text, fitted in `width`, or in what is left of the row if that is 0. Where it is
// shortened, its tooltip begins with all of it. `meaning` is the tooltip otherwise, and may be null.
void draw_fitted_text(const std::string& text, const char* meaning = nullptr, float width = 0);

// Rows of a panel with labels at the left and widgets in a column at the right. Between begin_properties(),
// if it returns true, and end_properties(), each row calls property() and then draws its one widget, which
// tooltip() can explain.
bool begin_properties(const char* id);
void property(const char* label);
void end_properties();

// What a tooltip shows under its text: a texture of the current context, and its size (screen coordinates).
struct TipPicture {
  unsigned texture = 0;
  Vec2 size{0};
};

// Shows a text when the pointer rests on the last item, even a disabled one, for half a second while no
// button is held. It is shown beside the window of the item where there is room, so that it covers no other
// widget.
void tooltip(const char* text, const std::optional<TipPicture>& picture = std::nullopt);

// A row that shows a text, explained by a tooltip.
void figure_row(const char* name, const std::string& value, const char* meaning);

struct Slider {
  const char* name;     // in messages
  const char* id;       // of ImGui
  const char* meaning;  // the tooltip
  bool logarithmic = false;
  bool takes_text = true;  // Ctrl+click, and Tab, make it a number field (see NumberFields)
};

// Draws a slider as wide as the next item. The value stands beside the grab, shortened if it does not fit
// there, and the tooltip has all of it then. What is typed is limited to the range, with a message. Returns
// whether the value was changed. `text` is shown in place of the number unless it is empty.
bool real_slider(const Slider& slider, double& value, double low, double high, const RealFormat& format,
                 const NumberUnit& unit = {}, const std::string& text = "");
bool whole_slider(const Slider& slider, int& value, int low, int high, const std::string& text,
                  const NumberUnit& unit = {});

// Where the text of a slider stands between `left` and `right`: in the middle, or as near to it as the grab,
// which is in between, leaves room for it.
struct SliderRoom {
  float at = 0, width = 0;
};
SliderRoom room_beside_grab(float left, float right, float grab_left, float grab_right, float text_width);

}  // namespace kerf
