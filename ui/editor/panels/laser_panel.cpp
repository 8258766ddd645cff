#include "ui/editor/panels/laser_panel.h"

#include <imgui.h>

#include <string>

#include "ui/editor/view/file_frames.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_format.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

constexpr double kRadiusSpan = 20;  // the slider goes from the default over this to the default times this
constexpr ImGuiSliderFlags kLogarithmic = ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp;

void reset_on_right_click(double& value, double reset) {
  if (!ImGui::BeginPopupContextItem()) return;
  if (ImGui::MenuItem("Reset to default")) value = reset;
  ImGui::EndPopup();
}

bool radius_row(LaserControls& laser, FileUnit file_unit) {
  property("Radius");
  const double before = laser.radius;
  const LengthUnit unit = label_unit(laser.default_radius, file_unit);
  double shown = laser.radius / unit.metres;
  const double low = laser.default_radius / kRadiusSpan / unit.metres;
  const double high = laser.default_radius * kRadiusSpan / unit.metres;
  const std::string format = RealFormat("%.3g ").with(unit.name);
  if (ImGui::SliderScalar("##radius", ImGuiDataType_Double, &shown, &low, &high, format.c_str(),
                          kLogarithmic)) {
    laser.radius = shown * unit.metres;
  }
  mark_last_item("radius");
  reset_on_right_click(laser.radius, laser.default_radius);
  tooltip(
      "Half the width of the cut. Ctrl+click to type a number, right click for the default. The last stroke "
      "follows while \"as the slider moves\" is on in the Resolution panel.");
  return laser.radius != before;
}

void pattern_row(LaserControls& laser) {
  property("Pattern");
  int pattern = laser.pattern == Pattern::kRays4 ? 1 : 0;
  if (ImGui::Combo("##pattern", &pattern, "Volume\0Four rays\0")) {
    laser.pattern = pattern == 1 ? Pattern::kRays4 : Pattern::kVolume;
  }
  mark_last_item("pattern");
  tooltip(
      "Volume burns everything in the beam. Four rays burns only what four parallel rays on its rim meet.");
}

}  // namespace

bool draw_laser_panel(LaserControls& laser, FileUnit unit) {
  if (!begin_properties("laser")) return false;
  const bool changed = radius_row(laser, unit);
  pattern_row(laser);
  end_properties();
  return changed;
}

}  // namespace kerf
