#pragma once

#include <imgui.h>

namespace kerf {

// The colours of the panels.
namespace colours {
inline constexpr ImU32 kPanel = IM_COL32(0x1b, 0x1f, 0x26, 255);
inline constexpr ImU32 kField = IM_COL32(0x26, 0x2c, 0x36, 255);
inline constexpr ImU32 kBorder = IM_COL32(0x5d, 0x6b, 0x7e, 255);
inline constexpr ImU32 kText = IM_COL32(0xe6, 0xe9, 0xee, 255);
inline constexpr ImU32 kSecondary = IM_COL32(0x9a, 0xa6, 0xb6, 255);
inline constexpr ImU32 kAccent = IM_COL32(0xff, 0x9d, 0x2e, 255);
}  // namespace colours

// Sizes, colours and the font of the current ImGui context, for a display that asks for this scale. Call
// once, before the first frame.
void apply_theme(float scale);

}  // namespace kerf
