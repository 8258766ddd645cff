#pragma once

#include <optional>
#include <string>

#include "core/base/vec3.h"

namespace kerf {

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

}  // namespace kerf
