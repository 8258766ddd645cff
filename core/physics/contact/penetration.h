#pragma once

#include <optional>

#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"

namespace kerf {

// Whether a chord of one of two bodies goes through a face of the other at the beginning of a tick. Sheets
// that intersect do so as a rule: the line in which two surfaces meet ends at a rim of one of them.
bool sheets_cross(const MovingBody& a, const MovingBody& b);

// Whether two bodies that were apart at the beginning of a tick intersect, or went through each other, when
// they have moved on to MovingBody::next: whether a chord of one goes through a face of the other, or a point
// of one met a face of the other on its way.
bool get_through(const MovingBody& a, const MovingBody& b);

// The contact that parts two bodies whose sheets intersect, or nothing where that would take too long. It
// lies in the middle of the places where chords go through faces, and pushes on the shortest way on which all
// points of one body leave the plane of a face at such a place behind, or the points of both come to lie on
// two sides of a plane. The overlap is such that the solver moves them apart at kPushOut at most, without
// giving them velocity (split impulses).
//
// A pair that has intersected for kLongestPush (PairMemory::crossed) is not pushed any more, nor is one that
// is deeper than kDeepestPush. The way is kept in `memory`, so that it does not turn back and forth. O(points
// * places).
std::optional<Contact> push_out(const MovingBody& first, const MovingBody& second, PairMemory& memory);

inline constexpr double kPushOut = 0.06;      // m/s
inline constexpr double kDeepestPush = 0.12;  // m
inline constexpr double kLongestPush = 4;     // s
inline constexpr double kSolvedShare = 0.2;   // of an overlap, that the solver takes away in a tick

}  // namespace kerf
