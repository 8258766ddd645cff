#include "ui/editor/laser/material_rows.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/base/platform.h"
#include "core/document/material_table.h"
#include "core/document/text/world_fields.h"
#include "core/heat/lumped_cut.h"
#include "core/mesh/measures.h"
#include "ui/editor/laser/stroke_watch.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/features.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/world_changes.h"
#include "ui/window/layout.h"
#include "ui/window/number_fields.h"
#include "ui/window/number_text.h"
#include "ui/window/property_rows.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr double kMaxRadii = 100;  // that heat can be wide
constexpr double kSlanted = 1.05;  // from which on a slant is told

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
                   "", {std::numeric_limits<double>::lowest(), kMaxRadii * laser.radius}))
    laser.heat_width = width >= 0 ? std::optional(width) : std::nullopt;
}

void LaserHeatRows::draw_thermal(LaserControls& laser) {
  property("Power");
  real_slider({"Power", "##power", "Of the beam while it is on. Ctrl+click to type a number.", true},
              laser.power, LaserControls::kMinPower, LaserControls::kMaxPower, "%.4g W", kWatts);
  mark_last_item("laser power");
  property("Oxygen");
  ImGui::Checkbox("##oxygen", &laser.oxygen);
  mark_last_item("oxygen");
  tooltip("Is blown into the cut: part of mild steel burns in it, and its heat helps to cut. Empirical.");
}

void LaserHeatRows::draw_forecast(const Workspace& workspace, const Sheet& sheet,
                                  const std::optional<PointerAim>& aim) {
  const FileUnit unit = workspace.view.frame.unit;
  const std::string whose = aim ? "Under the pointer: " : "";
  const MetSheet met = aim ? aim->met : MetSheet{sheet};
  const std::string forecast = forecast_text(workspace.laser, met, workspace.laser.planned_speed, unit);
  ImGui::TextWrapped("%s", (whose + forecast).c_str());
  mark_last_item("laser forecast");
  tooltip("From the heat balance of the cut, with what is conducted into the sheet beside it.");
  const std::string pointer = aim ? pointer_text(workspace.laser, *aim, unit) : "";
  if (!pointer.empty()) ImGui::TextWrapped("%s", pointer.c_str());
}

void LaserHeatRows::draw_strokes(const Workspace& workspace, const StrokeWatch& watch) {
  const FileUnit unit = workspace.view.frame.unit;
  if (watch.now()) return ImGui::TextWrapped("%s", beam_text(*watch.now(), unit).c_str());
  const auto& stroke = workspace.statistics.shown.stroke;
  const std::string depth = stroke ? depth_text(stroke->statistics) : "";
  if (depth.empty()) return;
  const StrokeWatch::Crossing* crossing = watch.last(workspace.work.document);
  const std::string remedy = crossing ? remedy_text(*crossing, unit) : "";
  ImGui::TextWrapped("%s", (remedy.empty() ? depth : depth + ". " + remedy).c_str());
}

void LaserHeatRows::draw(Workspace& workspace, const Sheet& sheet, const std::optional<PointerAim>& aim,
                         const StrokeWatch& watch) {
  const bool thermal = workspace.laser.model == Model::kThermal;
  if (begin_properties("laser heat")) {
    model_row(workspace.laser);
    if (thermal) draw_thermal(workspace.laser);
    if (!thermal) draw_geometric(workspace.laser, workspace.view.frame.unit);
    hold_row(workspace.settings.heat_held);
    end_properties();
  }
  if (!thermal) return;
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  draw_forecast(workspace, sheet, aim);
  draw_strokes(workspace, watch);
  if (workspace.world().energy().emitted > 0)
    ImGui::TextWrapped("%s", energy_text(workspace.world()).c_str());
  ImGui::PopStyleColor();
}

const char* why_not_solid(bool closed, const LaserControls& laser) {
  if (!closed) return "Only what is closed can be solid, and this piece has open edges.";
  if (laser.model == Model::kThermal)
    return "A thermal beam leaves no walls: choose the model Geometric in the Laser panel.";
  if (laser.pattern == Pattern::kRays4)
    return "Four rays leave no walls: choose the pattern Volume in the Laser panel.";
  if (laser.resolution.rim != Rim::kSmooth) return "Walls need a smooth rim: choose it in the Laser panel.";
  return nullptr;
}

