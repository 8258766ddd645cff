#pragma once

#include <imgui.h>

#include "ui/window/gui_look.h"

namespace kerf {

// The colours of the panels as they are at the moment.
namespace colours {
inline ImU32 text() { return ImGui::GetColorU32(ImGuiCol_Text); }
inline ImU32 secondary() { return ImGui::GetColorU32(ImGuiCol_TextDisabled); }
inline ImU32 accent() { return ImGui::GetColorU32(ImGuiCol_NavHighlight); }

// Over the picture, which is dark in every theme.
inline constexpr ImU32 kPictureText = IM_COL32(0xe6, 0xe9, 0xee, 255);
inline constexpr ImU32 kPictureSecondary = IM_COL32(0x9a, 0xa6, 0xb6, 255);
inline constexpr ImU32 kPictureShade = IM_COL32(0x1b, 0x1f, 0x26, 165);
}  // namespace colours

// Sizes, colours and the font of the current ImGui context. Not within a frame; the texture of the fonts has
// to be made anew.
void apply_theme(const GuiLook& look);

}  // namespace kerf
