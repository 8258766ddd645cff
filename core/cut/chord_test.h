#pragma once

#include <array>

#include "core/cut/stroke_region.h"

namespace kerf {

// Whether cutting a triangle of `face` along one chord would not be true to the boundary of the region: the
// chord would leave it, an edge crosses it more than once, or the beam passes where no corner is inside.
// `distances` are those of the corners, negative inside, zero on the boundary; `chord` is how
// far the chord may be off, `graze` how far across the boundary the face may reach unseen (m).
bool chord_fails(const StrokeRegion& region, FaceId face, const Triangle& at,
                 const std::array<double, 3>& distances, double chord, double graze);

}  // namespace kerf
