#include "ui/editor/panels/tree_panel.h"

#include <imgui.h>

#include "ui/window/number_text.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

constexpr int kAllLevels = 64;

// What a row says: what it means, or why it can do nothing.
void explain(const EditorState& state, const char* meaning) {
  tooltip(state.look.show.aabb ? meaning : "The boxes are not shown: switch them on above (B).");
}

void switch_row(EditorState& state) {
  property("Boxes");
  if (ImGui::Checkbox("shown (B)", &state.look.show.aabb)) state.picture_old = true;
  tooltip(
      "The bounding boxes that find the faces under the beam: solid where the beam is or was, dotted "
      "where it never came, as in the paper's figure 2.");
}

void depth_row(EditorState& state) {
  property("Down to");
  TreeOverlay& tree = state.look.tree;
  const int deepest = std::max(1, state.shown.tree_depth);
  int depth = std::min(tree.deepest, deepest);
  const char* format = depth == deepest ? "%d: all levels" : "level %d";
  if (ImGui::SliderInt("##depth", &depth, 0, deepest, format, ImGuiSliderFlags_AlwaysClamp)) {
    tree.deepest = depth == deepest ? kAllLevels : depth;
    state.picture_old = true;
  }
  explain(state, "Levels of the tree under its root that are drawn.");
}

void flag_row(EditorState& state, const char* name, const char* label, bool& flag, const char* meaning) {
  property(name);
  if (ImGui::Checkbox(label, &flag)) state.picture_old = true;
  explain(state, meaning);
}

void body_row(EditorState& state) {
  property("Body");
  const World& world = state.document.world();
  std::optional<BodyId>& only = state.look.tree.body;
  if (only && !world.contains(*only)) only.reset();
  const std::vector<BodyId> ids = world.ids();
  const bool one = ids.size() < 2;
  ImGui::BeginDisabled(one);
  if (ImGui::BeginCombo("##body", only ? world.body(*only).name.c_str() : "all bodies")) {
    if (ImGui::Selectable("all bodies", !only)) only.reset(), state.picture_old = true;
    for (const BodyId id : ids) {
      ImGui::PushID(static_cast<int>(id.slot));
      if (ImGui::Selectable(world.body(id).name.c_str(), only == id)) only = id, state.picture_old = true;
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  ImGui::EndDisabled();
  explain(state, one ? "There is only one body." : "The body whose tree is drawn.");
}

void palette_row(EditorState& state) {
  property("Colours");
  int palette = state.settings.palette == BoxPalette::kOrangeAndBlue ? 1 : 0;
  if (ImGui::Combo("##palette", &palette, "Red and green\0Orange and blue\0")) {
    state.settings.palette = palette == 1 ? BoxPalette::kOrangeAndBlue : BoxPalette::kRedAndGreen;
    state.picture_old = true;
  }
  tooltip(
      "Orange and blue can be told apart by the colour-blind; the accent of the panels turns blue with it.");
}

void figure_row(const char* name, const std::string& value, const char* meaning) {
  property(name);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(value.c_str());
  tooltip(meaning);
}

}  // namespace

void draw_tree_panel(EditorState& state) {
  if (!begin_properties("tree")) return;
  switch_row(state);
  ImGui::BeginDisabled(!state.look.show.aabb);
  depth_row(state);
  TreeOverlay& tree = state.look.tree;
  flag_row(state, "Only", "leaves", tree.leaves_only, "Only the boxes that hold one face.");
  flag_row(state, "", "where the beam was", tree.hit_only, "Only the boxes in which the beam is or was.");
  body_row(state);
  ImGui::EndDisabled();
  palette_row(state);
  const ShownFigures& shown = state.shown;
  figure_row("Nodes", grouped(shown.tree_nodes) + ", depth " + std::to_string(shown.tree_depth),
             "Boxes of all trees, and levels under the root of the deepest.");
  figure_row("Tested",
             shown.faces_of_step == 0
                 ? "nothing cut yet"
                 : grouped(shown.faces_tested) + " of " + grouped(shown.faces_of_step) + " faces",
             "Faces that the last step looked at one by one, of all there were: the tree spares the rest.");
  end_properties();
}

}  // namespace kerf
