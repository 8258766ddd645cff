#include "ui/editor/shell/catalogue.h"

#include <imgui.h>
#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "ui/editor/shell/dialogs.h"
#include "ui/window/layout.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr const char* kLine = MenuLayout::kLine;

const std::vector<TabLayout> kTabLayout{
    {Tab::kCut,
     {{"laser", "Laser", true, {"laser.beam", "laser.heat", "laser.emitter"}},
      {"resolution", "Resolution", true, {"resolution.cut", "resolution.compare"}},
      {"path", "Path", false, {"path", "path.drawing"}},
      {"pieces", "Pieces", true, {"pieces.list", "pieces.placement", "pieces.explode"}},
      {"history", "History", true, {"history"}}}},
    {Tab::kView,
     {{"view", "View", true, {"view.section", "view.section_cut", "view.switches"}},
      {"tree", "Tree", false, {"tree.boxes", "tree.query", "tree.shape"}},
      {"scalar_map", "Scalar Map", false, {"scalar_map"}},
      {"graph", "Graph", false, {"graph"}, Dock::kStrip},
      {"single_step", "Step Mode", false, {"single_step"}},
      {"light", "Light", false, {"light"}},
      {"ruler", "Ruler", false, {"ruler"}},
      {"statistics", "Statistics", false, {"statistics"}},
      {"display", "Display", false, {"display"}}}},
    {Tab::kPhysics, {{"bodies", "Bodies", true, {"bodies"}}}},
    {Tab::kThermal, {{"material", "Material", true, {"material"}}}},
    {Tab::kMesh, {{"prepare", "Prepare", true, {"prepare"}}, {"file", "File", true, {"file"}}}},
};

// clang-format off
const std::vector<MenuLayout> kMenus{
    {"File",
     {"file.new", "file.open", "file.open_recent", "file.examples", kLine,
      "file.save", "file.save_as", kLine,
      "drawing.import", "pieces.export", "file.save_viewport_image", "file.save_screenshot", kLine,
      "file.play_game", kLine,
      "file.quit"}},
    {"Edit",
     {"edit.undo", "edit.redo", kLine,
      "pieces.copy", "pieces.paste", "pieces.duplicate", "pieces.delete", kLine,
      ">Select", "pieces.select_all", "pieces.invert", "pieces.select_body", "pieces.select_material",
      "pieces.select_similar", "pieces.grow", "pieces.shrink", "pieces.lasso", kLine,
      "pieces.hide", "pieces.show_all", "pieces.isolate", "pieces.rename", kLine,
      "pieces.move", "pieces.rotate"}},
    {"Tool",
     {"tool.laser", "tool.knife", "tool.pick", "tool.inspect", "tool.ruler", "tool.path", "tool.drawing",
      kLine,
      "laser.recut", "laser.compare_resolutions", kLine,
      "stages.step_mode", "stages.step_last_cut", "stages.play", "stages.next", "stages.previous",
      "stages.finish_segment", "stages.finish_stroke"}},
    {"Path",
     {"path.run", kLine,
      "path.load", "path.save", "path.clear", "path.delete_point", kLine,
      "path.undo", "path.redo", kLine,
      "drawing.cut", "drawing.cancel", kLine,
      "emitter.place", "emitter.fire", "emitter.remove"}},
    {"Physics",
     {"physics.play", "physics.step", "physics.slower", "physics.faster", kLine,
      "physics.gravity", "pieces.pin"}},
    {"Mesh",
     {"prepare.simplify_to_faces", "prepare.simplify_to_error", "prepare.subdivide", "prepare.smooth",
      "prepare.turn_shells", kLine,
      "prepare.apply", "prepare.preview"}},
    {"Camera",
     {"view.frame_selected", "view.frame_all", "view.reset", kLine,
      "view.front", "view.back", "view.right", "view.left", "view.top", "view.bottom", kLine,
      "view.orthographic", kLine,
      "view.copy_camera", "view.paste_camera"}},
    {"View",
     {"view.rim_glow", "view.shading", "view.textures", "view.wire", "view.section", "view.pieces",
      "view.reset_overlays", kLine,
      ">Shadows", "view.shadows", "view.silhouette", "view.shadow_volumes", "view.shadow_counts",
      "view.shadow_facing", "view.shadow_compare", "view.shadow_rays", kLine,
      ">Mesh", "view.sizes", "view.heat", "view.normals", "view.face_numbers", "view.ghost", kLine,
      ">Structures", "view.boxes", "view.graph", "view.contacts", "view.colliders", "view.centres",
      "view.joints", kLine,
      ">Effects", "view.sparks", "view.antialias", "view.two_sided", "view.cull_backs", kLine,
      ">Window", "tab.cut", "tab.view", "tab.physics", "tab.thermal", "tab.mesh", "view.panels",
      "view.sidebar", "view.toolbar", "view.light_theme", "view.scale_up", "view.scale_down", kLine,
      "view.split"}},
    {"Help",
     {"help.palette", "help.settings", "help.shortcuts", "help.messages", "help.welcome", "help.tour", kLine,
      "help.about"}},
};
// clang-format on

