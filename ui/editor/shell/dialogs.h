#pragma once

#include <array>
#include <span>
#include <string>

#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/user_input.h"
#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/catalogue.h"
#include "ui/editor/shell/settings_page.h"
#include "ui/window/status_message.h"
#include "ui/window/window.h"

namespace kerf {

// Draws the message log, latest first, while `shown`; its button closes it.
void draw_message_log(bool& shown, const Message& message);

// The window that lists all gestures and keys, grouped by menu, with a search field.
struct ShortcutSheet {
  bool shown = false;
  std::array<char, 64> query{};
};
void draw_shortcut_sheet(ShortcutSheet& sheet, std::span<const UserAction> actions,
                         std::span<const Gesture> gestures);

// Creates the feature of the shared windows: command palette, settings, list of shortcuts, message log and
// file browser, and of the visibility of panels. The catalogue must outlive it.
std::unique_ptr<Feature> dialogs(Workspace& workspace, const Catalogue& catalogue);

}  // namespace kerf
