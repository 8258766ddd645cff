#pragma once

#include "core/mesh/files/file_frame.h"
#include "ui/editor/prepare/live_preview.h"

namespace kerf {

// Draws the switch of the preview and, while it is on, the statistics before and after: faces, least angle
// and the distance of the two surfaces. `why_not`: why there is no preview, or null.
void draw_preview(const LivePreview& preview, const char* why_not, FileUnit unit, bool& previewed);

}  // namespace kerf
