#pragma once

#include "ui/editor/frame/user_action.h"
#include "ui/editor/view/settings.h"
#include "ui/editor/work/requests.h"

namespace kerf {

// One action for each of the files that were open last, and one that forgets them; a file that is gone cannot
// be opened. Both must outlive them.
std::vector<UserAction> recent_actions(Settings& settings, Requests& requests);

// One action for each of the scenes that come with Kerf. The requests must outlive them.
std::vector<UserAction> example_actions(Requests& requests);

}  // namespace kerf
