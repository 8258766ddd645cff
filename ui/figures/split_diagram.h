#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/geometry.h"

namespace kerf {

// A triangle of a diagram of the 1-to-4 split, in the plane.
struct DiagramTriangle {
  std::array<Vec2, 3> corners;
  bool hit = false;  // the beam intersects it
  bool removed = false;
  // midpoint of the edge opposite `corner`, if the closure bisects the triangle
  std::optional<Vec2> bisected;
  size_t corner = 0;  // the corner that the bisection starts from
};

// Returns the stages in which the paper's scheme cuts an equilateral triangle with a beam: the triangle;
// its four parts; the parts of the hit triangles; and the remainder without the hit triangles. Uses
// OneToFour, so the neighbours of split parts are closed as in every mesh.
std::vector<std::vector<DiagramTriangle>> split_stages(const Vec2& beam, double radius);

std::array<Vec2, 3> diagram_triangle();

// Draws the stages side by side with the current ImGui context, over the whole image.
void draw_split_diagram();

}  // namespace kerf
