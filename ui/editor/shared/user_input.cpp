#include "ui/editor/shared/user_input.h"

#include <GLFW/glfw3.h>
#include <iterator>

#include "core/base/assert.h"

namespace kerf {

namespace {

// If several actions have a key, those with a condition that holds take precedence.
const UserAction* action_of(std::span<const UserAction> actions, int key, int mods) {
  const UserAction* found = nullptr;
  for (const UserAction& action : actions) {
    if (!action.has_key({key, mods})) continue;
    if (action.has_key_when && action.has_key_when()) return &action;
    if (!action.has_key_when && found == nullptr) found = &action;
  }
  return found;
}

}  // namespace

void UserAction::set_shortcut(const std::string& text) {
  const auto chord = parse_chord(text).value_or(KeyChord());
  shortcut = text;
  key = chord.key;
  mods = chord.mods;
}

std::vector<UserAction> joined(std::vector<std::vector<UserAction>> lists) {
  std::vector<UserAction> all;
  for (std::vector<UserAction>& list : lists) std::move(list.begin(), list.end(), std::back_inserter(all));
  return all;
}

bool run_shortcut(std::span<const UserAction> actions, int key, int mods, Message& message) {
  constexpr int kCounted = GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  const UserAction* action = action_of(actions, key, mods & kCounted);
  if (action == nullptr) return false;
  KERF_ASSERT(action->run);
  if (const char* why = action->objection()) {
    message.object(why);
  } else {
    message.drop_objection();
    action->run();
  }
  return true;
}

}  // namespace kerf
