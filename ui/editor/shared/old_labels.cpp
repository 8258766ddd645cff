#include "ui/editor/shared/old_labels.h"

#include <array>
#include <span>
#include <string>
#include "core/base/json.h"

namespace kerf {

namespace {

struct OldLabel {
  const char *label, *id;
};

constexpr OldLabel kOldActions[] = {
    {"New", "file.new"},
    {"Open...", "file.open"},
    {"Save", "file.save"},
    {"Save as...", "file.save_as"},
    {"Save the picture", "file.save_viewport_image"},
    {"Save the window", "file.save_screenshot"},
    {"Play the game", "file.play_game"},
    {"Quit", "file.quit"},
    {"Undo", "edit.undo"},
    {"Redo", "edit.redo"},
    {"Copy the view", "view.copy_camera"},
    {"Paste the view", "view.paste_camera"},
    {"Choose all pieces", "pieces.select_all"},
    {"Hide the chosen", "pieces.hide"},
    {"Show all pieces", "pieces.show_all"},
    {"Isolate the chosen", "pieces.isolate"},
    {"Rename the chosen", "pieces.rename"},
    {"Delete the chosen", "pieces.delete"},
    {"Export chosen pieces...", "pieces.export"},
    {"Pieces further apart", "pieces.explode_more"},
    {"Pieces nearer together", "pieces.explode_less"},
    {"Move the chosen", "pieces.move"},
    {"Rotate the chosen", "pieces.rotate"},
    {"Duplicate the chosen", "pieces.duplicate"},
    {"Pin the chosen", "pieces.pin"},
    {"Laser", "tool.laser"},
    {"Pick pieces", "tool.pick"},
    {"Inspect and measure", "tool.inspect"},
    {"Ruler", "tool.ruler"},
    {"Path", "tool.path"},
    {"Cut the last stroke again", "laser.recut"},
    {"Wider beam", "laser.wider"},
    {"Narrower beam", "laser.narrower"},
    {"Pattern: volume", "laser.pattern_volume"},
    {"Pattern: four rays", "laser.pattern_rays"},
    {"Finer cut", "resolution.finer"},
    {"Coarser cut", "resolution.coarser"},
    {"Split to edge length", "resolution.by_edge_length"},
    {"Split to tolerance", "resolution.by_tolerance"},
    {"Split to depth", "resolution.by_depth"},
    {"Scheme: one to four", "resolution.one_to_four"},
    {"Scheme: longest edge", "resolution.longest_edge"},
    {"Rim: faces", "resolution.rim_faces"},
    {"Rim: smooth", "resolution.rim_smooth"},
    {"Cut again as the slider moves", "resolution.live"},
    {"Run the path", "path.run"},
    {"Load a path...", "path.load"},
    {"Save the path...", "path.save"},
    {"Clear the path", "path.clear"},
    {"Remove the point", "path.delete_point"},
    {"Undo the edit of the path", "path.undo"},
    {"Redo the edit of the path", "path.redo"},
    {"Place the emitter", "emitter.place"},
    {"Fire the emitter", "emitter.fire"},
    {"Take the emitter away", "emitter.remove"},
    {"Single steps", "stages.step_mode"},
    {"Step through the last stroke", "stages.step_last_cut"},
    {"Play the stages", "stages.play"},
    {"Next stage", "stages.next"},
    {"Stage back", "stages.previous"},
    {"Finish the move", "stages.finish_segment"},
    {"Finish the stroke", "stages.finish_stroke"},
    {"Stages: faster", "stages.faster"},
    {"Stages: slower", "stages.slower"},
    {"Query: next box", "tree.next_node"},
    {"Query: box before", "tree.previous_node"},
    {"Query: show the boxes", "tree.show_query"},
    {"Play", "physics.play"},
    {"One tick", "physics.step"},
    {"Time: slower", "physics.slower"},
    {"Time: faster", "physics.faster"},
    {"Gravity", "physics.gravity"},
    {"Simplify to faces", "prepare.simplify_to_faces"},
    {"Simplify to an error", "prepare.simplify_to_error"},
    {"Subdivide", "prepare.subdivide"},
    {"Smooth", "prepare.smooth"},
    {"Turn inner shells", "prepare.turn_shells"},
    {"Prepare the mesh", "prepare.apply"},
    {"Preview of the preparation", "prepare.preview"},
    {"Frame all", "view.frame_all"},
    {"First view", "view.reset"},
    {"Front", "view.front"},
    {"Back", "view.back"},
    {"Right", "view.right"},
    {"Left", "view.left"},
    {"Top", "view.top"},
    {"Bottom", "view.bottom"},
    {"Orthographic", "view.orthographic"},
    {"Shadows: none, ground, all", "view.shadows"},
    {"Silhouette", "view.silhouette"},
    {"Shadow volumes", "view.shadow_volumes"},
    {"Shadow counts", "view.shadow_counts"},
    {"Facing the light", "view.shadow_facing"},
    {"Compare two shadow methods", "view.shadow_compare"},
    {"Trace shadow rays", "view.shadow_rays"},
    {"Glow of rims", "view.rim_glow"},
    {"Shading: by angle, smooth, flat", "view.shading"},
    {"Wire", "view.wire"},
    {"Section plane", "view.section"},
    {"Boxes of the tree", "view.boxes"},
    {"Piece colours", "view.pieces"},
    {"Level colouring", "view.sizes"},
    {"Temperature", "view.heat"},
    {"Normals", "view.normals"},
    {"Face numbers", "view.face_numbers"},
    {"Component graph", "view.graph"},
    {"Contacts", "view.contacts"},
    {"Colliders", "view.colliders"},
    {"Centres of mass", "view.centres"},
    {"Joints", "view.joints"},
    {"Ghost of what is gone", "view.ghost"},
    {"Two-sided lighting", "view.two_sided"},
    {"Cull backs", "view.cull_backs"},
    {"Sparks and smoke", "view.sparks"},
    {"Anti-aliasing", "view.antialias"},
    {"Split view", "view.split"},
    {"Column of panels", "view.sidebar"},
    {"Light theme", "view.light_theme"},
    {"Larger text", "view.scale_up"},
    {"Smaller text", "view.scale_down"},
    {"Tab: Cut", "tab.cut"},
    {"Tab: Look", "tab.view"},
    {"Tab: Move", "tab.physics"},
    {"Tab: Heat", "tab.thermal"},
    {"Tab: Prepare", "tab.mesh"},
    {"Command palette", "help.palette"},
    {"Settings", "help.settings"},
    {"Shortcuts", "help.shortcuts"},
    {"Messages", "help.messages"},
    {"Welcome", "help.welcome"},
    {"The first five minutes", "help.tour"},
    {"Add a light", "light.add"},
    {"Remove the chosen light", "light.remove"},
    {"Next light", "light.next"},
    {"Shadows: paper look", "light.paper_look"},
    {"Boxes: leaves only", "tree.leaves_only"},
    {"Boxes: only where the beam was", "tree.hit_only"},
    {"Boxes: one level more", "tree.level_more"},
    {"Boxes: one level less", "tree.level_less"},
    {"Boxes: orange and blue", "tree.colours"},
    {"Section plane: flip", "section.flip"},
    {"Section plane: across X", "section.across_x"},
    {"Section plane: across Y", "section.across_y"},
    {"Section plane: across Z", "section.across_z"},
    {"Section plane: parallel to the picture", "section.face_view"},
    {"Section plane: copy", "section.copy"},
    {"Section plane: paste", "section.paste"},
    {"Colour faces by: paint", "scalar_map.paint"},
    {"Colour faces by: level", "scalar_map.level"},
    {"Colour faces by: longest edge", "scalar_map.longest_edge"},
    {"Colour faces by: least angle", "scalar_map.min_angle"},
    {"Colour faces by: temperature", "scalar_map.temperature"},
    {"Colour faces by: distance to the rim", "scalar_map.rim_distance"},
    {"Undo the edit of distances", "ruler.undo"},
    {"Redo the edit of distances", "ruler.redo"},
    {"Export the distances...", "ruler.export"},
};

constexpr OldLabel kOldPanels[] = {
    {"Laser", "laser"},
    {"Resolution", "resolution"},
    {"Path", "path"},
    {"Pieces", "pieces"},
    {"History", "history"},
    {"View", "view"},
    {"Tree", "tree"},
    {"Scalar map", "scalar_map"},
    {"Graph", "graph"},
    {"Single step", "single_step"},
    {"Light", "light"},
    {"Ruler", "ruler"},
    {"Statistics", "statistics"},
    {"Display", "display"},
    {"Bodies", "bodies"},
    {"Material", "material"},
    {"Prepare", "prepare"},
    {"File", "file"},
};

constexpr OldLabel kOldTabs[] = {
    {"look", "view"}, {"move", "physics"}, {"heat", "thermal"}, {"prepare", "mesh"}};

std::string id_of_label(std::span<const OldLabel> labels, const std::string& label) {
  for (const OldLabel& old : labels) {
    if (label == old.label) return old.id;
  }
  return label;
}

void convert_keys(nlohmann::json& settings, const char* field, std::span<const OldLabel> labels) {
  const auto found = settings.find(field);
  if (found == settings.end() || !found->is_object()) return;
  nlohmann::json converted = nlohmann::json::object();
  for (const auto& [label, value] : found->items()) converted[id_of_label(labels, label)] = value;
  *found = std::move(converted);
}

}  // namespace

void convert_labels(nlohmann::json& settings) {
  convert_keys(settings, "bindings", kOldActions);
  for (const char* field : {"panels", "docks", "windows"}) convert_keys(settings, field, kOldPanels);
  const auto tab = settings.find("tab");
  if (tab != settings.end() && tab->is_string()) *tab = id_of_label(kOldTabs, *tab);
}

}  // namespace kerf
