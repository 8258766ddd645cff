#include "ui/editor/shared/feature.h"

#include <imgui.h>

#include <algorithm>

#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr int kAllLevels = 64;
constexpr int kFirstLevel = 3;  // drawn when "One Level" is turned on

// Returns the tooltip of a row, or the reason why it has no effect.
std::string explanation(const ViewState& view, const char* meaning) {
  if (view.look.show.aabb) return meaning;
  return with_shortcut(view, "The boxes are hidden: turn on AABB Tree above.",
                       action_id(view_switch(SwitchId::kBoxes)));
}

void explain(const ViewState& view, const char* meaning) { tooltip(explanation(view, meaning).c_str()); }

// The depth of the deepest tree, at least 1.
int depth_of(const ShownStatistics& shown) {
  return shown.tree ? std::max(1, static_cast<int>(shown.tree->levels.size()) - 1) : 1;
}

// Sets the number of levels, 0 to `all`. A tree of which all levels are drawn keeps them all as it grows.
void set_depth(TreeOverlay& tree, int depth, int all) {
  tree.deepest = depth == all && !tree.one_level ? kAllLevels : depth;
}

std::string text_of_level(const TreeLevel& level) {
  return grouped(level.boxes) + (level.boxes == 1 ? " box" : " boxes") + ", " +
         text_of("%.3g", level.visits) + " visited per random line, overlap " +
         text_of("%.3g", level.overlap) + (level.edited > 0 ? ", " + grouped(level.edited) + " edited" : "");
}

void depth_row(ViewState& view, const ShownStatistics& shown) {
  TreeOverlay& tree = view.look.tree;
  property(tree.one_level ? "Level" : "Max. Depth");
  const int deepest = depth_of(shown);
  int depth = std::min(tree.deepest, deepest);
  std::string text = depth == deepest ? std::to_string(depth) + ": all" : "level " + std::to_string(depth);
  if (tree.one_level) text = std::to_string(depth);
  const std::string meaning = explanation(view, "Number of levels drawn below the root of the tree.");
  if (whole_slider({"Max. Depth", "##depth", meaning.c_str()}, depth, 0, deepest, text)) {
    set_depth(tree, depth, deepest);
    view.picture_old = true;
  }
  if (!tree.one_level || !shown.tree || static_cast<size_t>(depth) >= shown.tree->levels.size()) return;
  figure_row("Boxes", grouped(shown.tree->levels[static_cast<size_t>(depth)].boxes),
             "Boxes of all trees at this level.");
}

// Draws the expected visits of each level as bars; a click shows the boxes of a level.
void draw_histogram(ViewState& view, const TreeStatistics& statistics) {
  property("Levels");
  const float em = ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x, height = 4 * em;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("##levels", {width, height});
  mark_last_item("tree levels");
  const bool hovered = ImGui::IsItemHovered(), clicked = ImGui::IsItemClicked();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg), 3);
  double most = 0;
  for (const TreeLevel& level : statistics.levels) most = std::max(most, level.visits);
  const float step = width / static_cast<float>(statistics.levels.size());
  const auto under = static_cast<size_t>(std::max(0.0f, (ImGui::GetIO().MousePos.x - at.x) / step));
  const TreeOverlay& tree = view.look.tree;
  for (size_t depth = 0; depth < statistics.levels.size(); ++depth) {
    const TreeLevel& level = statistics.levels[depth];
    const float left = at.x + step * static_cast<float>(depth) + 1, right = left + std::max(1.0f, step - 2);
    const auto top = [&](double value) {
      return at.y + height - (height - 0.3f * em) * static_cast<float>(most > 0 ? value / most : 0);
    };
    const bool lit = (hovered && depth == under) ||
                     (tree.one_level && static_cast<size_t>(std::max(0, tree.deepest)) == depth);
    list.AddRectFilled({left, top(level.visits)}, {right, at.y + height},
                       lit ? colours::accent() : colours::secondary());
    list.AddRectFilled({left, top(std::min(level.overlap, level.visits))}, {right, at.y + height},
                       colours::text());
  }
  if (!hovered || under >= statistics.levels.size()) return;
  const std::string name = "Level " + std::to_string(under) + ": ";
  ImGui::SetTooltip("%s", (name + text_of_level(statistics.levels[under]) + ". Click to show.").c_str());
  if (!clicked) return;
  view.look.show.aabb = true;
  view.look.tree.one_level = true;
  view.look.tree.deepest = static_cast<int>(under);
  view.picture_old = true;
}

