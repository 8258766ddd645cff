#include "ui/editor/shell/layout_table.h"

#include "ui/editor/shared/features.h"
#include "ui/editor/shell/dialogs.h"

namespace kerf {

namespace {

constexpr const char* kLine = MenuLayout::kLine;

const std::vector<TabLayout> kTabLayout{
    {Tab::kCut,
     {{"laser", "Laser", true, {"laser.beam", "laser.heat", "laser.emitter"}},
      {"resolution", "Resolution", true, {"resolution.cut", "resolution.compare"}},
      {"path", "Path", false, {"path"}},
      {"pieces", "Pieces", true, {"pieces.list", "pieces.placement", "pieces.explode"}},
      {"history", "History", true, {"history"}}}},
    {Tab::kView,
     {{"view", "View", true, {"view.section", "view.switches"}},
      {"tree", "Tree", false, {"tree.boxes", "tree.query"}},
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
      "pieces.export", "file.save_viewport_image", "file.save_screenshot", kLine,
      "file.play_game", kLine,
      "file.quit"}},
    {"Edit",
     {"edit.undo", "edit.redo", kLine,
      "view.copy_camera", "view.paste_camera", kLine,
      "pieces.select_all", "pieces.hide", "pieces.show_all", "pieces.isolate", "pieces.rename",
      "pieces.delete", kLine,
      "pieces.move", "pieces.rotate", "pieces.duplicate"}},
    {"Tool",
     {"tool.laser", "tool.pick", "tool.inspect", "tool.ruler", "tool.path", kLine,
      "laser.recut", kLine,
      "stages.step_mode", "stages.step_last_cut", "stages.play", "stages.next", "stages.previous",
      "stages.finish_segment", "stages.finish_stroke"}},
    {"Path",
     {"path.run", kLine,
      "path.load", "path.save", "path.clear", "path.delete_point", kLine,
      "path.undo", "path.redo", kLine,
      "emitter.place", "emitter.fire", "emitter.remove"}},
    {"Physics",
     {"physics.play", "physics.step", "physics.slower", "physics.faster", kLine,
      "physics.gravity", "pieces.pin"}},
    {"Mesh",
     {"prepare.simplify_to_faces", "prepare.simplify_to_error", "prepare.subdivide", "prepare.smooth",
      "prepare.turn_shells", kLine,
      "prepare.apply", "prepare.preview"}},
    {"Camera",
     {"view.frame_all", "view.reset", kLine,
      "view.front", "view.back", "view.right", "view.left", "view.top", "view.bottom", kLine,
      "view.orthographic"}},
    {"View",
     {"view.shadows", "view.silhouette", "view.shadow_volumes", "view.shadow_counts", "view.shadow_facing",
      "view.shadow_compare", "view.shadow_rays", kLine,
      "view.rim_glow", "view.shading", "view.textures", "view.wire", "view.section", "view.boxes", "view.pieces",
      "view.sizes", "view.heat", "view.normals", "view.face_numbers", "view.graph", "view.contacts",
      "view.colliders", "view.centres", "view.joints", kLine,
      "view.ghost", "view.sparks", "view.antialias", kLine,
      "view.split", "tab.cut", "tab.view", "tab.physics", "tab.thermal", "tab.mesh", "view.panels",
      "view.sidebar", "view.light_theme", "view.scale_up", "view.scale_down"}},
    {"Help",
     {"help.palette", "help.settings", "help.shortcuts", "help.messages", "help.welcome", "help.tour"}},
};
// clang-format on

const std::vector<MenuLayout> kPaletteOnly{
    {"View", {"view.two_sided", "view.cull_backs"}},
    {"Laser", {"laser.wider", "laser.narrower", "laser.pattern_volume", "laser.pattern_rays"}},
    {"Resolution",
     {"resolution.finer", "resolution.coarser", "resolution.by_edge_length", "resolution.by_tolerance",
      "resolution.by_depth", "resolution.one_to_four", "resolution.longest_edge", "resolution.rim_faces",
      "resolution.rim_smooth", "resolution.live"}},
    {"Step Mode", {"stages.faster", "stages.slower"}},
    {"Tree", {"tree.next_node", "tree.previous_node", "tree.show_query"}},
    {"Light", {"light.preset", "light.add", "light.remove", "light.next", "light.paper_look"}},
    {"Pieces", {"pieces.select_one", "pieces.explode_more", "pieces.explode_less"}},
    {"File", {"file.frame"}},
    {"Tree", {"tree.leaves_only", "tree.hit_only", "tree.level_more", "tree.level_less", "tree.colours"}},
    {"View",
     {"scalar_map.paint", "scalar_map.level", "scalar_map.longest_edge", "scalar_map.min_angle",
      "scalar_map.temperature", "scalar_map.rim_distance"}},
    {"Ruler", {"ruler.undo", "ruler.redo", "ruler.export"}},
    {"View",
     {"section.flip", "section.across_x", "section.across_y", "section.across_z", "section.face_view",
      "section.copy", "section.paste"}},
};

constexpr const char* kGestures[] = {
    "cut",        "select",       "select_box", "move_piece",      "pull_piece", "add_point",
    "move_point", "move_emitter", "rename",     "orbit",           "pan",        "move_section",
    "move_light", "zoom",         "fit_graph",  "look_along_axis", "escape"};

}  // namespace

std::span<const TabLayout> tab_layout() { return kTabLayout; }
std::span<const MenuLayout> menu_layout() { return kMenus; }
std::span<const MenuLayout> palette_layout() { return kPaletteOnly; }
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
  features.push_back(laser_feature(workspace));
  return features;
}

}  // namespace kerf
