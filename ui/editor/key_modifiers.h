#pragma once

#include <GLFW/glfw3.h>

namespace kerf {

inline constexpr int kCtrl = GLFW_MOD_CONTROL, kShift = GLFW_MOD_SHIFT;

}  // namespace kerf
