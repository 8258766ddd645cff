#pragma once

#include "core/document/history/single_step.h"
#include "ui/render/bodies/stage_marks.h"

namespace kerf {

// What is drawn of a stage that was just executed: the volumes that the beam sweeps, the faces that it
// touches, the faces that were made and those that were removed. Linear in these faces.
StageMarks mark_stage(const World& world, const StageRecord& stage);

}  // namespace kerf