const std::vector<MenuLayout> kPaletteOnly{
    {"Laser", {"laser.wider", "laser.narrower", "laser.pattern_volume", "laser.pattern_rays"}},
    {"Resolution",
     {"resolution.finer", "resolution.coarser", "resolution.by_edge_length", "resolution.by_tolerance",
      "resolution.by_depth", "resolution.one_to_four", "resolution.longest_edge", "resolution.rim_faces",
      "resolution.rim_smooth", "resolution.live"}},
    {"Knife", {"knife.line", "knife.lasso", "knife.polyline"}},
    {"Step Mode", {"stages.faster", "stages.slower"}},
    {"Tree", {"tree.next_node", "tree.previous_node", "tree.show_query"}},
    {"Light", {"light.preset", "light.add", "light.remove", "light.next", "light.paper_look"}},
    {"Pieces", {"pieces.select_one", "pieces.explode_more", "pieces.explode_less"}},
    {"File", {"file.frame"}},
    {"Graph", {"graph.export"}},
    {"Tree",
     {"tree.leaves_only", "tree.hit_only", "tree.one_level", "tree.path", "tree.level_more",
      "tree.level_less", "tree.colours"}},
    {"View",
     {"scalar_map.paint", "scalar_map.level", "scalar_map.longest_edge", "scalar_map.min_angle",
      "scalar_map.temperature", "scalar_map.rim_distance", "scalar_map.deviation", "scalar_map.compare"}},
    {"Ruler", {"ruler.undo", "ruler.redo", "ruler.export"}},
    {"View",
     {"section.flip", "section.across_x", "section.across_y", "section.across_z", "section.face_view",
      "section.copy", "section.paste", "section.cut"}},
};

constexpr const char* kPieceContext[] = {
    "view.frame_selected", "pieces.hide",      "pieces.isolate", "pieces.rename", kLine, "pieces.move",
    "pieces.rotate",       "pieces.duplicate", "pieces.copy",    "pieces.delete", kLine, "pieces.pin",
    "pieces.export"};
constexpr const char* kViewContext[] = {"view.frame_all",    "view.reset",      kLine, "pieces.paste",
                                        "pieces.select_all", "pieces.show_all", kLine, "edit.undo",
                                        "edit.redo"};

constexpr const char* kGestures[] = {"cut",          "cut_line",      "cut_polyline",
                                     "select",       "select_box",    "select_more",
                                     "move_piece",   "pull_piece",    "add_point",
                                     "move_point",   "place_drawing", "move_emitter",
                                     "rename",       "orbit",         "pan",
                                     "move_section", "move_light",    "zoom",
                                     "context",      "fit_graph",     "look_along_axis",
                                     "escape"};

