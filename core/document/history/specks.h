#pragma once

#include <set>

#include "core/document/history/document.h"

namespace kerf {

// A speck is a piece that was smaller than this share of the beam's cross-section when it came off. Slow
// strokes that melt their way leave many at the rim, which nobody means by a piece.
inline constexpr double kSpeckShare = 0.125;
// Whether a piece of this area (m^2) that a beam of this radius (m) cuts off is one.
bool is_speck(double area, double radius);

// The specks among the pieces that a step of such a beam made, which led to this world.
std::set<PieceId> new_specks(const World& world, const Delta& delta, double radius);

// The specks that have faces. O((s + d) log s) in the specks and detached pieces of all steps.
std::set<PieceId> specks(const Document& document);

}  // namespace kerf
