#include "ui/editor/actions.h"

#include <GLFW/glfw3.h>

#include "ui/editor/key_modifiers.h"
#include "ui/editor/view/standard_view.h"
#include "ui/render/view_switches.h"

namespace kerf {

namespace {

constexpr double kScaleStep = 0.125;

void frame_all(EditorState& state) {
  state.view.camera.frame(state.work.document.world().bounds(), state.view.aspect());
}

void change_scale(Settings& settings, double by) {
  settings.ui_scale = std::clamp(settings.ui_scale + by, Settings::kLeastScale, Settings::kMostScale);
}

// Of a standard view. Each pair has a key, and the second of the pair needs Ctrl.
UserAction look_action(ViewState& view, size_t which) {
  constexpr std::array kKeys{GLFW_KEY_1, GLFW_KEY_3, GLFW_KEY_7};
  constexpr std::array kPadKeys{GLFW_KEY_KP_1, GLFW_KEY_KP_3, GLFW_KEY_KP_7};
  const StandardView& looked = kStandardViews.at(which);
  const bool opposite = which % 2 == 1;
  const int key = kKeys.at(which / 2);
  UserAction action{.menu = "Camera",
                    .name = looked.name,
                    .shortcut = (opposite ? "Ctrl+" : "") + std::string(1, static_cast<char>(key)),
                    .key = key,  // GLFW's keys of digits are the digits
                    .mods = opposite ? kCtrl : 0,
                    .pad_key = kPadKeys.at(which / 2),
                    .tip = "Also on the number pad, and by a click on the axes in the corner.",
                    .ends_group = which + 1 == kStandardViews.size()};
  action.run = [&view, &looked] { view.camera.turn_to(looked.yaw, looked.pitch); };
  return action;
}

UserAction switch_action(EditorState& state, const ViewSwitch& s) {
  UserAction action{
      .menu = "View", .name = action_name(s), .tip = s.tip, .in_menu = s.in_menu, .ends_group = s.ends_group};
  if (s.key != 0) action.shortcut = std::string(1, s.key);
  action.key = s.key;  // GLFW's keys of letters are the capitals
  action.run = [&view = state.view, &message = state.message, &s] {
    s.flip(view.look);
    view.picture_old = true;
    if (!s.is_two_state()) message.say(std::string(s.label) + ": " + s.states[s.get(view.look)]);
  };
  action.checked = [&view = state.view, &s] { return s.get(view.look) != 0; };
  return action;
}

}  // namespace

std::vector<UserAction> camera_actions(EditorState& s) {
  std::vector<UserAction> actions{
      UserAction{.menu = "Camera",
                 .name = "Frame all",
                 .shortcut = "F",
                 .key = GLFW_KEY_F,
                 .tip = "Everything in the picture, seen from the side where the eye is.",
                 .run = [&s] { frame_all(s); }},
      UserAction{.menu = "Camera",
                 .name = "First view",
                 .shortcut = "Home",
                 .key = GLFW_KEY_HOME,
                 .tip = "As it was when the file was opened.",
                 .run = [&s] { go_home(s.view, s.work.document.world().bounds()); },
                 .ends_group = true},
  };
  for (size_t i = 0; i < kStandardViews.size(); ++i) actions.push_back(look_action(s.view, i));
  actions.push_back(UserAction{.menu = "Camera",
                               .name = "Orthographic",
                               .shortcut = "5",
                               .key = GLFW_KEY_5,
                               .pad_key = GLFW_KEY_KP_5,
                               .tip = "Without perspective: lengths are drawn alike at all distances.",
                               .run = [&s] { s.view.camera.set_parallel(!s.view.camera.parallel()); },
                               .checked = [&s] { return s.view.camera.parallel(); }});
  return actions;
}

std::vector<UserAction> switch_actions(EditorState& s) {
  std::vector<UserAction> actions;
  for (const ViewSwitch& each : view_switches()) {
    if (each.label[0] != '\0') actions.push_back(switch_action(s, each));
  }
  return actions;
}

std::vector<UserAction> frame_actions(EditorState& s, std::span<const Panel> panels) {
  return {
      UserAction{.menu = "View",
                 .name = "Split view",
                 .shortcut = "S",
                 .key = GLFW_KEY_S,
                 .tip = "The last stroke at a second resolution, in a right half of the picture.",
                 .run = [&s] { show_split(s.split, !s.split.shown, s.hand, s.work.document, s.view); },
                 .checked = [&s] { return s.split.shown; }},
      UserAction{.menu = "View",
                 .name = "Panels",
                 .items = [&s, panels] { return panel_actions(panels, s.settings); }},
      UserAction{.menu = "View",
                 .name = "Column of panels",
                 .shortcut = "F4",
                 .key = GLFW_KEY_F4,
                 .tip = "Hides the column, so that the picture fills the window.",
                 .run = [&s] { s.settings.side_shown = !s.settings.side_shown; },
                 .checked = [&s] { return s.settings.side_shown; }},
      UserAction{
          .menu = "View",
          .name = "Light theme",
          .shortcut = "F9",
          .key = GLFW_KEY_F9,
          .tip = "Bright panels and menus; the picture stays as it is.",
          .run =
              [&s] { s.settings.theme = s.settings.theme == Theme::kLight ? Theme::kDark : Theme::kLight; },
          .checked = [&s] { return s.settings.theme == Theme::kLight; }},
  };
}

std::vector<UserAction> text_actions(EditorState& s) {
  return {
      UserAction{.menu = "View",
                 .name = "Larger text",
                 .shortcut = "Ctrl+=",
                 .key = GLFW_KEY_EQUAL,
                 .mods = kCtrl,
                 .tip = "Of panels and menus.",
                 .run = [&s] { change_scale(s.settings, kScaleStep); },
                 .why_not =
                     [&s] {
                       return s.settings.ui_scale >= Settings::kMostScale ? "It is as large as it can be."
                                                                          : nullptr;
                     }},
      UserAction{.menu = "View",
                 .name = "Smaller text",
                 .shortcut = "Ctrl+-",
                 .key = GLFW_KEY_MINUS,
                 .mods = kCtrl,
                 .tip = "Of panels and menus.",
                 .run = [&s] { change_scale(s.settings, -kScaleStep); },
                 .why_not =
                     [&s] {
                       return s.settings.ui_scale <= Settings::kLeastScale ? "It is as small as it can be."
                                                                           : nullptr;
                     }},
  };
}

}  // namespace kerf
