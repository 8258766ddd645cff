#pragma once

#include <imgui.h>

#include <array>

#include "ui/window/gui_look.h"

namespace kerf {

namespace colours {
inline ImU32 text() { return ImGui::GetColorU32(ImGuiCol_Text); }
inline ImU32 secondary() { return ImGui::GetColorU32(ImGuiCol_TextDisabled); }
// Of a box of text in the viewport, whose contents show through.
inline ImU32 shade() { return ImGui::GetColorU32(ImGuiCol_WindowBg, 0.7f); }
inline ImU32 accent() { return ImGui::GetColorU32(ImGuiCol_NavHighlight); }

// Colours of marks at surfaces in the viewport, in every theme. Text is drawn on the shade, to be legible on
// a bright background.
inline constexpr ImU32 kPictureText = IM_COL32(0xe6, 0xe9, 0xee, 255);
inline constexpr ImU32 kPictureSecondary = IM_COL32(0x9a, 0xa6, 0xb6, 255);
inline constexpr ImU32 kPictureShade = IM_COL32(0x1b, 0x1f, 0x26, 165);
// The colour of an axis of the world: 0 for X, 1 for Y, 2 for Z.
inline constexpr std::array<ImU32, 3> kAxes{IM_COL32(0xd9, 0x6a, 0x62, 255), IM_COL32(0x84, 0xb3, 0x5c, 255),
                                            IM_COL32(0x62, 0x97, 0xdc, 255)};
}  // namespace colours

// Sets sizes, colours and the font of the current ImGui context. The font texture must be recreated
// afterwards. Precondition: called between frames.
void apply_theme(const GuiLook& look);

// The font of headings and large numbers: that of the text, rasterised at twice its size.
inline ImFont& large_font() { return *ImGui::GetIO().Fonts->Fonts.back(); }

}  // namespace kerf
