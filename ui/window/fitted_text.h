#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "ui/window/number_format.h"

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

}  // namespace kerf
