#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ui/editor/shared/statistics.h"
#include "ui/editor/shared/workspace.h"
#include "ui/window/layout.h"
#include "ui/window/status_message.h"

namespace kerf {

// Updates the statistics of the panels and the status bar.
void bring_up_to_date(Workspace& workspace);

// Returns the report of the session: frame times (frames, frame_ms, between_pictures_ms, while_cutting),
// memory (process_bytes, memory_bytes as in the Statistics panel), the work (strokes, faces, faces_removed,
// removed_area, last_stroke, pieces, recuts, bodies, placements), and the message, messages and layout of
// the window. Features add their own entries.
nlohmann::ordered_json session_report(const Workspace& workspace);

// Draws the action of the left button (`button`), the message and the statistics of the world into the
// status bar. A clipped message has a tooltip with its full text. Returns true if the message was clicked.
bool draw_status_bar(const Area& area, const char* button, const Message& message,
                     const ShownStatistics& shown);

}  // namespace kerf