const std::array<BindingPreset, 2> kPresets{{
    {"Kerf", "Replaces all shortcuts by the default ones.", {}},
    {"Blender",
     "Keys of Blender where Kerf has the same action, such as X, N, F3, Alt+H and Shift+Z.",
     {{"pieces.show_all", "Alt+H"},
      {"pieces.delete", "X"},
      {"view.shadow_compare", "Shift+X"},
      {"view.sidebar", "N"},
      {"view.normals", "Shift+N"},
      {"help.palette", "F3"},
      {"view.wire", "Shift+Z"}}},
}};

// The contributions of all features by their ids.
template <typename T, typename Contribute>
std::map<std::string, T> by_id(const Features& features, const Contribute& contribute) {
  std::map<std::string, T> all;
  for (const auto& feature : features) {
    for (T& one : contribute(*feature)) {
      std::string id = one.id;
      all.emplace(std::move(id), std::move(one));
    }
  }
  return all;
}

// Moves the actions of a menu to the end of the list, except for those that no feature has.
void append_menu(const MenuLayout& menu, bool in_menu, std::map<std::string, UserAction>& actions,
                 std::vector<UserAction>& list) {
  const char* submenu = nullptr;
  for (size_t i = 0; i < menu.actions.size(); ++i) {
    if (*menu.actions[i] == MenuLayout::kSubmenu) submenu = menu.actions[i] + 1;
    if (menu.actions[i] == std::string_view(MenuLayout::kLine)) submenu = nullptr;
    const auto found = actions.find(menu.actions[i]);
    if (found == actions.end()) continue;
    UserAction action = std::move(found->second);
    action.menu = menu.title;
    action.submenu = submenu;
    action.in_menu = in_menu;
    action.ends_group =
        i + 1 < menu.actions.size() && std::string_view(menu.actions[i + 1]) == MenuLayout::kLine;
    action.set_shortcut(action.shortcut);
    list.push_back(std::move(action));
  }
}

void draw_actions(std::span<const UserAction> actions);

void draw_action(const UserAction& action) {
  if (action.items) {
    if (!ImGui::BeginMenu(action.name.c_str())) return;
    draw_actions(action.items());
    ImGui::EndMenu();
    return;
  }
  KERF_ASSERT(action.run);
  const bool checked = action.checked && action.checked();
  const char* disabled_reason = action.objection();
  const std::string name = whole_label(action.menu_name ? action.menu_name() : action.name);
  if (ImGui::MenuItem(name.c_str(), action.shortcut.c_str(), checked, disabled_reason == nullptr))
    action.run();
  if (disabled_reason != nullptr) return tooltip(disabled_reason);
  if (action.tip.empty()) return;
  const bool has_picture = action.tip_picture && ImGui::IsItemHovered();
  tooltip(action.tip.c_str(), has_picture ? action.tip_picture() : std::nullopt);
}

void draw_actions(std::span<const UserAction> actions) {
  for (size_t i = 0; i < actions.size(); ++i) {
    if (!actions[i].in_menu) continue;
    ImGui::PushID(static_cast<int>(i));
    draw_action(actions[i]);
    ImGui::PopID();
    if (actions[i].ends_group && actions[i].submenu == nullptr) ImGui::Separator();
  }
}

// Draws the actions of a menu; those of a submenu are contiguous.
void draw_menu(std::span<const UserAction> actions) {
  for (size_t begin = 0, end = 0; begin < actions.size(); begin = end) {
    const char* submenu = actions[begin].submenu;
    while (end < actions.size() && actions[end].submenu == submenu) ++end;
    const std::span<const UserAction> group = actions.subspan(begin, end - begin);
    if (submenu == nullptr) {
      draw_actions(group);
    } else if (ImGui::BeginMenu(submenu)) {
      draw_actions(group);
      ImGui::EndMenu();
    }
  }
}

bool has_menu(std::span<const UserAction> actions) {
  return std::any_of(actions.begin(), actions.end(), [](const UserAction& a) { return a.in_menu; });
}

