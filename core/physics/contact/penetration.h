#pragma once

#include <optional>

#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"
#include "core/world/rigid_body.h"

namespace kerf {

// The plane of a face that a ray hits.
struct FacePlane {
  Vec3 at{0};      // intersection point
  Vec3 normal{0};  // unit, towards the origin of the ray
  double distance_to(const Vec3& p) const { return glm::dot(p - at, normal); }
};

// Returns the plane of the first face along a ray of this length, in the frame of the body; nullopt on a
// miss or if the face has no area. Precondition: the direction is a unit vector.
std::optional<FacePlane> face_along(const MovingBody& faces, const Vec3& from, const Vec3& direction,
                                    double length);
// Returns the plane of the first face between two points; nullopt likewise, or if the points are equal.
std::optional<FacePlane> face_between(const MovingBody& faces, const Vec3& from, const Vec3& to);

// Numbers of points within fine chords, which are tracked like the points of the collider while they touch.
// Such a point is added if the middle of a chord hits a face, e.g. if the edge of a plate lies on a pipe.
// PointMemory::point encodes kOnChord, the chord and the position along the chord in one number.
inline constexpr uint32_t kOnChord = 1u << 30;
inline bool is_on_chord(uint32_t point) { return point >= kOnChord; }
// Flag of points where a chord hit the rim of a sheet, e.g. if two sheets in one plane meet edge to edge.
// Their stored normal is opposite to the motion that brought the sheets together, in the plane of the other
// sheet or across it.
inline constexpr uint32_t kAtRim = 1u << 29;
inline bool is_at_rim(uint32_t point) { return is_on_chord(point) && (point & kAtRim) != 0; }

// Returns the point with this number, of the collider or within one of its chords; the latter has no normal
// and no outward direction.
Collider::Point point_of(const Collider& collider, uint32_t point);

// Returns the chord on which a point lies. Precondition: is_on_chord(point).
const Collider::Chord& chord_of(const Collider& collider, uint32_t point);

// Adds to `memory`, of the points of `points` on `faces`, the guards that hit faces of the other body during
// the tick.
void remember_passing_guards(const MovingBody& points, const MovingBody& faces,
                             std::vector<PointMemory>& memory);

// Adds to `memory`, of the points of `chords` on `faces`, the points within chords of one body that pass
// through faces of the other between MovingBody::now and MovingBody::next. Returns true if any new point is
// at a rim.
bool remember_piercing_points(const MovingBody& chords, const MovingBody& faces,
                              std::vector<PointMemory>& memory);

// Finds the contacts of the points of one body with the faces of another, and updates `memory`, that of the
// points of `points` on `faces`.
//
// In the frame of the faces, casts rays from each point along its way within the tick, against the normal of
// its last contact, and along its own normal. Since no sheets intersect at the beginning of a tick (see
// limit_penetration), a point is then on its correct side. Appends to `out`, with normals towards `points`
// and features below 2^32.
void find_point_contacts(const MovingBody& points, const MovingBody& faces, const ContactLengths& lengths,
                         std::vector<PointMemory>& memory, std::vector<Contact>& out);

// Returns true if a chord of one of two bodies passes through a face of the other at the beginning of a tick.
// This detects intersecting sheets in general, because the line in which two open surfaces intersect ends at
// a rim of one of them.
bool sheets_cross(const MovingBody& a, const MovingBody& b);

// Returns true if two bodies that were apart at the beginning of a tick intersect, or have passed through
// each other, at MovingBody::next: if a chord of one passes through a face of the other, or a point of one
// hits a face of the other during the tick.
bool pass_through(const MovingBody& a, const MovingBody& b);

// Returns the contact that separates two bodies whose sheets intersect, or nullopt if that would take too
// long. It lies in the middle of the places where chords pass through faces. It pushes along the shortest
// displacement that moves all points of one body past the plane of a face at such a place, or the points of
// both bodies to different sides of a plane. From its overlap, the solver moves the bodies apart at kPushOut
// at most, without giving them velocity (split impulses).
//
// A pair that has intersected for kMaxPush (PairMemory::crossed) is no longer pushed, nor is a pair that
// overlaps by more than kDeepestPush. `memory` stores the direction, so that it does not alternate. O(points
// * places).
std::optional<Contact> push_out(const MovingBody& first, const MovingBody& second, PairMemory& memory);

inline constexpr double kPushOut = 0.06;      // m/s
inline constexpr double kDeepestPush = 0.12;  // m
inline constexpr double kMaxPush = 4;         // s
inline constexpr double kSolvedShare = 0.2;   // share of an overlap that the solver removes in a tick

}  // namespace kerf
