#pragma once

#include "core/base/ids.h"
#include "core/base/pose.h"
#include "core/world/placement.h"

namespace kerf {

class Fields;

// The fields that many commands and marks have in common.
void describe(Fields& f, Pose& pose);            // "origin" and "direction", which is a unit vector
void describe(Fields& f, Placement& placement);  // "position" and "orientation"
// "piece": [slot, generation, label]; or [number, label], as journals had it before bodies had generations.
void piece_field(Fields& f, PieceId& piece);

}  // namespace kerf
