#include "ui/editor/resolution_panel.h"

#include <imgui.h>

#include <cmath>

#include "ui/editor/length_text.h"
#include "ui/editor/number_text.h"
#include "ui/editor/property.h"
#include "ui/editor/recut.h"
#include "ui/editor/viewport_input.h"

namespace kerf {

namespace {

bool rule_row(ResolutionControls& to) {
  property("Split to");
  int rule = to.rule == Resolution::Rule::kDepth ? 1 : 0;
  const bool changed = ImGui::Combo("##rule", &rule, "Edge length\0Depth\0");
  if (changed) to.rule = rule == 1 ? Resolution::Rule::kDepth : Resolution::Rule::kTargetEdge;
  tooltip(
      "What says when faces under the beam are small enough: the length of their edges, or how often they "
      "were split.");
  return changed;
}

bool reset_edge(ResolutionControls& to) {
  if (!ImGui::BeginPopupContextItem()) return false;
  const bool reset = ImGui::MenuItem("Reset to default");
  if (reset) to.edge_fraction = ResolutionControls().edge_fraction;
  ImGui::EndPopup();
  return reset;
}

bool edge_row(ResolutionControls& to, double radius) {
  property("Edge");
  // Finer to the right, as with depth.
  double halvings = -std::log2(to.edge_fraction);
  const double low = -std::log2(ResolutionControls::kMostFraction),
               high = -std::log2(ResolutionControls::kLeastFraction);
  const std::string text = length_text(radius * to.edge_fraction);
  const double before = to.edge_fraction;
  if (ImGui::SliderScalar("##edge", ImGuiDataType_Double, &halvings, &low, &high, text.c_str(),
                          ImGuiSliderFlags_NoInput)) {
    to.edge_fraction = std::exp2(-std::round(4 * halvings) / 4);
  }
  tooltip(
      "Longest edge under the beam, from twice the radius to a 32nd of it. Finer to the right: a smoother "
      "rim from more faces. Right click for the default.");
  const bool reset = reset_edge(to);
  return reset || to.edge_fraction != before;
}

bool depth_row(ResolutionControls& to) {
  property("Depth");
  const int before = to.depth;
  const char* format = to.depth == 0 ? "0: faces go whole" : to.depth == 1 ? "%d split" : "%d splits";
  ImGui::SliderInt("##depth", &to.depth, 0, ResolutionControls::kLargestDepth, format,
                   ImGuiSliderFlags_AlwaysClamp);
  tooltip(
      "How often a face under the beam is split in four. 0 turns refinement off: faces are removed whole, "
      "as in the paper's figure 3.");
  return to.depth != before;
}

void recut_row(EditorState& state, bool changed) {
  property("Last stroke");
  const char* why_not = why_no_recut(state);
  ImGui::BeginDisabled(why_not != nullptr);
  if (ImGui::Button("Cut again", {-1, 0})) state.requests.recut = true;
  ImGui::EndDisabled();
  tooltip(why_not != nullptr ? why_not : "Takes the last stroke back and cuts it at this resolution (R).");
  property("");
  ImGui::Checkbox("as the slider moves", &state.settings.live_recut);
  tooltip("Moving a slider above cuts the last stroke again: the same cut, just with different parameters.");
  if (changed && state.settings.live_recut && why_not == nullptr) state.requests.recut = true;
}

// Whether anything changed.
bool resolution_rows(ResolutionControls& to, double radius) {
  const bool changed = rule_row(to);
  const bool depth = to.rule == Resolution::Rule::kDepth;
  return (depth ? depth_row(to) : edge_row(to, radius)) || changed;
}

void faces_row(size_t faces, const char* meaning) {
  property("Faces");
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(grouped(faces).c_str());
  tooltip(meaning);
}

void split_rows(EditorState& state) {
  property("Split view");
  if (ImGui::Checkbox("two resolutions (S)", &state.split.shown)) show_split(state, state.split.shown);
  tooltip("The last stroke once more beside the picture, at a resolution of its own.");
  if (!state.split.shown) return;
  ImGui::PushID("right half");
  property("Right half");
  ImGui::Dummy({1, ImGui::GetFrameHeight()});
  if (resolution_rows(state.split.resolution, state.laser.radius)) state.picture_old = true;
  faces_row(state.shown.twin_faces, "Faces of all bodies in the right half.");
  ImGui::PopID();
}

}  // namespace

void draw_resolution_panel(EditorState& state) {
  if (!begin_properties("resolution")) return;
  const bool changed = resolution_rows(state.laser.resolution, state.laser.radius);
  recut_row(state, changed);
  faces_row(state.shown.faces, "Faces of all bodies as they stand.");
  split_rows(state);
  end_properties();
}

}  // namespace kerf
