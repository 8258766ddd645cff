#pragma once

#include <optional>

#include "core/physics/contact/contact.h"
#include "core/physics/contact/moving_body.h"

namespace kerf {

// The contact that parts two bodies whose sheets intersect, or nothing where that would take too long. It
// lies in the middle of the places where chords go through faces, and pushes along the normal of that face
// which all points of the other body can leave behind on the shortest way. The overlap is such that the
// solver moves them apart at kPushOut at most, without giving them velocity (split impulses).
//
// `ticks`: for how many they have intersected. After kLongestPush no pair is pushed, nor is one that is too
// deep for what is left of that time. O(points * places).
std::optional<Contact> push_out(const MovingBody& first, const MovingBody& second, uint32_t ticks);

inline constexpr double kPushOut = 0.03;     // m/s
inline constexpr double kLongestPush = 4;    // s
inline constexpr double kSolvedShare = 0.2;  // of an overlap, that the solver takes away in a tick

}  // namespace kerf
