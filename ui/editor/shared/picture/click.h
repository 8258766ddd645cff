#pragma once

namespace kerf {

// The distance that the pointer may move between the press and the release of a click, in screen coordinates.
inline constexpr double kClickReach = 4;

}  // namespace kerf
