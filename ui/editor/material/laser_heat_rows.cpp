#include "ui/editor/material/laser_heat_rows.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "core/heat/lumped_cut.h"

#include "ui/editor/shared/files/file_frames.h"
#include "ui/editor/shared/panels/panel_rows.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_format.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

constexpr double kMostRadii = 100;  // that heat can be wide
constexpr ImGuiSliderFlags kPowerSlider = ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp;

std::string energy_label(double joules) {
  return joules >= 1000 ? text_of("%.3g kJ", joules / 1000) : text_of("%.3g J", joules);
}

void model_row(LaserControls& laser) {
  constexpr std::array kNames{"Geometric", "Thermal"};  // in the order of Model
  int model = static_cast<int>(laser.model);
  marked_choice_row(
      "Model", "##model", model, kNames, "laser model",
      "Geometric removes at once what the beam touches, and leaves heat beside it. Thermal heats it: a "
      "face "
      "goes when it has taken the energy that its material needs.");
  laser.model = static_cast<Model>(model);
}

void hold_row(bool& held) {
  property("Hold the heat");
  ImGui::Checkbox("##hold", &held);
  mark_last_item("hold heat");
  tooltip("What is hot stays as hot as it is. Otherwise it cools in real time, and the bodies stand still.");
}

}  // namespace

std::string depth_text(const StepStatistics& statistics) {
  if (statistics.met_s <= 0) return "";
  return text_of("The last stroke got %.0f %% of the way through",
                 100 * statistics.depth_s / statistics.met_s);
}

std::string forecast_text(const LaserControls& laser, const Sheet& sheet, double speed, FileUnit unit) {
  const std::string watts = text_of("%.4g W", laser.power);
  const std::string thickness = text_of("%.3g mm", 1000 * sheet.thickness);
  const LumpedCut cut{sheet.substance, laser.power, 0, 2 * laser.radius};
  if (speed > 0)
    return watts + " at " + length_label(speed, unit) + "/s cuts " +
           text_of("%.2g mm", 1000 * cut_thickness(cut, speed)) + "; this sheet has " + thickness;
  const double fastest = cutting_speed(cut, sheet.thickness);
  if (fastest <= 0) return watts + " does not cut this sheet of " + thickness + " with so wide a beam";
  return watts + " cuts this sheet of " + thickness + " at up to " + length_label(fastest, unit) + "/s";
}

std::string energy_text(const World& world) {
  const EnergyLedger& ledger = world.energy();
  double ejected = 0;
  for (const BodyId id : world.ids()) ejected += world.body(id).ejected;
  return "Emitted " + energy_label(ledger.emitted) + ": " + energy_label(ledger.absorbed) + " absorbed, " +
         energy_label(ejected) + " of it ejected";
}

void LaserHeatRows::draw_geometric(LaserControls& laser, FileUnit unit) {
  double width = laser.width_of_heat();
  const LengthUnit in = label_unit(default_heat_width(laser.radius), unit);
  if (length_field(fields_, "Heat beside", width, in,
                   "How far from the rim the cut leaves heat: at the melting point on the rim, less with the "
                   "distance. 0 leaves none. A negative number is for what suits the radius."))
    laser.heat_width = width >= 0 ? std::optional(std::min(width, kMostRadii * laser.radius)) : std::nullopt;
}

void LaserHeatRows::draw_thermal(LaserControls& laser) {
  property("Power");
  ImGui::SliderScalar("##power", ImGuiDataType_Double, &laser.power, &LaserControls::kLeastPower,
                      &LaserControls::kMostPower, RealFormat("%.4g W").c_str(), kPowerSlider);
  mark_last_item("laser power");
  tooltip("Of the beam while it is on. Ctrl+click to type a number.");
}

void LaserHeatRows::draw(Workspace& on, const Sheet& sheet) {
  const bool thermal = on.laser.model == Model::kThermal;
  const FileUnit unit = on.view.frame.unit;
  if (begin_properties("laser heat")) {
    model_row(on.laser);
    if (thermal) draw_thermal(on.laser);
    if (!thermal) draw_geometric(on.laser, unit);
    hold_row(on.settings.heat_held);
    end_properties();
  }
  if (!thermal) return;
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TextWrapped("%s", forecast_text(on.laser, sheet, on.laser.planned_speed, unit).c_str());
  mark_last_item("laser forecast");
  tooltip("From the heat balance of the cut, with what is conducted into the sheet beside it.");
  const auto& stroke = on.statistics.shown.stroke;
  const std::string depth = stroke ? depth_text(stroke->statistics) : "";
  if (!depth.empty()) ImGui::TextWrapped("%s", depth.c_str());
  if (on.world().energy().emitted > 0) ImGui::TextWrapped("%s", energy_text(on.world()).c_str());
  ImGui::PopStyleColor();
}

}  // namespace kerf
