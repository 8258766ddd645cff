#pragma once

#include <string>

#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Why a stroke left a solid body open, for the user, with the name of the body: "car: ...". The world is the
// one after the step.
std::string left_open_text(const LeftOpen& open, const World& world);

}  // namespace kerf
