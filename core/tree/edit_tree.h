#pragma once

#include <span>

#include "core/mesh/replacement.h"
#include "core/tree/tree_store.h"

namespace kerf {

// Edits of a tree in place. None looks further than the records that it changes and those above them.

// The leaves of `gone` make way for leaves of `born` in the block of the first of them. A block that
// overflows parts in two; where its node is full, the two get a node of their own in its slot. Boxes above
// grow where they must.
void replace_faces(TreeStore& tree, const Mesh& mesh, std::span<const FaceId> gone,
                   std::span<const FaceId> born);
// The same for many in their order, asking for the memory of those that come next.
void replace_faces(TreeStore& tree, const Mesh& mesh, std::span<const Replacement> all);

// Takes a leaf away; a block or node without children goes with it, a node with one child makes way for it,
// and boxes above shrink up to the first that stays as it is.
void remove_face(TreeStore& tree, FaceId f);

// Fits the leaf anew and grows the boxes above it.
void refit_face(TreeStore& tree, const Mesh& mesh, FaceId f);

}  // namespace kerf
