#pragma once

#include "ui/editor/welcome/tour.h"
#include "ui/window/layout.h"

namespace kerf {

enum class TourMove { kNone, kBack, kOn, kEnd };

// Draws the step of a tour as a card with a frame around what it points at, and returns what the user wants.
// `part` is where that is; nothing where it is the picture, or is not seen at the moment.
TourMove draw_tour_card(const Tour& tour, const Area& picture, const std::optional<Area>& part);

}  // namespace kerf
