#include "ui/editor/actions.h"

#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "ui/editor/changes/recut.h"
#include "ui/editor/frame/file_menus.h"
#include "ui/editor/frame/load_bar.h"
#include "ui/editor/panels/panels.h"
#include "ui/editor/tools/piece_set.h"
#include "ui/editor/tools/viewport_input.h"
#include "ui/editor/work/camera_text.h"

namespace kerf {

namespace {

// A switch of the view: a flag of ShowOptions or of ViewOptions.
template <auto flag>
bool& flag_of(ViewOptions& look) {
  if constexpr (requires { look.show.*flag; }) {
    return look.show.*flag;
  } else {
    return look.*flag;
  }
}
template <auto flag>
void flip(EditorState& state) {
  bool& on = flag_of<flag>(state.look);
  on = !on;
  state.picture_old = true;
}
template <auto flag>
bool shown(const EditorState& state) {
  if constexpr (requires { state.look.show.*flag; }) {
    return state.look.show.*flag;
  } else {
    return state.look.*flag;
  }
}

void frame_all(EditorState& state) { state.camera.frame(state.document.world().bounds(), state.aspect()); }

void go_home(EditorState& state) {
  if (state.home) {
    state.camera.look(state.home->eye, state.home->target);
  } else {
    state.camera.frame_default(state.document.world().bounds(), state.aspect());
  }
}

void save(EditorState& state) {
  if (state.work.file.empty()) return browse(state, FileBrowser::Purpose::kSave);
  state.requests.save_to = state.work.file;
}

void copy_view(EditorState& state) {
  ImGui::SetClipboardText(view_text({state.view().eye, state.camera.pivot()}).c_str());
  state.say("The view is in the clipboard as text");
}

void paste_view(EditorState& state) {
  const char* text = ImGui::GetClipboardText();
  const Result<View> view = parse_view_text(text != nullptr ? text : "");
  if (!view) return state.say(view.error().message, true);
  state.camera.look(view->eye, view->target);
  state.say("");
}

template <void (*change)(PieceMap&)>
void change_pieces(EditorState& state) {
  change(state.look.pieces);
  state.picture_old = true;
}

void choose_all(EditorState& state) {
  for (const PieceRow& row : list_pieces(state.document.world())) {
    PieceLook& look = state.look.pieces[row.id];
    look.selected = !look.hidden;
  }
  state.picture_old = true;
}

const char* why_no_undo(const EditorState& state) {
  return state.document.history().position() > 0 ? nullptr : "Nothing was done yet.";
}
const char* why_no_redo(const EditorState& state) {
  const History& history = state.document.history();
  return history.position() < history.size() ? nullptr : "Nothing was taken back.";
}

const char* why_none_chosen(const EditorState& state) {
  return chosen_pieces(state.look.pieces) > 0
             ? nullptr
             : "No piece is chosen: Ctrl+click one, or choose it in the list.";
}
const char* why_none_hidden(const EditorState& state) {
  return hidden_pieces(state.look.pieces).empty() ? "No piece is hidden." : nullptr;
}

template <Tool tool>
void take_tool(EditorState& state) {
  cancel_stroke(state);
  state.left_button = tool;
}
template <Tool tool>
bool has_tool(const EditorState& state) {
  return state.left_button == tool;
}

constexpr double kScaleStep = 0.125;
void change_scale(EditorState& state, double by) {
  Settings& s = state.settings;
  s.ui_scale = std::clamp(s.ui_scale + by, Settings::kLeastScale, Settings::kMostScale);
}

constexpr int kCtrl = GLFW_MOD_CONTROL, kShift = GLFW_MOD_SHIFT;

constexpr std::array kActions{
    Action{.menu = "File",
           .name = "New",
           .shortcut = "Ctrl+N",
           .key = GLFW_KEY_N,
           .mods = kCtrl,
           .tip = "The first scene again, uncut.",
           .run = [](EditorState& s) { s.requests.fresh = true; }},
    Action{.menu = "File",
           .name = "Open...",
           .shortcut = "Ctrl+O",
           .key = GLFW_KEY_O,
           .mods = kCtrl,
           .tip = "A scene (.json), a journal (.kerf) or a mesh (.obj .stl .ply .off). Files can also be "
                  "dropped on "
                  "the window.",
           .run = [](EditorState& s) { browse(s, FileBrowser::Purpose::kOpen); }},
    Action{.menu = "File", .name = "Open recent", .submenu = draw_recent_menu},
    Action{.menu = "File", .name = "Examples", .submenu = draw_examples_menu, .ends_group = true},
    Action{.menu = "File",
           .name = "Save",
           .shortcut = "Ctrl+S",
           .key = GLFW_KEY_S,
           .mods = kCtrl,
           .tip = "Everything that was done, as a journal (.kerf). The version before is kept as .kerf~.",
           .run = save},
    Action{.menu = "File",
           .name = "Save as...",
           .shortcut = "Ctrl+Shift+S",
           .key = GLFW_KEY_S,
           .mods = kCtrl | kShift,
           .tip = "To another journal (.kerf), or as a scene (.json) without what was cut.",
           .run = [](EditorState& s) { browse(s, FileBrowser::Purpose::kSave); },
           .ends_group = true},
    Action{.menu = "File",
           .name = "Export chosen pieces...",
           .shortcut = "Ctrl+E",
           .key = GLFW_KEY_E,
           .mods = kCtrl,
           .tip = "As meshes, where they stand; several go to numbered files.",
           .run = [](EditorState& s) { browse(s, FileBrowser::Purpose::kExport); },
           .why_not = why_none_chosen},
    Action{.menu = "File",
           .name = "Save the picture",
           .shortcut = "F12",
           .key = GLFW_KEY_F12,
           .tip = "A PNG of the picture without panels, named by date, in the current folder.",
           .run = [](EditorState& s) { s.requests.screenshot = Requests::Screenshot::kPicture; }},
    Action{.menu = "File",
           .name = "Save the window",
           .shortcut = "Shift+F12",
           .key = GLFW_KEY_F12,
           .mods = kShift,
           .tip = "A PNG of the window with its panels.",
           .run = [](EditorState& s) { s.requests.screenshot = Requests::Screenshot::kWindow; },
           .ends_group = true},
    Action{.menu = "File",
           .name = "Quit",
           .shortcut = "Ctrl+Q",
           .key = GLFW_KEY_Q,
           .mods = kCtrl,
           .tip = "Ends the editor. The settings are kept.",
           .run = [](EditorState& s) { s.requests.quit = true; }},

    Action{.menu = "Edit",
           .name = "Undo",
           .shortcut = "Ctrl+Z",
           .key = GLFW_KEY_Z,
           .mods = kCtrl,
           .tip = "Takes the last stroke or command back.",
           .run = [](EditorState& s) { s.requests.undo = true; },
           .why_not = why_no_undo},
    Action{.menu = "Edit",
           .name = "Redo",
           .shortcut = "Ctrl+Shift+Z",
           .key = GLFW_KEY_Z,
           .mods = kCtrl | kShift,
           .tip = "Does again what was taken back.",
           .run = [](EditorState& s) { s.requests.redo = true; },
           .why_not = why_no_redo,
           .ends_group = true},
    Action{.menu = "Edit",
           .name = "Copy the view",
           .shortcut = "Ctrl+C",
           .key = GLFW_KEY_C,
           .mods = kCtrl,
           .tip = "Where the eye stands, as text.",
           .run = copy_view},
    Action{.menu = "Edit",
           .name = "Paste the view",
           .shortcut = "Ctrl+V",
           .key = GLFW_KEY_V,
           .mods = kCtrl,
           .tip = "Looks from where the text in the clipboard says.",
           .run = paste_view,
           .ends_group = true},
    Action{.menu = "Edit",
           .name = "Choose all pieces",
           .shortcut = "Ctrl+A",
           .key = GLFW_KEY_A,
           .mods = kCtrl,
           .tip = "All that are not hidden.",
           .run = choose_all},
    Action{.menu = "Edit",
           .name = "Hide the chosen",
           .shortcut = "H",
           .key = GLFW_KEY_H,
           .tip = "Leaves the chosen pieces out of the picture; the beam passes them by.",
           .run = [](EditorState& s) { s.requests.hide_chosen = true; },
           .why_not = why_none_chosen},
    Action{.menu = "Edit",
           .name = "Show all pieces",
           .shortcut = "Shift+H",
           .key = GLFW_KEY_H,
           .mods = kShift,
           .tip = "Draws the hidden pieces again.",
           .run = [](EditorState& s) { s.requests.show_hidden = true; },
           .why_not = why_none_hidden},
    Action{.menu = "Edit",
           .name = "Delete the chosen",
           .shortcut = "Del",
           .key = GLFW_KEY_DELETE,
           .tip = "Takes the chosen pieces out of the world.",
           .run = [](EditorState& s) { s.requests.delete_chosen = true; },
           .why_not = why_none_chosen},

    Action{.menu = "Tool",
           .name = "Laser",
           .shortcut = "L",
           .key = GLFW_KEY_L,
           .tip = "Left drag cuts.",
           .run = take_tool<Tool::kLaser>,
           .checked = has_tool<Tool::kLaser>},
    Action{
        .menu = "Tool",
        .name = "Pick pieces",
        .shortcut = "K",
        .key = GLFW_KEY_K,
        .tip =
            "A click chooses a piece, Shift+click adds one; left drag looks round. With the laser in hand, "
            "Ctrl+click does the same.",
        .run = take_tool<Tool::kPick>,
        .checked = has_tool<Tool::kPick>,
        .ends_group = true},
    Action{.menu = "Tool",
           .name = "Cut the last stroke again",
           .shortcut = "R",
           .key = GLFW_KEY_R,
           .tip = "At the resolution that is set now.",
           .run = [](EditorState& s) { s.requests.recut = true; },
           .why_not = why_no_recut},

    Action{.menu = "View",
           .name = "Frame all",
           .shortcut = "F",
           .key = GLFW_KEY_F,
           .tip = "Everything in the picture, seen from the side where the eye is.",
           .run = frame_all},
    Action{.menu = "View",
           .name = "First view",
           .shortcut = "Home",
           .key = GLFW_KEY_HOME,
           .tip = "As it was when the file was opened.",
           .run = go_home,
           .ends_group = true},
    Action{.menu = "View",
           .name = "Shadows",
           .shortcut = "D",
           .key = GLFW_KEY_D,
           .tip = "Of everything on everything.",
           .run = flip<&ShowOptions::shadows>,
           .checked = shown<&ShowOptions::shadows>},
    Action{.menu = "View",
           .name = "Silhouette",
           .shortcut = "E",
           .key = GLFW_KEY_E,
           .tip = "The edges that bound the shadow of a light.",
           .run = flip<&ShowOptions::silhouette>,
           .checked = shown<&ShowOptions::silhouette>},
    Action{.menu = "View",
           .name = "Shadow volumes",
           .shortcut = "V",
           .key = GLFW_KEY_V,
           .tip = "What the silhouette is extruded to.",
           .run = flip<&ShowOptions::shadow_volumes>,
           .checked = shown<&ShowOptions::shadow_volumes>},
    Action{.menu = "View",
           .name = "Shadow counts",
           .shortcut = "C",
           .key = GLFW_KEY_C,
           .tip = "How many surfaces keep the light away.",
           .run = flip<&ShowOptions::shadow_stencil>,
           .checked = shown<&ShowOptions::shadow_stencil>},
    Action{.menu = "View",
           .name = "Facing the light",
           .shortcut = "T",
           .key = GLFW_KEY_T,
           .tip = "Polygons that face the light against those that are averted.",
           .run = flip<&ShowOptions::shadow_facing>,
           .checked = shown<&ShowOptions::shadow_facing>},
    Action{.menu = "View",
           .name = "Compare two shadow methods",
           .shortcut = "X",
           .key = GLFW_KEY_X,
           .tip = "Left and right of a line; the Light panel chooses them.",
           .run = flip<&ShowOptions::shadow_compare>,
           .checked = shown<&ShowOptions::shadow_compare>},
    Action{.menu = "View",
           .name = "Trace shadow rays",
           .shortcut = "Y",
           .key = GLFW_KEY_Y,
           .tip = "The reference, pixel by pixel once the picture stands still.",
           .run = flip<&ShowOptions::shadow_reference>,
           .checked = shown<&ShowOptions::shadow_reference>,
           .ends_group = true},
    Action{.menu = "View",
           .name = "Level colouring",
           .tip = "Small faces glow: the smaller a face against the one it was split from, the hotter.",
           .run = flip<&ViewOptions::level_colours>,
           .checked = shown<&ViewOptions::level_colours>},
    Action{.menu = "View",
           .name = "Wire",
           .shortcut = "W",
           .key = GLFW_KEY_W,
           .tip = "Edges of the faces.",
           .run = flip<&ShowOptions::wire>,
           .checked = shown<&ShowOptions::wire>},
    Action{.menu = "View",
           .name = "Boxes of the tree",
           .shortcut = "B",
           .key = GLFW_KEY_B,
           .tip = "The bounding boxes that find the faces under the beam.",
           .run = flip<&ShowOptions::aabb>,
           .checked = shown<&ShowOptions::aabb>},
    Action{.menu = "View",
           .name = "Piece colours",
           .shortcut = "P",
           .key = GLFW_KEY_P,
           .tip = "Every piece that came off in a strong colour of its own.",
           .run = flip<&ShowOptions::pieces>,
           .checked = shown<&ShowOptions::pieces>},
    Action{.menu = "View",
           .name = "Normals",
           .shortcut = "N",
           .key = GLFW_KEY_N,
           .tip = "A short line out of the front of every face.",
           .run = flip<&ShowOptions::normals>,
           .checked = shown<&ShowOptions::normals>},
    Action{.menu = "View",
           .name = "Face numbers",
           .shortcut = "I",
           .key = GLFW_KEY_I,
           .tip = "The number of each face, and in red of those that are gone.",
           .run = flip<&ShowOptions::face_numbers>,
           .checked = shown<&ShowOptions::face_numbers>},
    Action{.menu = "View",
           .name = "Ghost of what is gone",
           .shortcut = "G",
           .key = GLFW_KEY_G,
           .tip = "Removed faces stay as a faint veil.",
           .run = flip<&ViewOptions::ghost>,
           .checked = shown<&ViewOptions::ghost>},
    Action{.menu = "View",
           .name = "Anti-aliasing",
           .tip = "Smooth edges; off is faster without a graphics card.",
           .run = flip<&ViewOptions::antialias>,
           .checked = shown<&ViewOptions::antialias>,
           .ends_group = true},
    Action{.menu = "View",
           .name = "Split view",
           .shortcut = "S",
           .key = GLFW_KEY_S,
           .tip = "The last stroke at a second resolution, in a right half of the picture.",
           .run = [](EditorState& s) { show_split(s, !s.split.shown); },
           .checked = [](const EditorState& s) { return s.split.shown; }},
    Action{.menu = "View", .name = "Panels", .submenu = draw_panels_menu},
    Action{.menu = "View",
           .name = "Column of panels",
           .shortcut = "F4",
           .key = GLFW_KEY_F4,
           .tip = "Hides the column, so that the picture fills the window.",
           .run = [](EditorState& s) { s.settings.side_shown = !s.settings.side_shown; },
           .checked = [](const EditorState& s) { return s.settings.side_shown; }},
    Action{.menu = "View",
           .name = "Light theme",
           .shortcut = "F9",
           .key = GLFW_KEY_F9,
           .tip = "Bright panels and menus; the picture stays as it is.",
           .run =
               [](EditorState& s) {
                 s.settings.theme = s.settings.theme == Theme::kLight ? Theme::kDark : Theme::kLight;
               },
           .checked = [](const EditorState& s) { return s.settings.theme == Theme::kLight; }},
    Action{.menu = "View",
           .name = "Larger text",
           .shortcut = "Ctrl+=",
           .key = GLFW_KEY_EQUAL,
           .mods = kCtrl,
           .tip = "Of panels and menus.",
           .run = [](EditorState& s) { change_scale(s, kScaleStep); },
           .why_not =
               [](const EditorState& s) {
                 return s.settings.ui_scale >= Settings::kMostScale ? "It is as large as it can be."
                                                                    : nullptr;
               }},
    Action{.menu = "View",
           .name = "Smaller text",
           .shortcut = "Ctrl+-",
           .key = GLFW_KEY_MINUS,
           .mods = kCtrl,
           .tip = "Of panels and menus.",
           .run = [](EditorState& s) { change_scale(s, -kScaleStep); },
           .why_not =
               [](const EditorState& s) {
                 return s.settings.ui_scale <= Settings::kLeastScale ? "It is as small as it can be."
                                                                     : nullptr;
               }},

    Action{.menu = "Help",
           .name = "Shortcuts",
           .shortcut = "F1",
           .key = GLFW_KEY_F1,
           .tip = "All keys, and what the mouse does.",
           .run = [](EditorState& s) { s.show_shortcuts = !s.show_shortcuts; },
           .checked = [](const EditorState& s) { return s.show_shortcuts; }},
};

constexpr std::array kGestures{
    Gesture{"Left drag", "Cut where the pointer goes"},
    Gesture{"Ctrl+click", "Choose a piece; with Shift one more"},
    Gesture{"Middle drag, Alt+left drag", "Orbit"},
    Gesture{"Shift+middle drag, right drag", "Pan"},
    Gesture{"Left drag on a light", "Move it, while the Light panel is open"},
    Gesture{"Wheel", "Zoom to the pointer"},
    Gesture{"Esc", "End the cut; stop opening a file; let go of the chosen pieces"},
};

void escape(EditorState& state) {
  if (cancel_stroke(state)) return;
  if (state.loader.busy()) return cancel_opening(state);
  if (state.show_shortcuts) {
    state.show_shortcuts = false;
  } else {
    change_pieces<choose_none>(state);
  }
}

}  // namespace

std::span<const Action> actions() { return kActions; }
std::span<const Gesture> gestures() { return kGestures; }

bool run_shortcut(EditorState& state, int key, int mods) {
  if (key == GLFW_KEY_ESCAPE) {
    escape(state);
    return true;
  }
  constexpr int kCounted = GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  for (const Action& action : kActions) {
    if (action.key != key || key == 0 || action.mods != (mods & kCounted)) continue;
    if (const char* why = action.why_not != nullptr ? action.why_not(state) : nullptr) {
      state.say(why, true);
    } else {
      action.run(state);
    }
    return true;
  }
  return false;
}

}  // namespace kerf
