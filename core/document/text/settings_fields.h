#pragma once

#include "core/cut/cut_step.h"

namespace kerf {

class Fields;

// The settings of a stroke with everything that the result of its cut depends on. Keys that did not exist
// from the beginning are written where their value differs from what Kerf did before.
void describe(Fields& f, CutSettings& s);

}  // namespace kerf
