#pragma once

#include "core/tree/float_box.h"
#include "core/tree/tree_nodes.h"

namespace kerf {

// Makes a node without parent and children.
void make_empty(WideNode& node);

// Sets the box of a slot. Precondition: slot < kNodeWidth.
void set_slot_box(WideNode& node, uint32_t slot, const FloatBox& box);

}  // namespace kerf