bool KnownClosed::of(const World& world, const PieceId& piece) {
  const Body& body = world.body(piece.body);
  const Piece& counted = body.pieces[piece.label];
  const Asked now{piece, counted.faces, counted.area};
  if (asked_ == now) return closed_;
  asked_ = now;
  closed_ = enclosed_volume(body.mesh, body.faces_of(piece.label), body.middle()).closed;
  return closed_;
}

std::optional<bool> SolidRow::draw(const Workspace& workspace, const PieceId& piece) {
  bool solid = workspace.world().body(piece.body).solid;
  const char* disabled_reason = nullptr;
  if (workspace.cutting()) {
    disabled_reason = "Wait until the stroke is cut.";
  } else if (!solid) {
    disabled_reason = why_not_solid(closed_.of(workspace.world(), piece), workspace.laser);
  }
  property("Solid");
  ImGui::BeginDisabled(disabled_reason != nullptr);
  const bool changed = ImGui::Checkbox("##solid", &solid);
  ImGui::EndDisabled();
  mark_last_item("solid");
  tooltip(
      disabled_reason != nullptr
          ? disabled_reason
          : "The faces enclose a volume: strokes leave walls along the kerf, so that the pieces are closed "
            "again, and weigh what they hold. Otherwise they are a sheet.");
  return changed ? std::optional(solid) : std::nullopt;
}

namespace {

// A row of the panel, in units of `scale`.
struct NumberRow {
  const char* label;
  double scale;
  RealFormat format;
  const char* tooltip;
};

constexpr NumberRow kThicknessRow{"Thickness", 0.001, "%.4g mm",
                                  "Determines the mass and the heat capacity of the sheet."};
constexpr NumberRow kDensityRow{"Density", 1, "%.5g kg/m\xc2\xb3", "Mass per volume of the material."};

struct ConstantRow {
  double Substance::*member;
  NumberRow row;
};
constexpr std::array kConstantRows{
    ConstantRow{&Substance::heat_solid,
                {"Heat, solid", 1, "%.4g J/(kg K)", "Specific heat below the transition."}},
    ConstantRow{&Substance::heat_liquid,
                {"Heat, liquid", 1, "%.4g J/(kg K)", "Specific heat above the transition."}},
    ConstantRow{&Substance::conductivity,
                {"Conductivity", 1, "%.4g W/(m K)", "Thermal conductivity, a mean over temperature."}},
    ConstantRow{&Substance::transition,
                {"Melts at", 1, "%.4g K",
                 "Temperature of melting or decomposition; removal takes the latent heat in addition."}},
    ConstantRow{&Substance::latent,
                {"Latent heat", 1000, "%.4g kJ/kg", "Heat of fusion, or the remaining heat of ablation."}},
    ConstantRow{&Substance::emissivity,
                {"Emissivity", 1, "%.3g", "0 to 1: radiation of both sides relative to a black body."}},
    ConstantRow{&Substance::absorptivity_fibre,
                {"Absorbs, fibre", 1, "%.3g", "0 to 1: the absorbed share of a beam of 1.07 \xc2\xb5m."}},
    ConstantRow{&Substance::absorptivity_co2,
                {"Absorbs, CO2", 1, "%.3g", "0 to 1: the absorbed share of a beam of 10.6 \xc2\xb5m."}},
    ConstantRow{
        &Substance::burnt_share,
        {"Burns", 1, "%.3g", "0 to 1: the share of the kerf that burns with oxygen as the assist gas."}}};
static_assert(kConstantRows.size() + 2 == std::size(kSubstanceFields),
              "the density and the wavelength have no row here");

// What the user has chosen or typed.
struct MaterialChange {
  std::optional<Sheet> sheet;
  std::optional<bool> solid;
};

// The sheet of the chosen pieces, or of all pieces if none is chosen: its material, from
// assets/materials.json, its thickness, the constants of the material, each of which can be typed, and
// whether they are solid. Every change is one step of the history.
class MaterialPanel {
 public:
  MaterialChange draw(const Workspace& workspace);

