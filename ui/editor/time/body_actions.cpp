#include "ui/editor/time/body_actions.h"

#include <GLFW/glfw3.h>

#include "core/base/assert.h"
#include "ui/editor/shared/long_change.h"
#include "ui/editor/shared/pieces/piece_set.h"
#include "ui/editor/shared/selection.h"
#include "ui/render/view/drawn_ground.h"

namespace kerf {

namespace {

UserAction speed_action(Workspace& on, PlayState& play, bool faster) {
  return {.name = faster ? "Time: faster" : "Time: slower",
          .shortcut = faster ? "=" : "-",
          .pad_key = faster ? GLFW_KEY_KP_ADD : GLFW_KEY_KP_SUBTRACT,
          .tip = "From an eighth of real time to real time.",
          .run =
              [&play, &message = on.message, faster] {
                KERF_ASSERT(faster ? play.can_go_faster() : play.can_go_slower());
                faster ? ++play.speed_index : --play.speed_index;
                message.say(std::string("Time passes at ") + play.speed().name);
              },
          .why_not = [&play, faster]() -> const char* {
            if (faster) return play.can_go_faster() ? nullptr : "Time passes in real time already.";
            return play.can_go_slower() ? nullptr : "Time passes at an eighth of real time already.";
          },
          .ends_group = faster};
}

std::vector<UserAction> time_actions(Workspace& on, PlayState& play) {
  const auto why_no_play = [&on] { return on.why_time_stands_still(); };
  return {
      UserAction{
          .name = "Play",
          .shortcut = "Space",
          .tip = "Pieces that came off fall, or everything stands still again. One undo takes a fall back.",
          .run = [&play] { play.play_or_pause(); },
          .checked = [&play] { return play.playing; },
          .why_not = [&play, why_no_play] { return play.playing ? nullptr : why_no_play(); }},
      UserAction{.name = "One tick",
                 .shortcut = ".",
                 .tip = "Lets 1/120 s pass.",
                 .run = [&play] { play.ask_for_tick(); },
                 .why_not = why_no_play},
      speed_action(on, play, false),
      speed_action(on, play, true),
  };
}

}  // namespace

const char* why_no_pin(const ViewState& view) { return why_none_chosen(view.look.pieces); }

bool chosen_are_pinned(const World& world, const ViewState& view) {
  bool any = false;
  for (const auto& [id, look] : view.look.pieces) {
    if (!look.selected || !world.contains(id.body)) continue;
    if (!world.body(id.body).pinned) return false;
    any = true;
  }
  return any;
}

SetEnvironment with_gravity(const World& world, const FileFrame& frame, bool on) {
  Environment around = default_environment(world, frame);
  if (!on) around.gravity = Vec3(0);
  if (!on && frame.up != UpAxis::kY) around.ground.reset();
  return {around};
}

void ask_to_pin(Workspace& on, bool pinned) {
  const char* name = pinned ? "Pin pieces" : "Unpin pieces";
  const auto run = [&on, name, pinned] {
    cancel_stroke(on);
    on.changes.change(name, is_small(on.work.document),
                      edit_all(chosen_ids(on.view.look.pieces), [pinned](const PieceId& p) {
                        return PinPiece{p, pinned};
                      }));
    return true;
  };
  on.changes.ask({.name = name, .run = run, .is_one = true});
}

std::vector<UserAction> body_actions(Workspace& on, PlayState& play) {
  std::vector<UserAction> actions = time_actions(on, play);
  const auto has_gravity = [&on] { return on.world().environment().gravity != Vec3(0); };
  const auto are_pinned = [&on] { return chosen_are_pinned(on.world(), on.view); };
  actions.push_back(
      {.name = "Gravity",
       .tip = "Without it pieces float apart. The Bodies panel sets its value.",
       .run = [&on, has_gravity] { on.changes.ask(with_gravity(on.world(), on.view.frame, !has_gravity())); },
       .checked = has_gravity});
  actions.push_back({.name = "Pin the chosen",
                     .shortcut = "Shift+P",
                     .tip =
                         "The chosen pieces stay where they are while others move; the same again lets them "
                         "move.",
                     .run = [&on, are_pinned] { ask_to_pin(on, !are_pinned()); },
                     .checked = are_pinned,
                     .why_not = [&on] { return why_no_pin(on.view); }});
  return actions;
}

}  // namespace kerf
