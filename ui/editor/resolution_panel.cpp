#include "ui/editor/resolution_panel.h"

#include <imgui.h>

#include <cmath>

#include "ui/editor/length_text.h"
#include "ui/editor/number_text.h"
#include "ui/editor/property.h"
#include "ui/editor/recut.h"

namespace kerf {

namespace {

bool rule_row(LaserControls& laser) {
  property("Split to");
  int rule = laser.rule == Resolution::Rule::kDepth ? 1 : 0;
  const bool changed = ImGui::Combo("##rule", &rule, "Edge length\0Depth\0");
  if (changed) laser.rule = rule == 1 ? Resolution::Rule::kDepth : Resolution::Rule::kTargetEdge;
  tooltip(
      "What says when faces under the beam are small enough: the length of their edges, or how often they "
      "were split.");
  return changed;
}

bool reset_edge(LaserControls& laser) {
  if (!ImGui::BeginPopupContextItem()) return false;
  const bool reset = ImGui::MenuItem("Reset to default");
  if (reset) laser.edge_fraction = LaserControls().edge_fraction;
  ImGui::EndPopup();
  return reset;
}

bool edge_row(LaserControls& laser) {
  property("Edge");
  // Finer to the right, as with depth.
  double halvings = -std::log2(laser.edge_fraction);
  const double low = -std::log2(LaserControls::kMostFraction),
               high = -std::log2(LaserControls::kLeastFraction);
  const std::string text = length_text(laser.radius * laser.edge_fraction);
  const double before = laser.edge_fraction;
  if (ImGui::SliderScalar("##edge", ImGuiDataType_Double, &halvings, &low, &high, text.c_str(),
                          ImGuiSliderFlags_NoInput)) {
    laser.edge_fraction = std::exp2(-std::round(4 * halvings) / 4);
  }
  tooltip(
      "Longest edge under the beam, from twice the radius to a 32nd of it. Finer to the right: a smoother "
      "rim from more faces. Right click for the default.");
  const bool reset = reset_edge(laser);
  return reset || laser.edge_fraction != before;
}

bool depth_row(LaserControls& laser) {
  property("Depth");
  const int before = laser.depth;
  const char* format = laser.depth == 0 ? "0: faces go whole" : laser.depth == 1 ? "%d split" : "%d splits";
  ImGui::SliderInt("##depth", &laser.depth, 0, LaserControls::kLargestDepth, format,
                   ImGuiSliderFlags_AlwaysClamp);
  tooltip(
      "How often a face under the beam is split in four. 0 turns refinement off: faces are removed whole, "
      "as in the paper's figure 3.");
  return laser.depth != before;
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

}  // namespace

void draw_resolution_panel(EditorState& state) {
  if (!begin_properties("resolution")) return;
  bool changed = rule_row(state.laser);
  const bool depth = state.laser.rule == Resolution::Rule::kDepth;
  changed = (depth ? depth_row(state.laser) : edge_row(state.laser)) || changed;
  recut_row(state, changed);
  property("Faces");
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(grouped(state.shown.faces).c_str());
  tooltip("Faces of all bodies as they stand.");
  end_properties();
}

}  // namespace kerf
