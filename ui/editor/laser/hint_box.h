#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>

#include "core/world/world.h"
#include "ui/editor/shared/picture/view_state.h"
#include "ui/window/layout.h"

namespace kerf {

// The corners of a box of the world as they are seen in a picture, in screen coordinates; nothing where one
// of them lies behind the eye.
std::optional<std::array<Vec2, 8>> seen_corners(const World::Bounds& bounds, const CameraView& view,
                                                const Area& picture);

// Whether an area meets the convex hull of some points, by the separating axis theorem: two convex sets that
// are disjoint are disjoint along a normal of an edge of one of them. Precondition: there is a point.
bool meets_hull(const Area& area, std::span<const Vec2> points);

// A place for a box of this size along the edges of a picture where `is_free`: at the bottom if possible,
// otherwise at the top; in the middle if possible, otherwise at the left or right. `margin`: to the edges of
// the picture. Nothing if there is no such place.
std::optional<Area> free_place(const Area& picture, Vec2 size, double margin,
                               const std::function<bool(const Area&)>& is_free);

// Draws the hints of a first visit where they cover neither the world nor the axes nor `taken`, or not at
// all.
void draw_hint_box(const World& world, const ViewState& view, const Area& taken);

}  // namespace kerf
