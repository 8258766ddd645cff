#pragma once

#include <cstdint>

#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// Makes every cut-off piece a separate body, so that it can move (see detach). In each visible body the piece
// with the lowest label stays; the others inherit its velocity and spin, are not pinned, and are pushed apart
// from it: with equal and opposite impulses along the line between the centres of mass, to a relative speed
// of kPushApart. Pinned bodies are not pushed, nor are parts that were not cut off but turn on joints. New
// bodies get `generation` (see BodyId). Appends the change to `delta`, and wakes the changed bodies.
//
// Precondition: no search for separated pieces is unfinished. O(pieces) if no piece was cut off.
void release_pieces(World& world, uint32_t generation, Delta& delta);

// Returns true if this body has a piece that would become a separate body. O(pieces).
bool has_pieces_off(const Body& body);

inline constexpr double kPushApart = 0.03;  // m/s, proportionally less for bodies smaller than a metre

}  // namespace kerf
