#include "ui/editor/actions.h"

#include <GLFW/glfw3.h>

#include "core/base/assert.h"
#include "ui/editor/changes/time_flow.h"
#include "ui/editor/changes/world_changes.h"
#include "ui/editor/view/piece_set.h"

namespace kerf {

namespace {

constexpr std::array kGestures{
    Gesture{"Left drag", "Cut where the pointer goes"},
    Gesture{"Ctrl+click", "Choose a piece; with Shift one more"},
    Gesture{"Ctrl+left drag", "Choose the pieces in a box; from right to left those that it touches"},
    Gesture{"Left drag on an arrow or a ring", "Move or turn the chosen piece, with the tool that picks"},
    Gesture{"Ctrl+left drag on a piece", "Pull it by a spring, while bodies move"},
    Gesture{"Click on a surface", "Add a point to the path, with the tool Path; Shift begins another stroke"},
    Gesture{"Left drag on a point or its knob", "Move a point of the path over the surface, turn its beam"},
    Gesture{"Left drag on the emitter", "Move it, or aim it by the ring where it aims"},
    Gesture{"Double click on a name in the list", "Rename the piece"},
    Gesture{"Middle drag, Alt+left drag", "Orbit"},
    Gesture{"Shift+middle drag, right drag", "Pan"},
    Gesture{"Left drag on the section plane's handles", "Move it along its normal, or turn it"},
    Gesture{"Left drag on a light", "Move it, while the Light panel is open"},
    Gesture{"Wheel", "Zoom to the pointer"},
    Gesture{"Click on the axes in the corner", "Look along that axis; a drag there orbits"},
    Gesture{"Esc",
            "Close a menu; end the cut, also one that is still at work; stop opening a file; let go of the "
            "chosen pieces"},
};

void take_tool(EditorState& state, Tool tool) {
  if (state.hand.drag == Drag::kCut) cancel_stroke(state.hand, state.work.document);
  state.hand.measured.clear();
  state.hand.tool = tool;
}

void append(std::vector<UserAction>& all, std::vector<UserAction> some) {
  std::move(some.begin(), some.end(), std::back_inserter(all));
}

}  // namespace

std::vector<UserAction> tool_actions(EditorState& s) {
  return {
      UserAction{.menu = "Tool",
                 .name = "Laser",
                 .shortcut = "L",
                 .key = GLFW_KEY_L,
                 .tip = "Left drag cuts.",
                 .run = [&s] { take_tool(s, Tool::kLaser); },
                 .checked = [&s] { return s.hand.tool == Tool::kLaser; }},
      UserAction{.menu = "Tool",
                 .name = "Pick pieces",
                 .shortcut = "K",
                 .key = GLFW_KEY_K,
                 .tip = "A click chooses a piece, a drag the pieces in a box; with Shift they are added. "
                        "With the laser "
                        "in hand, Ctrl does the same.",
                 .run = [&s] { take_tool(s, Tool::kPick); },
                 .checked = [&s] { return s.hand.tool == Tool::kPick; }},
      UserAction{.menu = "Tool",
                 .name = "Inspect and measure",
                 .shortcut = "M",
                 .key = GLFW_KEY_M,
                 .tip =
                     "Tells what there is to know about the face under the pointer; two clicks measure the "
                     "distance between two points.",
                 .run = [&s] { take_tool(s, Tool::kInspect); },
                 .checked = [&s] { return s.hand.tool == Tool::kInspect; }},
      UserAction{.menu = "Tool",
                 .name = "Path",
                 .shortcut = "O",
                 .key = GLFW_KEY_O,
                 .tip = "A click on a surface adds a point to the path of the laser, with Shift the first of "
                        "another stroke; points and their beams are dragged.",
                 .run =
                     [&s] {
                       take_tool(s, Tool::kPath);
                       s.settings.side_shown = s.settings.panels.at(PanelId::kPath) = true;
                     },
                 .checked = [&s] { return s.hand.tool == Tool::kPath; },
                 .ends_group = true},
      UserAction{.menu = "Tool",
                 .name = "Cut the last stroke again",
                 .shortcut = "R",
                 .key = GLFW_KEY_R,
                 .tip = "At the resolution that is set now.",
                 .run = [&s] { s.requests.recut = true; },
                 .why_not = [&s] { return why_no_recut(s.work.document); },
                 .ends_group = true},
  };
}

std::vector<UserAction> help_actions(EditorState& s) {
  return {
      UserAction{.menu = "Help",
                 .name = "Command palette",
                 .shortcut = "Ctrl+P",
                 .key = GLFW_KEY_P,
                 .mods = GLFW_MOD_CONTROL,
                 .tip = "Finds any action by parts of its name, and shows its key.",
                 .run = [&s] { open_palette(s.palette); }},
      UserAction{.menu = "Help",
                 .name = "Settings",
                 .shortcut = "Ctrl+,",
                 .key = GLFW_KEY_COMMA,
                 .mods = GLFW_MOD_CONTROL,
                 .tip = "The speed of the mouse, and the keys of all actions.",
                 .run = [&s] { s.settings_page.shown = !s.settings_page.shown; },
                 .checked = [&s] { return s.settings_page.shown; }},
      UserAction{.menu = "Help",
                 .name = "Shortcuts",
                 .shortcut = "F1",
                 .key = GLFW_KEY_F1,
                 .tip = "All keys, and what the mouse does.",
                 .run = [&s] { s.shortcuts_shown = !s.shortcuts_shown; },
                 .checked = [&s] { return s.shortcuts_shown; }},
      UserAction{.menu = "Help",
                 .name = "Messages",
                 .tip = "What the status bar has said, in full. A click on its message shows them too.",
                 .run = [&s] { s.messages_shown = !s.messages_shown; },
                 .checked = [&s] { return s.messages_shown; }},
  };
}

std::vector<UserAction> make_actions(EditorState& state, std::span<const Panel> panels) {
  std::vector<UserAction> all;
  append(all, open_actions(state));
  append(all, save_actions(state));
  append(all, output_actions(state));
  append(all, history_actions(state));
  append(all, view_text_actions(state));
  append(all, piece_actions(state));
  append(all, tool_actions(state));
  append(all, path_actions(state));
  append(all, emitter_actions(state));
  append(all, stage_actions(state));
  append(all, body_actions(body_parts(state)));
  append(all, prepare_actions(state));
  append(all, camera_actions(state));
  append(all, switch_actions(state));
  append(all, frame_actions(state, panels));
  append(all, text_actions(state));
  append(all, help_actions(state));
  append(all, laser_actions(state));
  append(all, stage_view_actions(state));
  append(all, light_actions(state));
  append(all, shown_actions(state));
  append(all, section_actions(state));
  return all;
}

BodyParts body_parts(EditorState& s) {
  return {s.play, s.work, s.view, s.requests, s.message, [&s] {
            return why_time_stands_still(s.work.document.world(), s.split, s.stages.wishes, s.opening);
          }};
}

std::span<const Gesture> gestures() { return kGestures; }

void escape(EditorState& state) {
  const bool fired = std::exchange(state.lasers.emitter.firing, false);
  state.requests.stop = state.cutting.can_stop();
  if (cancel_stroke(state.hand, state.work.document) || fired || state.requests.stop) return;
  if (state.hand.drag == Drag::kBox || state.hand.drag == Drag::kPull) {
    state.hand.drag = Drag::kNone;
    return;
  }
  if (state.hand.drag == Drag::kSection) {
    KERF_ASSERT(state.hand.section);
    state.view.look.section = std::exchange(state.hand.section, {})->from();
    state.view.picture_old = true;
    state.hand.drag = Drag::kNone;
    return;
  }
  if (state.opening.loader.busy()) return cancel_opening(state.opening, state.message);
  if (state.shortcuts_shown || state.messages_shown) {
    state.shortcuts_shown = state.messages_shown = false;
  } else if (!state.hand.measured.empty()) {
    state.hand.measured.clear();
  } else {
    choose_none(state.view.look.pieces);
    state.view.picture_old = true;
  }
}

}  // namespace kerf