std::vector<std::span<const UserAction>> menus_of(std::span<const UserAction> actions) {
  std::vector<std::span<const UserAction>> menus;
  for (size_t first = 0; first < actions.size();) {
    size_t end = first;
    while (end < actions.size() && std::string_view(actions[end].menu) == actions[first].menu) ++end;
    const std::span<const UserAction> menu = actions.subspan(first, end - first);
    if (has_menu(menu)) menus.push_back(menu);
    first = end;
  }
  return menus;
}

// Returns how many menus the menu bar has room for, next to the one for the others if not all of them fit.
size_t fitting_menus(std::span<const std::span<const UserAction>> menus, const char* others) {
  const auto width = [](const char* title) {
    return ImGui::CalcTextSize(title).x + 2 * ImGui::GetStyle().ItemSpacing.x;
  };
  float used = 0, room = ImGui::GetWindowWidth() - ImGui::GetCursorPosX();
  for (const auto& menu : menus) used += width(menu.front().menu);
  if (used <= room) return menus.size();
  room -= width(others);
  size_t count = 0;
  for (used = 0; count < menus.size(); ++count) {
    used += width(menus[count].front().menu);
    if (used > room) break;
  }
  return count;
}

void draw_titled_menu(std::span<const UserAction> menu) {
  if (!ImGui::BeginMenu(menu.front().menu)) return;
  draw_menu(menu);
  ImGui::EndMenu();
}

}  // namespace

std::span<const TabLayout> tab_layout() { return kTabLayout; }
std::span<const MenuLayout> menu_layout() { return kMenus; }
std::span<const MenuLayout> palette_layout() { return kPaletteOnly; }
std::span<const char* const> context_layout(bool over_piece) {
  return over_piece ? std::span<const char* const>(kPieceContext) : kViewContext;
}

std::span<const char* const> gesture_layout() { return kGestures; }

Features make_features(Workspace& workspace, const Catalogue& catalogue) {
  Features features;
  features.push_back(files_feature(workspace));
  features.push_back(recent_feature(workspace));
  features.push_back(dialogs(workspace, catalogue));
  features.push_back(welcome_feature(workspace));
  features.push_back(view_feature(workspace));
  features.push_back(light_feature(workspace));
  features.push_back(section_feature(workspace));
  features.push_back(emitter_feature(workspace));
  features.push_back(drawing_feature(workspace));
  features.push_back(path_feature(workspace));
  features.push_back(transform_feature(workspace));
  features.push_back(time_feature(workspace));
  features.push_back(inspect_feature(workspace));
  features.push_back(ruler_feature(workspace));
  features.push_back(pieces_feature(workspace));
  features.push_back(history_feature(workspace));
  features.push_back(material_feature(workspace));
  features.push_back(prepare_feature(workspace));
  features.push_back(tree_feature(workspace));
  features.push_back(scalar_map_feature(workspace));
  features.push_back(graph_feature(workspace));
  features.push_back(single_step_feature(workspace));
  features.push_back(statistics_feature(workspace));
  features.push_back(split_feature(workspace));
  features.push_back(knife_feature(workspace));
  features.push_back(laser_feature(workspace));
  return features;
}

const UserAction* find_action(std::span<const UserAction> actions, const std::string& id) {
  for (const UserAction& action : actions) {
    if (action.id == id) return &action;
  }
  return nullptr;
}

std::vector<UserAction> bind_keys(std::vector<UserAction> actions, const Bindings& bindings) {
  for (UserAction& action : actions) {
    const auto found = bindings.find(action.id);
    if (found == bindings.end() || action.items) continue;
    if (!parse_chord(found->second) && !found->second.empty()) continue;
    action.set_shortcut(found->second);
    action.also = {};
  }
  return actions;
}

const UserAction* clash_of(std::span<const UserAction> actions, const UserAction& action,
                           const KeyChord& chord) {
  for (const UserAction& other : actions) {
    const bool same_time = (other.has_key_when != nullptr) == (action.has_key_when != nullptr);
    if (other.has_key(chord) && same_time && other.id != action.id) return &other;
  }
  return nullptr;
}

