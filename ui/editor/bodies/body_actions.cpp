#include "ui/editor/bodies/body_actions.h"

#include <GLFW/glfw3.h>

#include "core/base/assert.h"
#include "ui/editor/view/piece_set.h"
#include "ui/render/drawn_ground.h"

namespace kerf {

namespace {

constexpr const char* kBodiesMenu = "Bodies";

UserAction speed_action(const BodyParts& on, bool faster) {
  PlayState& play = on.play;
  return {.menu = kBodiesMenu,
          .name = faster ? "Time: faster" : "Time: slower",
          .shortcut = faster ? "=" : "-",
          .key = faster ? GLFW_KEY_EQUAL : GLFW_KEY_MINUS,
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

std::vector<UserAction> time_actions(const BodyParts& on) {
  PlayState& play = on.play;
  return {
      UserAction{
          .menu = kBodiesMenu,
          .name = "Play",
          .shortcut = "Space",
          .key = GLFW_KEY_SPACE,
          .tip = "Pieces that came off fall, or everything stands still again. One undo takes a fall back.",
          .run = [&play] { play.play_or_pause(); },
          .checked = [&play] { return play.playing; },
          .why_not = [&play, why = on.why_no_play] { return play.playing ? nullptr : why(); }},
      UserAction{.menu = kBodiesMenu,
                 .name = "One tick",
                 .shortcut = ".",
                 .key = GLFW_KEY_PERIOD,
                 .tip = "Lets 1/120 s pass.",
                 .run = [&play] { play.ask_for_tick(); },
                 .why_not = on.why_no_play},
      speed_action(on, false),
      speed_action(on, true),
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

SetSurroundings with_gravity(const World& world, const FileFrame& frame, bool on) {
  Surroundings around = usual_surroundings(world, frame);
  if (!on) around.gravity = Vec3(0);
  if (!on && frame.up != UpAxis::kY) around.ground.reset();
  return {around};
}

std::vector<UserAction> body_actions(const BodyParts& on) {
  std::vector<UserAction> actions = time_actions(on);
  const OpenWork& work = on.work;
  const ViewState& view = on.view;
  Requests& requests = on.requests;
  const auto has_gravity = [&work] { return work.document.world().surroundings().gravity != Vec3(0); };
  actions.push_back({.menu = kBodiesMenu,
                     .name = "Gravity",
                     .tip = "Without it pieces float apart. The Bodies panel sets its value.",
                     .run =
                         [&work, &view, &requests, has_gravity] {
                           requests.commands.emplace_back(
                               with_gravity(work.document.world(), view.frame, !has_gravity()));
                         },
                     .checked = has_gravity});
  actions.push_back(
      {.menu = kBodiesMenu,
       .name = "Pin the chosen",
       .shortcut = "Shift+P",
       .key = GLFW_KEY_P,
       .mods = GLFW_MOD_SHIFT,
       .tip = "The chosen pieces stay where they are while others move; the same again lets them "
              "move.",
       .run = [&work, &view,
               &requests] { requests.pin_chosen = !chosen_are_pinned(work.document.world(), view); },
       .checked = [&work, &view] { return chosen_are_pinned(work.document.world(), view); },
       .why_not = [&view] { return why_no_pin(view); }});
  return actions;
}

}  // namespace kerf
