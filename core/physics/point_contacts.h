#pragma once

#include "core/physics/contact.h"
#include "core/physics/moving_body.h"
#include "core/world/contact_memory.h"

namespace kerf {

// Finds the contacts of the points of one body with the faces of another, and brings what is known of the
// points up to date. `memory` is that of the points of `points` on `faces`.
//
// Each point is followed in the frame of the faces. A ray from where it was free to where it is tells whether
// it went through a face; then the face pushes it back to its side. Otherwise rays along its way, along the
// normal that it last met and along its own normal find the faces that are near. Appends to `out`, with
// normals towards `points` and features below 2^32.
void find_point_contacts(const MovingBody& points, const MovingBody& faces, const ContactLengths& lengths,
                         std::vector<PointMemory>& memory, std::vector<Contact>& out);

}  // namespace kerf
