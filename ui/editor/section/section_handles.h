#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/editor/section/section_drag.h"
#include "ui/editor/shared/view_state.h"

struct ImDrawList;

namespace kerf {

// Handles of the section plane, in the first half of the picture, while it cuts: an arrow along its normal
// that moves it, and a half ring about each of its axes that turns it about its point. They are as large at
// every distance. Places are of the window, screen coordinates.
struct SectionHandle {
  SectionDrag::Kind kind = SectionDrag::Kind::kMove;
  std::vector<Vec3> points;  // m: the ends of the arrow, or points of the half of a ring that is in front
  std::vector<Vec2> places;  // of the points
};

// The handles; none where the plane does not cut, or where its point is behind the eye.
std::vector<SectionHandle> section_handles(const ViewState& view);

// What a press of the left button at a place begins, if there is a handle.
std::optional<SectionDrag> section_drag_at(const ViewState& view, Vec2 at);

// The name of a handle, as tests know it: "section move", "section tilt", "section swing".
std::string name_of(const SectionHandle& handle);
// The place of a handle that its name stands for.
Vec2 grip_of(const SectionHandle& handle);

// Draws the frame of the plane around a world with these bounds, and the handles; `pointer` is where it is
// over the picture, `dragged` what it drags.
void draw_section(const ViewState& view, const World::Bounds& bounds, std::optional<Vec2> pointer,
                  const std::optional<SectionDrag>& dragged, ImDrawList& list);

}  // namespace kerf
