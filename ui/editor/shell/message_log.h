#pragma once

#include "ui/window/message.h"

namespace kerf {

// Draws the window that lists what the status bar has said, the latest first, while `shown`; its button
// closes it.
void draw_message_log(bool& shown, const Message& message);

}  // namespace kerf
