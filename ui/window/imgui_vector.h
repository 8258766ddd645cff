#pragma once

#include <imgui.h>

#include "core/base/vec3.h"

namespace kerf {

// A point of the window in the type of ImGui.
inline ImVec2 to_im(Vec2 p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

}  // namespace kerf
