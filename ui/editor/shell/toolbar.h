#pragma once

#include <imgui.h>
#include <optional>
#include <span>
#include <string>

#include "ui/editor/shared/user_input.h"
#include "ui/window/icons.h"
#include "ui/window/layout.h"

namespace kerf {

// A bar over the viewport, as large as its content.
inline constexpr ImGuiWindowFlags kOverlayBar =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
    ImGuiWindowFlags_NoBringToFrontOnFocus;

// Returns the icon of an action of the toolbar; nullopt if it has none there.
std::optional<Icon> icon_of_tool(const std::string& action);

// Returns the area of the toolbar at the left edge of the viewport; empty if the viewport is too low for it.
Area toolbar_area(const Area& viewport);

// Draws the tools as icons in that area, the active one lit; each is a landmark by the id of its action.
// Hovering shows name, key and purpose.
void draw_toolbar(const Area& viewport, std::span<const UserAction> actions);

}  // namespace kerf
