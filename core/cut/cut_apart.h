#pragma once

#include <span>

#include "core/cut/cut_step.h"

namespace kerf {

// Executes moves of the beam through one body as cut_body does, but leaves parts that joints do not hold any
// more for the next call of go_on_separating(): for callers that cut many bodies between two ticks. Fails
// like cut_step. Precondition: the body is not hidden.
Result<StepResult> cut_apart(World& world, const CutSettings& settings, BodyId id,
                             std::span<const BeamMove> moves);

}  // namespace kerf
