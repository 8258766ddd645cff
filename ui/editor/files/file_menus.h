#pragma once

#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/user_action.h"

namespace kerf {

// One action for each of the files that were open last, and one that forgets them; a file that is gone cannot
// be opened. The settings must outlive them.
using OpenFile = std::function<void(const std::filesystem::path&)>;
std::vector<UserAction> recent_actions(Settings& settings, const OpenFile& open);

// One action for each of the scenes that come with Kerf.
std::vector<UserAction> example_actions(const OpenFile& open);

}  // namespace kerf
