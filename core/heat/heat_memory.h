#pragma once

#include "core/heat/heat_step.h"

namespace kerf {

// Working memory of conduct(), so that a tick of heat allocates nothing once it has grown.
struct HeatMemory {
  HeatRegion::Memory region;
  HeatStep::Memory step;
};

}  // namespace kerf
