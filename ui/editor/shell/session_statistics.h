#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ui/editor/shared/statistics.h"
#include "ui/editor/shared/workspace.h"
#include "ui/window/layout.h"
#include "ui/window/status_message.h"

namespace kerf {

// Updates the statistics of the panels and the status bar.
void bring_up_to_date(Workspace& workspace);

// A report of the session: frame times (frames, frame_ms, between_pictures_ms, while_cutting), memory
// (process_bytes, memory_bytes as the Statistics panel shows it), the work (strokes, faces, faces_removed,
// removed_area, last_stroke, pieces, recuts, bodies, placements), and the message, messages and layout of the
// window. Features add what they know.
nlohmann::ordered_json session_report(const Workspace& workspace);

// Draws what the left button does (`button`), the message and the statistics of the world into the status
// bar. A message that does not fit can be read in its tooltip. Returns whether the message was clicked.
bool draw_status_bar(const Area& area, const char* button, const Message& message,
                     const ShownStatistics& shown);

}  // namespace kerf
