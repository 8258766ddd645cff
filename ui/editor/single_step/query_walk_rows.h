#pragma once

#include "ui/editor/single_step/stage_log.h"

namespace kerf {

// Rows of the Tree panel: the last query of the tree in single steps, walked through box by box with a
// slider.
void draw_query_walk(StageLog& stages);

}  // namespace kerf
