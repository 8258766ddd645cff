#pragma once

#include <optional>

#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"
#include "core/world/rigid_body.h"

namespace kerf {

// The plane of a face that a ray met.
struct FacePlane {
  Vec3 at{0};      // where the ray met it
  Vec3 normal{0};  // unit, towards where the ray came from
  double distance_to(const Vec3& p) const { return glm::dot(p - at, normal); }
};

// The plane of the first face along a ray of this length, in the frame of the body. Nothing where the face
// has no area. Precondition: the direction is a unit vector.
std::optional<FacePlane> face_along(const MovingBody& faces, const Vec3& from, const Vec3& direction,
                                    double length);
// The plane of the first face between two points. Nothing where it has no area or the points are equal.
std::optional<FacePlane> face_between(const MovingBody& faces, const Vec3& from, const Vec3& to);

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

// Finds the contacts of the points of one body with the faces of another, and brings what is known of the
// points up to date. `memory` is that of the points of `points` on `faces`.
//
// In the frame of the faces, rays go from each point along its way within the tick, against the normal that
// it last met, and along its own normal. Since no sheets intersect at the beginning of a tick (see
// hold_back), a point is on its right side then. Appends to `out`, with normals towards `points` and features
// below 2^32.
void find_point_contacts(const MovingBody& points, const MovingBody& faces, const ContactLengths& lengths,
                         std::vector<PointMemory>& memory, std::vector<Contact>& out);

}  // namespace kerf
