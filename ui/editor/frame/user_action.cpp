#include "ui/editor/frame/user_action.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace kerf {

bool run_shortcut(std::span<const UserAction> actions, int key, int mods, Message& message) {
  constexpr int kCounted = GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  for (const UserAction& action : actions) {
    if (key == 0 || (action.key != key && action.pad_key != key)) continue;
    if (action.mods != (mods & kCounted)) continue;
    if (const char* why = action.objection()) {
      message.say(why, true);
    } else {
      action.run();
    }
    return true;
  }
  return false;
}

}  // namespace kerf
