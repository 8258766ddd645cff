#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/geometry.h"

namespace kerf {

// A triangle of a diagram of the 1-to-4 split, in the plane.
struct DiagramTriangle {
  std::array<Vec2, 3> corners;
  bool hit = false;  // the beam meets it
  bool removed = false;
  std::optional<Vec2> bisected;  // where the closure halves it: the midpoint of the edge opposite a corner
  size_t corner = 0;             // that corner
};

// How the scheme of the paper cuts an equilateral triangle with a beam, stage by stage: the triangle; its
// four parts; the parts of what was hit again; and what is left when what was hit is removed. Made by
// OneToFour, so that the neighbours of parts that are split are closed as in every mesh.
std::vector<std::vector<DiagramTriangle>> split_stages(const Vec2& beam, double radius);

// The corners of the triangle that is cut.
std::array<Vec2, 3> diagram_triangle();

// Draws the stages beside each other with the current ImGui context, over the whole picture.
void draw_split_diagram();

}  // namespace kerf
