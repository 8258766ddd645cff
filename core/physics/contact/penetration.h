#pragma once

#include <optional>

#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"

namespace kerf {

// Returns true if a chord of one of two bodies passes through a face of the other at the beginning of a
// tick. This detects intersecting sheets in general: the line in which two surfaces meet ends at a rim of
// one of them.
bool sheets_cross(const MovingBody& a, const MovingBody& b);

// Returns true if two bodies that were apart at the beginning of a tick intersect, or have passed through
// each other, at MovingBody::next: if a chord of one passes through a face of the other, or a point of one
// met a face of the other on its way.
bool get_through(const MovingBody& a, const MovingBody& b);

// Returns the contact that separates two bodies whose sheets intersect, or nullopt if that would take too
// long. It lies in the middle of the places where chords pass through faces, and pushes along the shortest
// way on which all points of one body pass the plane of a face at such a place, or the points of both come
// to lie on two sides of a plane. Its overlap makes the solver move them apart at kPushOut at most, without
// giving them velocity (split impulses).
//
// A pair that has intersected for kMaxPush (PairMemory::crossed) is no longer pushed, nor is one deeper
// than kDeepestPush. `memory` keeps the way, so that it does not alternate. O(points * places).
std::optional<Contact> push_out(const MovingBody& first, const MovingBody& second, PairMemory& memory);

inline constexpr double kPushOut = 0.06;      // m/s
inline constexpr double kDeepestPush = 0.12;  // m
inline constexpr double kMaxPush = 4;         // s
inline constexpr double kSolvedShare = 0.2;   // share of an overlap that the solver removes in a tick

}  // namespace kerf
