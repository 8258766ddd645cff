#pragma once

#include <vector>

#include "core/world/world.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/view_options.h"

struct ImDrawList;

namespace kerf {

// A box that is drawn with the mouse to choose pieces, as in CAD programs: drawn from left to right it
// chooses the pieces that lie wholly in it, from right to left also those that it touches. What is in front
// of a piece does not matter.
struct RubberBand {
  Vec2 from{0}, to{0};
  bool touching() const { return to.x < from.x; }
  Vec2 low() const { return glm::min(from, to); }
  Vec2 high() const { return glm::max(from, to); }
};

// The pieces that a box chooses, among those that are shown, where they are drawn. Its corners are points of
// the picture, as in CameraView::ray. Faces behind the eye are outside. O(n) in the number of faces.
std::vector<PieceId> pieces_in(const RubberBand& band, const World& world, const ViewOptions& look,
                               const CameraView& view);

// Draws the box; its corners are in screen coordinates of the window. One that touches is dashed.
void draw_rubber_band(const RubberBand& band, ImDrawList& list);

}  // namespace kerf
