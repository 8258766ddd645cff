#pragma once

#include <map>
#include <string>

#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Adds, for each face that the beam removed from a body, one to the count of what it belonged to: the
// outermost part of its mesh file that is not all of the mesh ("wheel_front_left"), else the piece ("sphere
// 2"). The world is the one after the step of the delta. O(removed faces + parts times base faces removed).
void count_cut_names(const World& world, const BodyDelta& delta, std::map<std::string, size_t>& names);

}  // namespace kerf