void draw_shape(ViewState& view, const ShownStatistics& shown) {
  if (!shown.tree || shown.tree->levels.empty() || !begin_properties("tree shape")) return;
  const TreeStatistics& tree = *shown.tree;
  figure_row("Cost", text_of("%.3g boxes per line", tree.cost()),
             "Expected number of boxes that a random line through the bounds visits: the surface area "
             "heuristic.");
  figure_row("Overlap", text_of("%.3g pairs per line", tree.overlap()),
             "Expected number of pairs of sibling boxes that a random line visits where they overlap.");
  figure_row("Edited", grouped(tree.edited()) + (tree.edited() == 1 ? " leaf" : " leaves"),
             "Boxes of faces that cuts have split or added.");
  draw_histogram(view, tree);
  end_properties();
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
      if (ImGui::Selectable(whole_label(world.body(id).own_name()).c_str(), only == id))
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
  const std::string depth = shown.tree ? ", depth " + std::to_string(depth_of(shown)) : "";
  figure_row("Nodes", grouped(shown.tree_nodes) + depth,
             "Number of boxes in all trees, and depth of the deepest tree.");
  query_rows(shown);
}

void draw_tree_panel(ViewState& view, const World& world, Settings& settings, const ShownStatistics& shown,
                     bool& path_shown) {
  if (!begin_properties("tree")) return;
  property("AABB Tree");
  draw_switch(view, SwitchId::kBoxes, "Show");
  ImGui::BeginDisabled(!view.look.show.aabb);
  depth_row(view, shown);
  TreeOverlay& tree = view.look.tree;
  flag_row(view, "Only", "Leaf Nodes", tree.leaves_only, "Draws only the boxes of single faces.");
  flag_row(view, "", "Hit Nodes", tree.hit_only, "Draws only the boxes hit by the beam.");
  flag_row(view, "", "One Level", tree.one_level, "Draws only the boxes of one level.");
  flag_row(view, "Pointer", "Path to Face", path_shown,
           "Draws the boxes from the root to the face under the pointer.");
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
                                       if (!shown.tree) return;
                                       TreeOverlay& tree = view.look.tree;
                                       const int all = depth_of(shown);
                                       const int depth = std::min(tree.deepest, all) + by;
                                       set_depth(tree, std::clamp(depth, 0, all), all);
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
  explicit TreeFeature(Workspace& workspace)
      : workspace_(workspace),
        session_(workspace.session),
        view_(workspace.view),
        settings_(workspace.settings),
        services_(workspace.services) {}

  std::vector<PanelPart> panel_parts() override {
    const ShownStatistics& shown = services_.statistics.shown;
    return {{"tree.boxes",
             [this, &shown] { draw_tree_panel(view_, session_.world(), settings_, shown, path_shown_); }},
            {"tree.shape", [this, &shown] { draw_shape(view_, shown); }}};
  }
  std::vector<UserAction> actions() override {
    TreeOverlay& tree = view_.look.tree;
    return {flag_action(view_, "tree.leaves_only", "Leaf Nodes Only", tree.leaves_only,
                        "Draws only the boxes of single faces."),
            flag_action(view_, "tree.one_level", "One Level of the Tree", tree.one_level,
                        "Draws only the boxes of one level."),
            flag_action(view_, "tree.path", "Path to the Face under the Pointer", path_shown_,
                        "Draws the boxes from the root to the face under the pointer."),
            flag_action(view_, "tree.hit_only", "Hit Nodes Only", tree.hit_only,
                        "Draws only the boxes hit by the beam."),
            level_action(view_, services_.statistics.shown, "tree.level_more", "Show One More Level", 1),
            level_action(view_, services_.statistics.shown, "tree.level_less", "Show One Level Less", -1),
            palette_action(view_, settings_.palette)};
  }
  void update(double) override {
    services_.statistics.tree_wanted = services_.panels.shows("tree") || view_.look.show.aabb;
    TreeOverlay& tree = view_.look.tree;
    if (tree.one_level && tree.deepest == kAllLevels) tree.deepest = kFirstLevel, view_.picture_old = true;
    std::optional<FaceOfBody> face;
    if (path_shown_ && view_.look.show.aabb && !workspace_.changes.is_pending())
      face = face_under_pointer(workspace_);
    if (face == view_.look.tree_path) return;
    view_.look.tree_path = face;
    view_.picture_old = true;
  }
  void on_world_changed(const Delta&) override {
    std::optional<BodyId>& body = view_.look.tree.body;
    if (body && !session_.world().contains(*body)) body.reset();
  }
  void on_document_opened() override {
    view_.look.tree.body.reset();
    view_.look.tree_path.reset();
  }

 private:
  Workspace& workspace_;
  const DocumentSession& session_;
  ViewState& view_;
  Settings& settings_;
  Services& services_;
  bool path_shown_ = false;
};

}  // namespace

std::unique_ptr<Feature> tree_feature(Workspace& workspace) {
  return std::make_unique<TreeFeature>(workspace);
}

}  // namespace kerf