void drop_default_keys(Bindings& bindings, std::span<const UserAction> usual) {
  const std::vector<UserAction> bound = bind_keys({usual.begin(), usual.end()}, bindings);
  std::erase_if(bindings, [&](const auto& binding) {
    const UserAction* action = find_action(usual, binding.first);
    return action != nullptr && action->shortcut == binding.second &&
           clash_of(bound, *action, action->also) == nullptr;
  });
}

void rebind(Bindings& bindings, std::span<const UserAction> usual, const std::string& action,
            const KeyChord& chord) {
  const std::vector<UserAction> bound = bind_keys({usual.begin(), usual.end()}, bindings);
  const UserAction* changed = find_action(bound, action);
  if (changed == nullptr) return;
  if (const UserAction* other = clash_of(bound, *changed, chord))
    bindings[other->id] = chord == other->also ? other->shortcut : "";
  bindings[action] = chord_text(chord);
  drop_default_keys(bindings, usual);
}

std::span<const BindingPreset> binding_presets() { return kPresets; }

void Catalogue::gather(const Features& features, PanelPlaces& places) {
  add_panels(features, places);
  add_actions(features);
  add_gestures(features);
}

void Catalogue::add_panels(const Features& features, PanelPlaces& places) {
  auto parts = by_id<PanelPart>(features, [](Feature& f) { return f.panel_parts(); });
  for (const TabLayout& tab : tab_layout()) {
    for (const PanelLayout& layout : tab.panels) {
      Panel panel{layout.id, layout.title, {}};
      for (const char* part : layout.parts) {
        const auto found = parts.find(part);
        if (found != parts.end()) panel.parts.push_back(std::move(found->second.draw));
      }
      panels.push_back(std::move(panel));
      places.add(layout.id, tab.tab, layout.dock, layout.unfolded);
    }
  }
  places.select_tab();
}

void Catalogue::add_actions(const Features& features) {
  auto all = by_id<UserAction>(features, [](Feature& f) { return f.actions(); });
  for (const MenuLayout& menu : menu_layout()) append_menu(menu, true, all, usual);
  for (const MenuLayout& menu : palette_layout()) append_menu(menu, false, all, usual);
  actions = usual;
}

void Catalogue::add_gestures(const Features& features) {
  const auto all = by_id<Gesture>(features, [](Feature& f) { return f.gestures(); });
  for (const char* id : gesture_layout()) {
    const auto found = all.find(id);
    if (found != all.end()) gestures.push_back(found->second);
  }
}

void Catalogue::bind(const Settings& settings, std::map<std::string, std::string>& shortcuts) {
  if (bound_ == settings.bindings && !shortcuts.empty()) return;
  bound_ = settings.bindings;
  actions = bind_keys(usual, bound_);
  shortcuts.clear();
  for (const UserAction& action : actions) shortcuts.emplace(action.id, action.shortcut);
}

void draw_menu_bar(std::span<const UserAction> actions) {
  constexpr const char* kOthers = "More";
  if (!ImGui::BeginMainMenuBar()) return;
  const std::vector<std::span<const UserAction>> menus = menus_of(actions);
  const size_t fitting = fitting_menus(menus, kOthers);
  for (size_t i = 0; i < fitting; ++i) draw_titled_menu(menus[i]);
  if (fitting < menus.size() && ImGui::BeginMenu(kOthers)) {
    for (size_t i = fitting; i < menus.size(); ++i) draw_titled_menu(menus[i]);
    ImGui::EndMenu();
  }
  ImGui::EndMainMenuBar();
}

void draw_context_menu(std::span<const UserAction> actions, bool opens, bool any_selected) {
  constexpr const char* kContext = "##context";
  if (opens) ImGui::OpenPopup(kContext);
  if (!ImGui::BeginPopup(kContext)) return;
  for (const char* id : context_layout(any_selected)) {
    if (std::string_view(id) == MenuLayout::kLine) {
      ImGui::Separator();
    } else if (const UserAction* action = find_action(actions, id)) {
      draw_action(*action);
    }
  }
  ImGui::EndPopup();
}

}  // namespace kerf
