#pragma once

#include "core/world/world.h"

namespace kerf {

// Computes the area and the moments of every piece of a body anew from its faces, in place of the sums that
// its edits have kept up, whose last digits depend on the order of these edits. The new sums are taken in
// fixed point and rounded once, so that they are a function of the faces alone, whatever their order and
// slots. A piece that is detached afterwards has the same sums as if it were weighed itself. Changes only
// what differs. A search for separated pieces may be open. Of a solid body it also finds the pieces that are
// closed, and their volumes (see Body::enclosed). O(faces + pieces).
void weigh(Body& body);

}  // namespace kerf
