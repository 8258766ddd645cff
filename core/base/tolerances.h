#pragma once

namespace kerf {

// All tolerances of Kerf. None is a length: each is relative to the numbers that it guards.

// Slack of a box test, relative to the largest number in it. A dot product of three terms in double errs by
// less than 4e-16 of them; boxes only cull, so a little more costs a few needless triangle tests and no more.
inline constexpr double kBoxSlack = 1e-14;

// Parts whose areas differ by less than this share of the component that they came from count as equal: the
// area of a component is kept as a sum, from which each face takes its own when it goes.
inline constexpr double kEqualArea = 1e-9;

// A smooth rim, relative to the radius of the beam. A chord of the rim lies this near the boundary; what
// reaches this far across it is not cut; a vertex this near it is on it; the radius that looks for neighbours
// is this much larger.
inline constexpr double kRimChord = 0.0012;
inline constexpr double kRimMovedChord = 0.0045;  // where a vertex moves onto the boundary
inline constexpr double kRimGraze = 0.0015;
inline constexpr double kRimOn = 0.001;
inline constexpr double kRimNear = 0.005;          // so near a vertex that may not move counts as on it
inline constexpr double kRimLeastEdge = 1.0 / 64;  // faces smaller than this are not split for the rim's sake

// Share of its edges that lies between a vertex and the boundary: below the first the vertex moves where it
// may, below the second faces are split so that it may.
inline constexpr double kRimSnap = 0.25;
inline constexpr double kRimSliver = 0.12;

}  // namespace kerf
