#pragma once

#include <string>

#include "ui/editor/shared/picture/view_state.h"

namespace kerf {

// The key of an action as it is bound at the moment; empty if it has none.
std::string shortcut_of(const ViewState& view, const std::string& action);

// A sentence with the key of an action in brackets before its full stop, if it has a key: "Hides it (H)."
std::string with_shortcut(const ViewState& view, std::string sentence, const std::string& action);

}  // namespace kerf
