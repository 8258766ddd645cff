#pragma once

#include "core/tree/swept_cylinder.h"
#include "core/tree/tree_store.h"

namespace kerf {

// An oriented box that contains the part of a swept volume within the tree, in the frame of the tree and
// widened by all rounding errors, so that no face that touches the volume is culled. Axis 0 is the direction
// of the beam, 1 that of its motion and 2 the one across both. The volume is in the frame of the mesh.
// Precondition: the tree has a root.
SlabQuery beam_slab(const TreeStore& tree, const SweptCylinder& beam);

}  // namespace kerf
