#pragma once

#include <array>

#include "core/cut/stroke_region.h"

namespace kerf {

// Whether a single chord across a triangle fails to approximate the boundary of the region: the chord would
// deviate from it by more than `chord`, an edge crosses it more than once, or the region reaches into the
// triangle although no corner is inside. Parts that reach across the boundary by less than `graze` are
// ignored. `at` is the triangle of `face`, and `distances` are the signed distances of its corners, negative
// inside and zero on the boundary; all in metres.
bool chord_fails(const StrokeRegion& region, FaceId face, const Triangle& at,
                 const std::array<double, 3>& distances, double chord, double graze);

}  // namespace kerf
