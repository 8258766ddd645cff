#pragma once

#include <optional>

#include "core/world/spring.h"
#include "ui/editor/shared/view_state.h"

namespace kerf {

// A spring, without tension, on the point of a visible piece that is seen at a place of the first half of the
// picture (screen coordinates). Nothing where nothing is seen, or where the body is pinned.
std::optional<Spring> spring_at(const World& world, const ViewState& view, Vec2 place);

// Moves the far end of the spring under a place of the first half, in the plane through where it is that
// faces the camera.
void stretch(Spring& spring, const ViewState& view, Vec2 place);

}  // namespace kerf
