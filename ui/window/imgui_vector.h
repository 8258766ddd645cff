#pragma once

#include <imgui.h>

#include <cstdint>

#include "core/base/vec3.h"

namespace kerf {

// A point of the window in the type of ImGui.
inline ImVec2 to_im(Vec2 p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

// A texture of OpenGL in the type of ImGui.
inline ImTextureID to_im_texture(unsigned name) {
  return reinterpret_cast<ImTextureID>(static_cast<uintptr_t>(name));
}

}  // namespace kerf
