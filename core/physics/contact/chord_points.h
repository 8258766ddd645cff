#pragma once

#include "core/physics/contact/moving_body.h"
#include "core/world/contact_memory.h"

namespace kerf {

// Points within fine chords that are followed like those of the collider while they touch. They are made
// where the middle of a chord met a face, as where the edge of a plate lies on a pipe. PointMemory::point
// says which they are: kOnChord, the chord and the place along it in one number.
inline constexpr uint32_t kOnChord = 1u << 30;
inline bool is_on_chord(uint32_t point) { return point >= kOnChord; }
// Marks the points where a chord met the rim of a sheet, as where two sheets in one plane meet edge on.
// Their remembered normal is opposite to the motion that made the sheets meet, in the plane of the other
// sheet or across it.
inline constexpr uint32_t kAtRim = 1u << 29;
inline bool is_at_rim(uint32_t point) { return is_on_chord(point) && (point & kAtRim) != 0; }

// A point of the collider or within a chord of it. Of the latter, no directions are known.
Collider::Point point_of(const Collider& collider, uint32_t point);

// The chord that a point lies within. Precondition: is_on_chord(point).
const Collider::Chord& chord_of(const Collider& collider, uint32_t point);

// Adds the guards of one body that meet faces of the other on their way to `memory`, which is that of the
// points of `points` on `faces`.
void remember_passing_guards(const MovingBody& points, const MovingBody& faces,
                             std::vector<PointMemory>& memory);

// Adds the points within chords of one body that go through faces of the other on the way from `now` to
// `next` to `memory`, which is that of the points of `chords` on `faces`. Returns whether points at rims are
// among those that are new.
bool remember_piercing_points(const MovingBody& chords, const MovingBody& faces,
                              std::vector<PointMemory>& memory);

}  // namespace kerf