 private:
  bool draw_presets(Sheet& sheet);
  bool draw_numbers(Sheet& sheet);
  bool draw_constants(Substance& substance);
  template <typename Owner>
  bool number(const NumberField<Owner>& field, const NumberRow& row, Owner& owner);

  NumberFields fields_;
  SolidRow solid_;
  std::optional<Result<std::vector<Material>>> materials_;  // once the panel was drawn
};

// The piece whose sheet the panel shows: the first chosen one, else the first body. Nothing in an empty
// world.
std::optional<PieceId> piece_of_sheet(const World& world, const ViewState& view) {
  const auto chosen = first_chosen(view.look.pieces);
  if (chosen && world.contains(chosen->body)) return chosen;
  const std::vector<BodyId> bodies = world.ids();
  if (bodies.empty()) return std::nullopt;
  return PieceId{bodies.front(), 0};
}

// Typed numbers are clamped to the limits of a journal. Lengths are saved in metres.
template <typename Owner>
bool MaterialPanel::number(const NumberField<Owner>& field, const NumberRow& row, Owner& owner) {
  double shown = owner.*field.member / row.scale;
  const bool is_length = std::string_view(field.range.unit) == "m";
  const NumberUnit unit{is_length ? Quantity::kLength : Quantity::kPlain, row.scale};
  const NumberRange range{field.range.least / row.scale, field.range.most / row.scale};
  if (!fields_.number(row.label, shown, row.format, row.tooltip, is_length ? unit : NumberUnit(), range))
    return false;
  owner.*field.member = std::clamp(shown * row.scale, field.range.least, field.range.most);
  return true;
}

bool MaterialPanel::draw_presets(Sheet& sheet) {
  if (!materials_) materials_ = load_materials(assets_folder() / "materials.json");
  const Result<std::vector<Material>>& materials = *materials_;
  property("Material");
  if (!materials) {
    ImGui::TextWrapped("%s", materials.error().message.c_str());
    return false;
  }
  const auto own = std::find_if(materials->begin(), materials->end(),
                                [&](const Material& m) { return is_of(sheet.substance, m.substance); });
  bool changed = false;
  if (begin_fitted_combo("##material", own != materials->end() ? own->title : "Of its own")) {
    for (const Material& material : *materials) {
      if (!ImGui::Selectable(material.title.c_str(), material.substance == sheet.substance)) continue;
      changed = material.substance != sheet.substance;
      sheet.substance = material.substance;
      sheet.density = material.substance.density;
    }
    ImGui::EndCombo();
  } else {
    mark_last_item("material");
    tooltip("Sets all constants of the material; `kerf materials` lists them with their sources.");
  }
  return changed;
}

bool MaterialPanel::draw_constants(Substance& substance) {
  bool changed = false;
  for (const auto& [member, row] : kConstantRows) changed |= number(substance_field(member), row, substance);
  return changed;
}

bool MaterialPanel::draw_numbers(Sheet& sheet) {
  bool changed = number(kThickness, kThicknessRow, sheet);
  if (number(substance_field(&Substance::density), kDensityRow, sheet.substance)) {
    sheet.density = sheet.substance.density;
    changed = true;
  }
  if (ImGui::TreeNode("Constants of the material")) {
    if (begin_properties("constants")) {
      changed |= draw_constants(sheet.substance);
      end_properties();
    }
    ImGui::TreePop();
  }
  return changed;
}

MaterialChange MaterialPanel::draw(const Workspace& workspace) {
  MaterialChange change;
  const auto piece = piece_of_sheet(workspace.world(), workspace.view);
  if (!piece) {
    ImGui::TextDisabled("Nothing is open.");
    return change;
  }
  const Body& body = workspace.world().body(piece->body);
  const size_t chosen = chosen_pieces(workspace.view.look.pieces);
  const std::string of = chosen == 0   ? std::string("All pieces")
                         : chosen == 1 ? body.name_of(piece->label)
                                       : std::to_string(chosen) + " chosen pieces";
  ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  draw_fitted_text(of, "Changes are for the chosen pieces, or for all of them if none is chosen.");
  ImGui::PopStyleColor();
  Sheet sheet = body.sheet;
  bool changed = false;
  if (begin_properties("sheet")) {
    changed = draw_presets(sheet);
    changed |= draw_numbers(sheet);
    change.solid = solid_.draw(workspace, *piece);
    end_properties();
  }
  if (changed) change.sheet = sheet;
  return change;
}

class MaterialFeature : public Feature {
 public:
  explicit MaterialFeature(Workspace& workspace) : workspace_(workspace) {}

