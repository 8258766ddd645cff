#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/world/world.h"
#include "ui/editor/shared/viewport.h"

namespace kerf {

// A circle fitted to points.
struct FittedCircle {
  Vec3 centre{0}, normal{0, 0, 1};  // m; the normal is a unit vector
  double radius = 0;                // m
  double deviation = 0;             // m, the largest distance of a point from the circle
};

// Fits a circle to a closed polygon. The plane passes through the centroid of the edges, perpendicular to the
// area vector of the polygon (Newell), which no spacing of the points tilts. In it, Gauss-Newton steps from
// an algebraic fit (Kasa, 1976) minimise the squared distances from the circle, weighted by the lengths of
// the adjacent edges, so that finely divided stretches count no more than others. Returns nullopt for fewer
// than three points, or if they enclose no area or lie on a line. O(points).
std::optional<FittedCircle> fit_circle(std::span<const Vec3> polygon);

// Returns the rims of a body as polygons in its own frame: loops of edges with one face, of edges between a
// wall and another face, and the boundaries of smooth parts of the surface, which end at sharp edges (see
// kCreaseCosine). A loop of sharp edges is listed for both of its sides. O(edges).
std::vector<std::vector<Vec3>> rims_of(const Body& body);

// Returns the rim whose visible edge is nearest to a place of the window, in world space, and of several
// along that edge the roundest; nullopt if none is within reach. O(edges of all visible bodies).
std::optional<std::vector<Vec3>> rim_at(const World& world, const ViewState& view, Vec2 place);

}  // namespace kerf
