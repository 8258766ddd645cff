#pragma once

#include "core/physics/contact/moving_body.h"

namespace kerf {

// Whether a chord of one of two bodies goes through a face of the other at the beginning of a tick. Sheets
// that intersect do so as a rule: the line in which two surfaces meet ends at a rim of one of them.
bool sheets_cross(const MovingBody& a, const MovingBody& b);

// Whether two bodies that were apart at the beginning of a tick intersect, or went through each other, when
// they have moved on to MovingBody::next: whether a chord of one goes through a face of the other, or a point
// of one met a face of the other on its way.
bool get_through(const MovingBody& a, const MovingBody& b);

}  // namespace kerf