  std::vector<Panel> panels() override {
    return {{"Laser", Tab::kCut, 110, true, [this] { draw_heat(); }},
            {"Material", Tab::kHeat, 200, true, [this] { draw_material(); }}};
  }
  void update(double seconds) override {
    pointer_.follow(workspace_.pointer, seconds);
    aim_ = thermal() && workspace_.points() ? aim_of(workspace_, pointer_) : std::nullopt;
  }
  void after_queue(double) override {
    if (!workspace_.changes.is_pending())
      watch_.follow(workspace_.work.document, workspace_.beam.picture(workspace_.work.document));
  }
  bool needs_redraw() const override { return aim_ && aim_->speed > 0; }
  void on_document_opened() override { watch_ = StrokeWatch(); }
  void draw_overlay(ImDrawList& list) override;

 private:
  void draw_heat() {
    const auto piece = piece_of_sheet(workspace_.world(), workspace_.view);
    heat_.draw(workspace_, piece ? workspace_.world().body(piece->body).sheet : Sheet(), aim_, watch_);
  }
  bool thermal() const { return workspace_.laser.model == Model::kThermal; }
  void draw_material() {
    const MaterialChange change = panel_.draw(workspace_);
    if (change.sheet) {
      ask_for_all("Set the material", [sheet = *change.sheet](const PieceId& p) {
        return SetSheetProperties{p, sheet};
      });
    }
    if (change.solid) {
      ask_for_all(*change.solid ? "Make solid" : "Make a sheet", [solid = *change.solid](const PieceId& p) {
        return SetSolid{p, solid};
      });
    }
  }
  using CommandFor = std::function<Command(const PieceId&)>;
  // One change of all pieces in question.
  void ask_for_all(const char* name, const CommandFor& command) {
    workspace_.changes.ask({.name = name,
                            .run = [this, name, command] { return change_all(name, command), true; },
                            .is_one = true});
  }
  void change_all(const char* name, const CommandFor& command);

  Workspace& workspace_;
  MaterialPanel panel_;
  LaserHeatRows heat_;
  PointerSpeed pointer_;
  std::optional<PointerAim> aim_;
  StrokeWatch watch_;
};

// Beside the pointer, because that is where one looks while a stroke is drawn.
void MaterialFeature::draw_overlay(ImDrawList& list) {
  if (!watch_.now() || !workspace_.beam.cutting()) return;
  const bool through = watch_.now()->through;
  const float size = ImGui::GetFontSize();
  const ImVec2 at = to_im(workspace_.pointer + Vec2(1.2 * size, 0.8 * size));
  const char* text = through ? "through" : "not through";
  const ImVec2 extent = ImGui::CalcTextSize(text);
  const float margin = 0.25f * size;
  list.AddRectFilled({at.x - margin, at.y - margin}, {at.x + extent.x + margin, at.y + extent.y + margin},
                     colours::kPictureShade, margin);
  list.AddText(at, through ? colours::kPictureText : colours::accent(), text);
}

// Changes the chosen pieces, or all pieces if none is chosen.
void MaterialFeature::change_all(const char* name, const CommandFor& command) {
  std::vector<PieceId> pieces;
  const PieceMap& looks = workspace_.view.look.pieces;
  const bool all = chosen_pieces(looks) == 0;
  for (const PieceRow& row : list_pieces(workspace_.world(), looks)) {
    const auto look = looks.find(row.id);
    const bool chosen = look != looks.end() && look->second.selected;
    if (!row.part && (all || chosen)) pieces.push_back(row.id);
  }
  cancel_stroke(workspace_);
  workspace_.changes.change(name, is_small(workspace_.work.document), edit_all(std::move(pieces), command));
}

}  // namespace

std::unique_ptr<Feature> material_feature(Workspace& workspace) {
  return std::make_unique<MaterialFeature>(workspace);
}

}  // namespace kerf
