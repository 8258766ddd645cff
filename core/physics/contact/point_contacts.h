#pragma once

#include "core/physics/contact/contact.h"
#include "core/physics/contact/moving_body.h"

namespace kerf {

// Finds the contacts of the points of one body with the faces of another, and brings what is known of the
// points up to date. `memory` is that of the points of `points` on `faces`.
//
// In the frame of the faces, rays go from each point along its way within the tick, against the normal that
// it last met, and along its own normal. Since no sheets intersect at the beginning of a tick (see
// hold_back), a point is on its right side then. Appends to `out`, with normals towards `points` and features
// below 2^32.
void find_point_contacts(const MovingBody& points, const MovingBody& faces, const ContactLengths& lengths,
                         std::vector<PointMemory>& memory, std::vector<Contact>& out);

}  // namespace kerf
