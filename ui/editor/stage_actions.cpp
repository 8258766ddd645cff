#include <algorithm>

#include "ui/editor/actions.h"

#include <GLFW/glfw3.h>

namespace kerf {

namespace {

constexpr const char* kMenu = "Tool";
constexpr double kSpeedStep = 2;

const char* why_no_play(const EditorState& s) {
  if (s.stages.wishes.playing) return nullptr;
  const char* no_next = why_no_next_stage(s.stages, s.work.document);
  return no_next != nullptr ? why_not_again(s.work.document) : nullptr;
}

const char* why_no_query(const EditorState& s) {
  return s.stages.log.query().empty() ? "No stage of single steps has asked the tree." : nullptr;
}

UserAction speed_action(EditorState& s, const char* name, double factor) {
  return {.menu = "Single step",
          .name = name,
          .tip = "How many stages a second are played.",
          .run =
              [&s, factor] {
                double& speed = s.stages.wishes.per_second;
                speed = std::clamp(speed * factor, StageWishes::kSlowest, StageWishes::kFastest);
              },
          .in_menu = false};
}

// With the boxes of the last query, one box more or less.
UserAction visit_action(EditorState& s, const char* name, const char* shortcut, int key, int by) {
  return {.menu = "Tree",
          .name = name,
          .shortcut = shortcut,
          .key = key,
          .tip = "Of the last query of the tree in single steps: the boxes in the order of their tests.",
          .run =
              [&s, by] {
                const auto visited = static_cast<std::ptrdiff_t>(s.stages.log.query().visited());
                s.stages.log.visit(static_cast<size_t>(std::max<std::ptrdiff_t>(1, visited + by)));
              },
          .why_not = [&s] { return why_no_query(s); },
          .in_menu = false};
}

std::vector<UserAction> beginnings(EditorState& s) {
  StageWishes& wishes = s.stages.wishes;
  return {
      UserAction{.menu = kMenu,
                 .name = "Single steps",
                 .shortcut = "F8",
                 .key = GLFW_KEY_F8,
                 .tip = "A stroke waits, and is cut stage by stage: sweep, hit, refine, remove, separate.",
                 .run = [&wishes] { wishes.stop(), wishes.on = !wishes.on; },
                 .checked = [&wishes] { return wishes.on; }},
      UserAction{.menu = kMenu,
                 .name = "Step through the last stroke",
                 .shortcut = "Shift+F8",
                 .key = GLFW_KEY_F8,
                 .mods = GLFW_MOD_SHIFT,
                 .tip = "Takes the last stroke back, to be cut again stage by stage.",
                 .run = [&wishes] { wishes.begin_again(); },
                 .why_not = [&s] { return why_not_again(s.work.document); }},
      UserAction{.menu = kMenu,
                 .name = "Play the stages",
                 .shortcut = "Space",
                 .key = GLFW_KEY_SPACE,
                 .tip = "In slow motion, or pauses. At the end of the stroke it begins again.",
                 .run = [&s] { play_or_pause(s.stages, s.work.document); },
                 .checked = [&wishes] { return wishes.playing; },
                 .why_not = [&s] { return why_no_play(s); },
                 .has_key_when = [&wishes] { return wishes.on; }},
  };
}

std::vector<UserAction> steps(EditorState& s) {
  StageWishes& wishes = s.stages.wishes;
  const auto why_not = [&s] { return why_no_next_stage(s.stages, s.work.document); };
  const auto while_on = [&wishes] { return wishes.on; };  // otherwise the key lets a tick pass
  return {
      UserAction{.menu = kMenu,
                 .name = "Next stage",
                 .shortcut = ".",
                 .key = GLFW_KEY_PERIOD,
                 .tip = "Executes one stage of the stroke.",
                 .run = [&s] { s.stages.wishes.go_to(s.stages.log.done() + 1); },
                 .why_not = why_not,
                 .has_key_when = while_on},
      UserAction{.menu = kMenu,
                 .name = "Stage back",
                 .shortcut = ",",
                 .key = GLFW_KEY_COMMA,
                 .tip = "Takes the last stage back, exactly.",
                 .run = [&s] { s.stages.wishes.go_to(s.stages.log.done() - 1); },
                 .why_not = [&s] { return why_no_stage_back(s.stages, s.work.document); }},
      UserAction{.menu = kMenu,
                 .name = "Finish the move",
                 .shortcut = "Shift+.",
                 .key = GLFW_KEY_PERIOD,
                 .mods = GLFW_MOD_SHIFT,
                 .tip = "Executes stages until a move of the beam is finished.",
                 .run = [&wishes] { wishes.run_to_end_of_move(); },
                 .why_not = why_not},
      UserAction{.menu = kMenu,
                 .name = "Finish the stroke",
                 .shortcut = "End",
                 .key = GLFW_KEY_END,
                 .tip = "Executes all stages that are left.",
                 .run = [&wishes] { wishes.go_to(StageWishes::kAll); },
                 .why_not = why_not},
  };
}

}  // namespace

std::vector<UserAction> stage_actions(EditorState& s) {
  std::vector<UserAction> actions = beginnings(s);
  for (UserAction& step : steps(s)) actions.push_back(std::move(step));
  return actions;
}

std::vector<UserAction> stage_view_actions(EditorState& s) {
  return {
      speed_action(s, "Stages: faster", kSpeedStep),
      speed_action(s, "Stages: slower", 1 / kSpeedStep),
      visit_action(s, "Query: next box", "]", GLFW_KEY_RIGHT_BRACKET, 1),
      visit_action(s, "Query: box before", "[", GLFW_KEY_LEFT_BRACKET, -1),
      {.menu = "Tree",
       .name = "Query: show the boxes",
       .tip = "Draws the boxes that the last query of the tree has tested, coloured by what became of them.",
       .run = [&s] { s.stages.log.draw_query(!s.stages.log.query().drawn); },
       .checked = [&s] { return s.stages.log.query().drawn; },
       .in_menu = false}};
}

}  // namespace kerf
