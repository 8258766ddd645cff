#pragma once

#include <span>
#include <string>

#include "core/base/result.h"
#include "ui/editor/shell/catalogue.h"

namespace kerf {

// Keymap files: {"keymap": 1, "bindings": {"edit.undo": "Ctrl+Z", ...}}, with all actions that can have a
// key; an empty text stands for none.

// Returns the text of the keymap file with these bindings. `usual` are the actions with their default keys.
Result<std::string> keymap_text(std::span<const UserAction> usual, const Bindings& bindings);

// Parses a keymap file. Actions that the file does not list keep their default keys; unknown ids are ignored.
// Fails if the text is no keymap, names a key that does not exist, or gives two actions the same key. `file`
// begins the error message.
Result<Bindings> parse_keymap(const std::string& text, const std::string& file,
                              std::span<const UserAction> usual);

}  // namespace kerf
