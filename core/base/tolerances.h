#pragma once

namespace kerf {

// All tolerances of core, each with its derivation. None is a length in metres: each is relative to a
// quantity that its comment names, so that the size and the position of a mesh do not matter.

// Directions ------------------------------------------------------------------------------------------------

// A vector or quaternion whose squared length differs from 1 by less than this counts as of unit length.
// Files print numbers so that they are read back exactly; ten digits written by hand err by less than 2e-10.
inline constexpr double kUnitSlack = 1e-9;

// Two unit directions whose sum is shorter than this count as opposite. The direction between them is their
// normalised sum, whose error is that of rounding, 1e-16, divided by its length: it stays below 1e-7.
inline constexpr double kOpposite = 1e-9;

// A beam whose motion has a smaller share than this across its axis moves along it. The rest that rounding
// leaves there, 1e-16 of the motion or the error of a unit direction, has any direction, even that of the
// axis; at a larger share, the direction of the motion is perpendicular to the axis within 1e-11.
inline constexpr double kMinSideways = 0x1p-16;

// Loading ---------------------------------------------------------------------------------------------------

// A closed part of a mesh has a volume if the sum of its signed terms exceeds this fraction of the sum of
// their bounds. Rounding is at worst 1.2e-10 of that for a million terms, and near 1e-13 in practice; a plate
// whose thickness is a millionth of its width exceeds the value by a factor of a thousand.
inline constexpr double kMinVolume = 1e-10;

// Looks -----------------------------------------------------------------------------------------------------

// A point whose barycentric coordinate for a corner of a loaded face is below this counts as on the side
// opposite to that corner. UVs and normals then err by at most this fraction of their range, a thousandth of
// the error that tests accept.
inline constexpr double kOnLoadedSide = 1e-9;
// Distance of a point on a side from it, relative to the coordinates: splits at midpoints round each of them
// by 2^-53, at most 24 times on the way to the deepest level.
inline constexpr double kSideRoundings = 0x1p-48;

// Culling by boxes ------------------------------------------------------------------------------------------
//
// Floats and boxes only cull; exact or double tests decide. These bounds must therefore never be too small; a
// bound that is several times too large only costs a few needless triangle tests.

// Slack of a box test in double, relative to the largest number in it. A dot product of three terms in double
// errs by less than 4e-16 of that; this is 25 times as much.
inline constexpr double kBoxSlack = 1e-14;

// Maximum distance of a float in a tree from the double that it was rounded from: kFloatSlack relative to
// itself plus kFloatLeast near zero. Rounding errs by 2^-24 of the number, or by less than the smallest
// normal float; four times that leaves a margin for sums of a few such errors.
inline constexpr float kFloatSlack = 0x1p-22f;
inline constexpr float kFloatLeast = 0x1p-126f;

// Rounding errors of single precision, relative to the extent of the inputs, in multiples of 2^-24.
inline constexpr double kProjectionRoundings = 0x1p-19;  // projection of a box: fewer than 32 operations
inline constexpr double kPlaneRoundings =
    0x1p-18;  // intersection of a ray and a plane: fewer than 48 operations
inline constexpr double kShearedRoundings = 0x1p-21;  // sheared coordinate of a corner or a ray: up to 8
inline constexpr float kEdgeRoundings = 0x1p-21f;   // edge function, relative to the extent squared: up to 8
inline constexpr float kSlopeRoundings = 0x1p-20f;  // reciprocal of a direction's component: up to 16

// Smallest component of a ray's unit direction. Smaller ones are replaced by it, because the reciprocal must
// be finite and stay so when multiplied by coordinates of the tree, which are below 2^7.
inline constexpr float kMinComponent = 1e-20f;

// Smallest parameter of a ray at which boxes count, relative to the extent of the tree. It is positive
// because the bit patterns of positive floats compare like the floats themselves.
inline constexpr double kMinRayParameter = 1e-30;

// Centroids of a range whose extent along an axis is smaller than this, in the frame of the tree, count as
// one point: dividing by it would overflow. Bins are scaled by kBinScale, slightly less than 1, so that the
// largest centroid falls into the last bin despite rounding.
inline constexpr float kMinSpread = 1e-34f;
inline constexpr float kBinScale = 0.9999f;

// Separation ------------------------------------------------------------------------------------------------

// Parts whose areas differ by less than this fraction of the area of their component count as equally large.
// The area of a component is kept as a running sum from which each removed face is subtracted; after a
// million edits its error is about 1e-10 of the initial sum.
inline constexpr double kEqualArea = 1e-9;

// The knife -------------------------------------------------------------------------------------------------

// A vertex lies on the plane of a knife if its computed distance is at most this fraction of the bound of the
// terms that it is a sum of. Rounding errs by at most 2^-51 of that bound, so the sign of a smaller distance
// is unknown; a larger one keeps the split point of an edge apart from its ends.
inline constexpr double kOnKnife = 0x1p-50;

// The smooth rim --------------------------------------------------------------------------------------------
// Lengths are relative to the radius of the beam. Together they keep the rim within 0.005 radii of the exact
// boundary of the swept volume, as the tests require.

// Largest distance of a chord of the rim from the boundary: that of a regular polygon with 64 sides.
inline constexpr double kRimChord = 0.0012;
// Largest distance of a chord after a vertex was moved onto the boundary. A longer chord is acceptable,
// because a face cut off close to a vertex would be a sliver; the value is below the bound.
inline constexpr double kRimMovedChord = 0.0045;
// A face that reaches across the boundary by less than this between its corners is not split for it. It is
// slightly larger than kRimChord, so that the faces on the other side of an accepted chord are not split for
// it. Also applies after a vertex was moved twice.
inline constexpr double kRimGraze = 0.0015;
// A vertex this near the boundary lies on it. Smaller than kRimChord, so that the sum is below the bound.
inline constexpr double kRimOn = 0.001;
// A vertex this near the boundary that must not move counts as lying on it: the bound itself.
inline constexpr double kRimNear = 0.005;
// Faces whose longest edge is shorter than this are not split for the rim: the sagitta of such a chord is
// 3e-5, far below kRimChord, so a failure is not one of resolution and splitting could not end.
inline constexpr double kRimLeastEdge = 1.0 / 64;

// The remaining values are relative to the length of the edge that crosses the boundary, or of the shorter
// edge at the vertex. A vertex nearer to the boundary than kRimSnap may move onto it: cutting the edge
// instead would leave an angle of about atan(1/4), 14 degrees. If it may not move and is nearer than
// kRimSliver, which would leave less than 7 degrees, the faces around it are split so that it may.
inline constexpr double kRimSnap = 0.25;
inline constexpr double kRimSliver = 0.12;

// Cosine of one degree: moving a vertex must not tilt a face by more, to keep the shape of the surface.
inline constexpr double kRimLargestTurn = 0.99984769515639127;

// Cosine of ten degrees: moving a vertex may always leave a face whose smallest angle is larger. Smaller
// angles are accepted only if cutting the edge would leave about the same.
inline constexpr double kRimGoodAngle = 0.98480775301220806;

// Two parts of one base face are coplanar if the cosine of the angle between them is at least this. It
// corresponds to 1.4e-6 rad, which exceeds the tilt that rounding of split points causes unless the faces are
// extremely thin; flipping an edge between faces that are not coplanar would change the surface.
inline constexpr double kCoplanar = 1 - 1e-12;

// An edge is flipped only if the cosine of the smallest angle decreases by more than this. A positive bound
// makes the sequence of flips finite, and smaller gains are not visible.
inline constexpr double kMinFlipGain = 1e-3;

}  // namespace kerf
