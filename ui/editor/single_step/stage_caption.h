#pragma once

#include "ui/editor/single_step/stage_log.h"
#include "ui/window/layout.h"

namespace kerf {

// Draws what the last stage of single steps did, in words, at the lower edge of a picture. Draws nothing if
// no stage was executed.
void draw_stage_caption(const StageLog& stages, const Area& picture);

}  // namespace kerf
