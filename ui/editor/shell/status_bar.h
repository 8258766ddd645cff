#pragma once

#include "ui/editor/shared/statistics/statistics.h"
#include "ui/window/layout.h"
#include "ui/window/message.h"

namespace kerf {

// Draws what the left button does (`button`), the message and the statistics of the world into the status
// bar. A message that does not fit can be read in its tooltip. Returns whether the message was clicked.
bool draw_status_bar(const Area& area, const char* button, const Message& message,
                     const ShownStatistics& shown);

}  // namespace kerf
