#include "ui/editor/shared/feature.h"

#include <imgui.h>

#include <algorithm>

#include "ui/editor/shared/panel_rows.h"
#include "ui/window/number_text.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr int kAllLevels = 64;

// Returns the tooltip of a row, or the reason why it has no effect.
std::string explanation(const ViewState& view, const char* meaning) {
  if (view.look.show.aabb) return meaning;
  return with_shortcut(view, "The boxes are hidden: turn on AABB Tree above.",
                       action_id(view_switch(SwitchId::kBoxes)));
}

void explain(const ViewState& view, const char* meaning) { tooltip(explanation(view, meaning).c_str()); }

void depth_row(ViewState& view, int tree_depth) {
  property("Max. Depth");
  TreeOverlay& tree = view.look.tree;
  const int deepest = std::max(1, tree_depth);
  int depth = std::min(tree.deepest, deepest);
  const std::string text =
      depth == deepest ? std::to_string(depth) + ": all" : "level " + std::to_string(depth);
  const std::string meaning = explanation(view, "Number of levels drawn below the root of the tree.");
  if (whole_slider({"Max. Depth", "##depth", meaning.c_str()}, depth, 0, deepest, text)) {
    tree.deepest = depth == deepest ? kAllLevels : depth;
    view.picture_old = true;
  }
}

void flag_row(ViewState& view, const char* name, const char* label, bool& flag, const char* meaning) {
  property(name);
  if (ImGui::Checkbox(label, &flag)) view.picture_old = true;
  explain(view, meaning);
}

void body_row(ViewState& view, const World& world) {
  property("Body");
  std::optional<BodyId>& only = view.look.tree.body;
  if (only && !world.contains(*only)) only.reset();
  const std::vector<BodyId> ids = world.ids();
  const bool one = ids.size() < 2;
  ImGui::BeginDisabled(one);
  if (begin_fitted_combo("##body", only ? world.body(*only).own_name() : "All Bodies")) {
    if (ImGui::Selectable("All Bodies", !only)) only.reset(), view.picture_old = true;
    for (const BodyId id : ids) {
      ImGui::PushID(static_cast<int>(id.slot));
      if (ImGui::Selectable(world.body(id).own_name().c_str(), only == id))
        only = id, view.picture_old = true;
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  ImGui::EndDisabled();
  explain(view, one ? "There is only one body." : "Draws the tree of this body only.");
}

void palette_row(ViewState& view, Settings& settings) {
  if (choice_row(
          "Colours", "##palette", settings.palette, "Red and Green\0Orange and Blue\0", nullptr,
          "Orange and blue suit colour-blind users; the accent colour of the panels then becomes blue."))
    view.picture_old = true;
}

// A stroke queries the tree once or a few times for each move of the beam.
void query_rows(const ShownStatistics& shown) {
  std::string per_query = "-", per_stroke = per_query;
  if (shown.stroke) {
    const size_t queries = shown.stroke->statistics.queries, tested = shown.stroke->statistics.tested.faces;
    per_query = grouped(tested / std::max<size_t>(1, queries)) + " of " + count_text(shown.faces, "face");
    per_stroke = grouped(tested) + " in " + grouped(queries) + (queries == 1 ? " query" : " queries");
  }
  figure_row("Per Query", per_query,
             "Average number of faces tested per query of the last stroke; the tree skips the others.");
  figure_row("Per Stroke", per_stroke,
             "Faces tested by all queries of the last stroke. Faces near the beam are tested repeatedly.");
}

void figure_rows(const ShownStatistics& shown) {
  const std::string depth = shown.tree_depth ? ", depth " + std::to_string(*shown.tree_depth) : "";
  figure_row("Nodes", grouped(shown.tree_nodes) + depth,
             "Number of boxes in all trees, and depth of the deepest tree.");
  query_rows(shown);
}

void draw_tree_panel(ViewState& view, const World& world, Settings& settings, const ShownStatistics& shown) {
  if (!begin_properties("tree")) return;
  property("AABB Tree");
  draw_switch(view, SwitchId::kBoxes, "Show");
  ImGui::BeginDisabled(!view.look.show.aabb);
  depth_row(view, shown.tree_depth.value_or(0));
  TreeOverlay& tree = view.look.tree;
  flag_row(view, "Only", "Leaf Nodes", tree.leaves_only, "Draws only the boxes of single faces.");
  flag_row(view, "", "Hit Nodes", tree.hit_only, "Draws only the boxes visited by the beam.");
  body_row(view, world);
  ImGui::EndDisabled();
  palette_row(view, settings);
  figure_rows(shown);
  end_properties();
}

UserAction level_action(ViewState& view, const ShownStatistics& shown, const char* id, const char* name,
                        int by) {
  UserAction action = picture_action(view, id, name, "Number of levels drawn below the root of the tree.",
                                     [&view, &shown, by] {
                                       const int all = std::max(1, shown.tree_depth.value_or(1));
                                       int& deepest = view.look.tree.deepest;
                                       deepest = std::max(0, std::min(deepest, all) + by);
                                     });
  action.disabled_reason = [&view] {
    return view.look.show.aabb ? nullptr : "The boxes are hidden: turn on AABB Tree.";
  };
  return action;
}

UserAction palette_action(ViewState& view, BoxPalette& palette) {
  UserAction action = picture_action(
      view, "tree.colours", "Orange and Blue Nodes",
      "Draws boxes in orange and blue, for colour-blind users, instead of red and green.", [&palette] {
        palette = palette == BoxPalette::kRedAndGreen ? BoxPalette::kOrangeAndBlue : BoxPalette::kRedAndGreen;
      });
  action.checked = [&palette] { return palette == BoxPalette::kOrangeAndBlue; };
  return action;
}

class TreeFeature : public Feature {
 public:
  TreeFeature(const DocumentSession& session, ViewState& view, Settings& settings, Services& services)
      : session_(session), view_(view), settings_(settings), services_(services) {}

  std::vector<PanelPart> panel_parts() override {
    return {{"tree.boxes",
             [this] { draw_tree_panel(view_, session_.world(), settings_, services_.statistics.shown); }}};
  }
  std::vector<UserAction> actions() override {
    TreeOverlay& tree = view_.look.tree;
    return {flag_action(view_, "tree.leaves_only", "Leaf Nodes Only", tree.leaves_only,
                        "Draws only the boxes of single faces."),
            flag_action(view_, "tree.hit_only", "Hit Nodes Only", tree.hit_only,
                        "Draws only the boxes visited by the beam."),
            level_action(view_, services_.statistics.shown, "tree.level_more", "Show One More Level", 1),
            level_action(view_, services_.statistics.shown, "tree.level_less", "Show One Less Level", -1),
            palette_action(view_, settings_.palette)};
  }
  void update(double) override { services_.statistics.depth_wanted = services_.panels.shows("tree"); }
  void on_world_changed(const Delta&) override {
    std::optional<BodyId>& body = view_.look.tree.body;
    if (body && !session_.world().contains(*body)) body.reset();
  }
  void on_document_opened() override { view_.look.tree.body.reset(); }

 private:
  const DocumentSession& session_;
  ViewState& view_;
  Settings& settings_;
  Services& services_;
};

}  // namespace

std::unique_ptr<Feature> tree_feature(Workspace& workspace) {
  return std::make_unique<TreeFeature>(workspace.session, workspace.view, workspace.settings,
                                       workspace.services);
}

}  // namespace kerf
