#include "ui/editor/material/laser_heat_rows.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <limits>

#include "core/heat/cut_remedies.h"

#include "ui/editor/shared/files/file_frames.h"
#include "ui/editor/shared/panels/panel_rows.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"
#include "ui/window/slider.h"

namespace kerf {

namespace {

constexpr double kMostRadii = 100;  // that heat can be wide
constexpr double kSlanted = 1.05;   // from which on a slant is told

std::string energy_label(double joules) {
  return joules >= 1000 ? text_of("%.3g kJ", joules / 1000) : text_of("%.3g J", joules);
}

std::string power_label(double watts) {
  return watts >= 1000 ? text_of("%.3g kW", watts / 1000) : text_of("%.3g W", watts);
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

std::string forecast_text(const LaserControls& laser, const MetSheet& met, double speed, FileUnit unit) {
  const std::string watts = text_of("%.4g W", laser.power);
  std::string thickness = text_of("%.3g mm", 1000 * met.sheet.thickness);
  if (met.slant > kSlanted)
    thickness += text_of(", %.3g mm along the beam,", 1000 * met.slant * met.sheet.thickness);
  const LumpedCut cut = met.balance(laser.beam());
  if (speed > 0)
    return watts + " at " + length_label(speed, unit) + "/s cuts " +
           text_of("%.2g mm", 1000 * cut_thickness(cut, speed)) + "; this sheet has " + thickness;
  const double fastest = cutting_speed(cut, met.sheet.thickness);
  if (fastest <= 0) return watts + " does not cut this sheet of " + thickness + " with so wide a beam";
  return watts + " cuts this sheet of " + thickness + " at up to " + length_label(fastest, unit) + "/s";
}

std::string pointer_text(const LaserControls& laser, const PointerAim& aim, FileUnit unit) {
  if (aim.speed <= 0) return "";
  const LumpedCut cut = aim.met.balance(laser.beam());
  const bool through = cut_thickness(cut, aim.speed) >= aim.met.sheet.thickness;
  return "The pointer goes at " + length_label(aim.speed, unit) + "/s, " +
         (through ? "slowly enough to get through" : "too fast to get through");
}

std::string beam_text(const StrokeWatch::Now& now, FileUnit unit) {
  const std::string text = now.through ? "The beam gets through" : "The beam does not get through";
  return now.speed > 0 ? text + ", at " + length_label(now.speed, unit) + "/s" : text;
}

std::string remedy_text(const StrokeWatch::Crossing& crossing, FileUnit unit) {
  if (crossing.share >= 1 || crossing.speed <= 0) return "";
  const Laser& laser = crossing.settings.laser;
  const LumpedCut cut = crossing.met.balance(laser);
  const double thickness = crossing.met.sheet.thickness;
  if (cut_thickness(cut, crossing.speed) >= thickness) return "";
  const CutRemedies would = remedies(cut, thickness, crossing.speed);
  std::string text = "It would have got through ";
  if (would.speed > 0)
    text += "at " + length_label(would.speed, unit) + "/s instead of " + length_label(crossing.speed, unit) +
            "/s, ";
  text += "with " + power_label(would.power) + " instead of " + power_label(laser.power);
  const double radius = 0.5 * would.kerf / crossing.met.slant;
  if (radius <= 0) return text + "; a smaller radius alone would not do";
  return text + ", or with a radius of " + length_label(radius, unit) + " instead of " +
         length_label(laser.radius, unit);
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
                   "distance. 0 leaves none. A negative number is for what suits the radius.",
                   "", {std::numeric_limits<double>::lowest(), kMostRadii * laser.radius}))
    laser.heat_width = width >= 0 ? std::optional(width) : std::nullopt;
}

void LaserHeatRows::draw_thermal(LaserControls& laser) {
  property("Power");
  real_slider({"Power", "##power", "Of the beam while it is on. Ctrl+click to type a number.", true},
              laser.power, LaserControls::kLeastPower, LaserControls::kMostPower, "%.4g W", kWatts);
  mark_last_item("laser power");
  property("Oxygen");
  ImGui::Checkbox("##oxygen", &laser.oxygen);
  mark_last_item("oxygen");
  tooltip("Is blown into the cut: part of mild steel burns in it, and its heat helps to cut. Empirical.");
}

void LaserHeatRows::draw_forecast(const Workspace& on, const Sheet& sheet,
                                  const std::optional<PointerAim>& aim) {
  const FileUnit unit = on.view.frame.unit;
  const std::string whose = aim ? "Under the pointer: " : "";
  const MetSheet met = aim ? aim->met : MetSheet{sheet};
  const std::string forecast = forecast_text(on.laser, met, on.laser.planned_speed, unit);
  ImGui::TextWrapped("%s", (whose + forecast).c_str());
  mark_last_item("laser forecast");
  tooltip("From the heat balance of the cut, with what is conducted into the sheet beside it.");
  const std::string pointer = aim ? pointer_text(on.laser, *aim, unit) : "";
  if (!pointer.empty()) ImGui::TextWrapped("%s", pointer.c_str());
}

void LaserHeatRows::draw_strokes(const Workspace& on, const StrokeWatch& watch) {
  const FileUnit unit = on.view.frame.unit;
  if (watch.now()) return ImGui::TextWrapped("%s", beam_text(*watch.now(), unit).c_str());
  const auto& stroke = on.statistics.shown.stroke;
  const std::string depth = stroke ? depth_text(stroke->statistics) : "";
  if (depth.empty()) return;
  const StrokeWatch::Crossing* crossing = watch.last(on.work.document);
  const std::string remedy = crossing ? remedy_text(*crossing, unit) : "";
  ImGui::TextWrapped("%s", (remedy.empty() ? depth : depth + ". " + remedy).c_str());
}

void LaserHeatRows::draw(Workspace& on, const Sheet& sheet, const std::optional<PointerAim>& aim,
                         const StrokeWatch& watch) {
  const bool thermal = on.laser.model == Model::kThermal;
  if (begin_properties("laser heat")) {
    model_row(on.laser);
    if (thermal) draw_thermal(on.laser);
    if (!thermal) draw_geometric(on.laser, on.view.frame.unit);
    hold_row(on.settings.heat_held);
    end_properties();
  }
  if (!thermal) return;
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  draw_forecast(on, sheet, aim);
  draw_strokes(on, watch);
  if (on.world().energy().emitted > 0) ImGui::TextWrapped("%s", energy_text(on.world()).c_str());
  ImGui::PopStyleColor();
}

}  // namespace kerf
