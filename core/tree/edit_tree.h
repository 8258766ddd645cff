#pragma once

#include <span>

#include "core/mesh/replacement.h"
#include "core/tree/tree_store.h"

namespace kerf {

// Edits of a tree in place. Each accesses only the records that it changes and their ancestors. See AabbTree
// for the preconditions.

// Replaces the leaves of `gone` by leaves of `born`, which go into the block of the first face of `gone`. A
// block that overflows is split in two; if its node is full, the two halves get a new node in its slot. Boxes
// above are enlarged where necessary.
void replace_faces(TreeStore& tree, const Mesh& mesh, std::span<const FaceId> gone,
                   std::span<const FaceId> born);
// Makes all replacements in their order and prefetches the records of the following ones.
void replace_faces(TreeStore& tree, const Mesh& mesh, std::span<const Replacement> all);

// Adds a leaf to the block that is found by following, from the root, the box that grows least in area.
// Preconditions: the face is not in the tree, and the tree is not empty.
void add_face(TreeStore& tree, const Mesh& mesh, FaceId f);

// Removes a leaf. A block or a node that becomes empty is removed as well, a node with a single child is
// replaced by that child, and the boxes above shrink up to the first that does not change.
void remove_face(TreeStore& tree, FaceId f);

// Updates the leaf of a face whose corners have moved and enlarges the boxes above it.
void refit_face(TreeStore& tree, const Mesh& mesh, FaceId f);

}  // namespace kerf
