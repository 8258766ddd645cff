#include "ui/editor/laser_panel.h"

#include <imgui.h>

#include <cmath>
#include <string>

#include "ui/editor/length_text.h"
#include "ui/editor/property.h"

namespace kerf {

namespace {

constexpr double kRadiusSpan = 20;  // the slider goes from the default over this to the default times this
constexpr ImGuiSliderFlags kLogarithmic = ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp;

void reset_on_right_click(double& value, double reset) {
  if (!ImGui::BeginPopupContextItem()) return;
  if (ImGui::MenuItem("Reset to default")) value = reset;
  ImGui::EndPopup();
}

void radius_row(LaserControls& laser) {
  property("Radius");
  const LengthUnit unit = unit_for(laser.default_radius);
  double shown = laser.radius / unit.metres;
  const double low = laser.default_radius / kRadiusSpan / unit.metres;
  const double high = laser.default_radius * kRadiusSpan / unit.metres;
  const std::string format = std::string("%.3g ") + unit.name;
  if (ImGui::SliderScalar("##radius", ImGuiDataType_Double, &shown, &low, &high, format.c_str(),
                          kLogarithmic)) {
    laser.radius = shown * unit.metres;
  }
  reset_on_right_click(laser.radius, laser.default_radius);
  tooltip("Half the width of the cut. Ctrl+click to type a number, right click for the default.");
}

void rule_row(LaserControls& laser) {
  property("Resolution");
  int rule = laser.rule == Resolution::Rule::kDepth ? 1 : 0;
  if (ImGui::Combo("##rule", &rule, "Target edge\0Depth\0")) {
    laser.rule = rule == 1 ? Resolution::Rule::kDepth : Resolution::Rule::kTargetEdge;
  }
  tooltip(
      "What says when faces under the beam are small enough: the length of their edges, or how often they "
      "were split.");
}

void edge_row(LaserControls& laser) {
  property("Edge");
  // Finer to the right, as with depth.
  double halvings = -std::log2(laser.edge_fraction);
  const double low = -std::log2(LaserControls::kMostFraction),
               high = -std::log2(LaserControls::kLeastFraction);
  const std::string text = length_text(laser.radius * laser.edge_fraction);
  if (ImGui::SliderScalar("##edge", ImGuiDataType_Double, &halvings, &low, &high, text.c_str(),
                          ImGuiSliderFlags_NoInput)) {
    laser.edge_fraction = std::exp2(-std::round(4 * halvings) / 4);
  }
  reset_on_right_click(laser.edge_fraction, LaserControls().edge_fraction);
  tooltip(
      "Longest edge under the beam, from twice the radius to a 32nd of it. Finer to the right: a smoother "
      "rim "
      "from more faces.");
}

void depth_row(LaserControls& laser) {
  property("Depth");
  ImGui::SliderInt("##depth", &laser.depth, 0, LaserControls::kLargestDepth,
                   laser.depth == 1 ? "%d split" : "%d splits", ImGuiSliderFlags_AlwaysClamp);
  tooltip("How often a face under the beam is split in four. 0 removes faces whole.");
}

void pattern_row(LaserControls& laser) {
  property("Pattern");
  int pattern = laser.pattern == Pattern::kRays4 ? 1 : 0;
  if (ImGui::Combo("##pattern", &pattern, "Volume\0Four rays\0")) {
    laser.pattern = pattern == 1 ? Pattern::kRays4 : Pattern::kVolume;
  }
  tooltip(
      "Volume burns everything in the beam. Four rays burns only what four parallel rays on its rim meet.");
}

}  // namespace

void draw_laser_panel(EditorState& state) {
  if (!begin_properties("laser")) return;
  radius_row(state.laser);
  rule_row(state.laser);
  if (state.laser.rule == Resolution::Rule::kDepth) {
    depth_row(state.laser);
  } else {
    edge_row(state.laser);
  }
  pattern_row(state.laser);
  end_properties();
}

}  // namespace kerf
