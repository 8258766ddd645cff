#include "ui/editor/laser/material_rows.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/base/platform.h"
#include "core/document/extract.h"
#include "core/document/text/fields.h"
#include "core/mesh/measures.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/editor/shared/world_changes.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/window/layout.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr double kMinCosine = 0.2;
}

std::optional<SheetHit> sheet_hit(const World& world, const ViewOptions& options, const Pose& ray) {
  const std::optional<Pick> met = pick(world, options, ray);
  if (!met) return std::nullopt;
  const Body& body = world.body(met->body);
  const Triangle t = body.mesh.triangle(met->face);
  const Vec3 across = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double along = std::abs(glm::dot(across, body.placement.to_body(ray).direction));
  const double cosine = std::max(along / glm::length(across), kMinCosine);
  return SheetHit{body.sheet, 1 / cosine, met->length};
}

namespace {

constexpr double kEven = 0.2;   // s, time constant of the smoothing
constexpr double kResting = 5;  // pixels/s, max. speed at rest

constexpr double kPlaceSpacing = 0.5;  // beam radii, between places
constexpr double kBehind = 2;          // beam radii, distance at which the beam has no more effect
constexpr double kSteepest = 5;        // assumed slant if only the axis of the beam misses the sheet
constexpr double kRests = 0.25;        // s in one place until a beam is judged there

// Returns the history entry of the stroke that is being cut, else of the last one, which is complete.
std::optional<size_t> stroke_under_beam(const Document& document) {
  const BeamQueue& pending = document.queue().pending();
  const bool is_cut = pending.holds_moves() && document.history().cuts(pending.front_step());
  return is_cut ? std::optional(pending.front_step()) : document.history().last_cut();
}

// Distance [m] perpendicular to the beam.
double way_across(const Pose& axis, const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  return glm::length(way - glm::dot(way, axis.direction) * axis.direction);
}

constexpr double kMaxRadii = 100;  // width of the heat, in beam radii
constexpr double kSlanted = 1.05;  // min. slant that is shown

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
      "Geometric removes what the beam touches. Thermal heats faces and removes those that absorbed enough "
      "energy.");
  laser.model = static_cast<Model>(model);
}

void hold_row(bool& held) {
  property("Freeze Temp.");
  ImGui::Checkbox("##hold", &held);
  mark_last_item("hold heat");
  tooltip("Freezes the temperature of all faces; otherwise hot faces cool in real time.");
}

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
                {"Heat (Solid)", 1, "%.4g J/(kg K)", "Specific heat below the transition."}},
    ConstantRow{&Substance::heat_liquid,
                {"Heat (Liquid)", 1, "%.4g J/(kg K)", "Specific heat above the transition."}},
    ConstantRow{&Substance::conductivity,
                {"Conductivity", 1, "%.4g W/(m K)", "Thermal conductivity, a mean over temperature."}},
    ConstantRow{&Substance::transition,
                {"Melting Point", 1, "%.4g K",
                 "Temperature of melting or decomposition; removal also needs the latent heat."}},
    ConstantRow{&Substance::latent,
                {"Latent Heat", 1000, "%.4g kJ/kg", "Heat of fusion, or the remaining heat of ablation."}},
    ConstantRow{&Substance::emissivity,
                {"Emissivity", 1, "%.3g", "Radiation of both sides relative to a black body, 0 to 1."}},
    ConstantRow{&Substance::absorptivity_fibre,
                {"Fibre Absorp.", 1, "%.3g", "Absorptivity for a fibre laser (1.07 \xc2\xb5m), 0 to 1."}},
    ConstantRow{&Substance::absorptivity_co2,
                {"CO2 Absorp.", 1, "%.3g", "Absorptivity for a CO2 laser (10.6 \xc2\xb5m), 0 to 1."}},
    ConstantRow{
        &Substance::burnt_share,
        {"Burn Fraction", 1, "%.3g", "Share of the kerf that burns with oxygen as the assist gas, 0 to 1."}}};
static_assert(kConstantRows.size() + 2 == std::size(kSubstanceFields),
              "the density and the wavelength have no row here");

// Draws the choice of the material of walls among the materials of a solid body. Returns the one that was
// clicked, or an empty name.
std::string draw_cut_material(const Body& body) {
  std::string selected;
  property("Cut Material");
  if (!begin_fitted_combo("##cut material", body.cut_material)) {
    mark_last_item("cut material");
    tooltip("Material of the cut faces of a solid; its texture covers them at one tile per metre.");
    return selected;
  }
  for (const std::string& name : body.material_names) {
    if (!name.empty() && ImGui::Selectable(whole_label(name).c_str(), name == body.cut_material))
      selected = name;
  }
  ImGui::EndCombo();
  return selected;
}

// Returns the piece whose sheet is shown: the first selected one, else the first body; nullopt in an empty
// world.
std::optional<PieceId> piece_of_sheet(const World& world, std::span<const PieceId> selected) {
  if (!selected.empty() && world.contains(selected.front().body)) return selected.front();
  const std::vector<BodyId> bodies = world.ids();
  if (bodies.empty()) return std::nullopt;
  return PieceId{bodies.front(), 0};
}

// Limits the input to values that a journal can store. Lengths are stored in metres.
template <typename Owner>
bool number_row(NumberFields& fields, const NumberField<Owner>& field, const NumberRow& row, Owner& owner) {
  double shown = owner.*field.member / row.scale;
  const bool is_length = std::string_view(field.range.unit) == "m";
  const NumberUnit unit{is_length ? Quantity::kLength : Quantity::kPlain, row.scale};
  const NumberRange range{field.range.least / row.scale, field.range.most / row.scale, "",
                          field.range.positive};
  if (!fields.number(row.label, shown, row.format, row.tooltip, is_length ? unit : NumberUnit(), range))
    return false;
  owner.*field.member = std::clamp(shown * row.scale, field.range.least, field.range.most);
  return true;
}

}  // namespace

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
  if (begin_fitted_combo("##material", own != materials->end() ? own->title : "Custom")) {
    for (const Material& material : *materials) {
      if (!ImGui::Selectable(material.title.c_str(), material.substance == sheet.substance)) continue;
      changed = true;  // of other pieces, if not of this one
      sheet.substance = material.substance;
      sheet.density = material.substance.density;
    }
    ImGui::EndCombo();
  } else {
    mark_last_item("material");
    tooltip("Sets all material constants; `kerf materials` lists them with sources.");
  }
  return changed;
}

void MaterialPanel::draw_numbers(SheetEdit& edit) {
  Substance& substance = edit.after.substance;
  const auto constant = [&](double Substance::*member, const NumberRow& row) {
    if (number_row(fields_, substance_field(member), row, substance)) edit.constants.push_back(member);
  };
  edit.thickness = number_row(fields_, kThickness, kThicknessRow, edit.after);
  constant(&Substance::density, kDensityRow);
  if (edit.sets_density()) edit.after.density = substance.density;
  if (!ImGui::TreeNode("Material Constants")) return;
  if (begin_properties("constants")) {
    for (const auto& [member, row] : kConstantRows) constant(member, row);
    end_properties();
  }
  ImGui::TreePop();
}

// A press in the viewport selects other pieces before a field that it leaves has reported its entry, which
// belongs to the pieces before.
const std::vector<PieceId>& MaterialPanel::pieces_of_fields(const Workspace& workspace) {
  const auto exists = [&](const PieceId& piece) { return has_faces(workspace.world(), piece); };
  if (!fields_.is_active() || !std::ranges::all_of(edited_, exists))
    edited_ = selected_ids(workspace.view.look.pieces);
  return edited_;
}

MaterialChange MaterialPanel::draw(const Workspace& workspace) {
  MaterialChange change{.pieces = pieces_of_fields(workspace)};
  const auto piece = piece_of_sheet(workspace.world(), change.pieces);
  if (!piece) {
    ImGui::TextDisabled("No file is open.");
    return change;
  }
  const Body& body = workspace.world().body(piece->body);
  const size_t selected = change.pieces.size();
  const std::string of = selected == 0 ? std::string("All pieces")
                         : selected == 1
                             ? name_of_piece(workspace.world(), workspace.view.look.pieces, *piece)
                             : std::to_string(selected) + " selected pieces";
  ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  draw_fitted_text(of, "Changes apply to the selected pieces, or to all if none is selected.");
  ImGui::PopStyleColor();
  SheetEdit edit{.after = body.sheet};
  if (begin_properties("sheet")) {
    edit.preset = draw_presets(edit.after);
    draw_numbers(edit);
    change.solid = solid_.draw(workspace, *piece);
    if (body.solid) change.cut_material = draw_cut_material(body);
    end_properties();
  }
  if (edit.preset || edit.thickness || !edit.constants.empty()) change.sheet = edit;
  return change;
}

namespace {

// Legible on colours::kPictureShade in both themes.
constexpr ImU32 kPictureWarning = IM_COL32(0xff, 0x9d, 0x2e, 255);

class MaterialFeature : public Feature {
 public:
  explicit MaterialFeature(Workspace& workspace) : workspace_(workspace) {}

  std::vector<PanelPart> panel_parts() override {
    return {{"laser.heat", [this] { draw_heat(); }}, {"material", [this] { draw_material(); }}};
  }
  void update(double seconds) override {
    pointer_.follow(workspace_.input.pointer, seconds);
    aim_ = thermal() && workspace_.input.points() ? aim_of(workspace_, pointer_) : std::nullopt;
  }
  void after_queue(double) override {
    if (!workspace_.changes.is_pending())
      watch_.follow(workspace_.session.document, workspace_.beam.picture(workspace_.session.document));
  }
  bool needs_redraw() const override { return aim_ && aim_->speed > 0; }
  void on_document_opened() override {
    watch_ = StrokeWatch();
    panel_ = MaterialPanel();  // an entry in progress belongs to the previous document
  }
  // Drawn at the pointer, where the user looks while drawing.
  void draw_overlay(ImDrawList& list) override {
    if (!watch_.now() || !workspace_.beam.cutting()) return;
    const bool through = watch_.now()->through;
    const float size = ImGui::GetFontSize();
    const ImVec2 at = to_im(workspace_.input.pointer + Vec2(1.2 * size, 0.8 * size));
    const char* text = through ? "cuts through" : "does not cut through";
    const ImVec2 extent = ImGui::CalcTextSize(text);
    const float margin = 0.25f * size;
    list.AddRectFilled({at.x - margin, at.y - margin}, {at.x + extent.x + margin, at.y + extent.y + margin},
                       colours::kPictureShade, margin);
    list.AddText(at, through ? colours::kPictureText : kPictureWarning, text);
  }

 private:
  void draw_heat() {
    const auto piece = piece_of_sheet(workspace_.world(), selected_ids(workspace_.view.look.pieces));
    heat_.draw(workspace_, piece ? workspace_.world().body(piece->body).sheet : Sheet(), aim_, watch_);
  }
  bool thermal() const { return workspace_.laser.model == Model::kThermal; }
  void draw_material() {
    const MaterialChange change = panel_.draw(workspace_);
    if (change.sheet) {
      request_for(change.pieces, "Set material", [this, edit = *change.sheet](const PieceId& p) {
        return SetSheetProperties{p, edit.applied_to(workspace_.world().body(p.body).sheet)};
      });
    }
    if (change.solid) {
      request_for(change.pieces, *change.solid ? "Make solid" : "Make sheet",
                  [solid = *change.solid](const PieceId& p) {
                    return SetSolid{p, solid};
                  });
    }
    if (!change.cut_material.empty()) {
      request_for(
          change.pieces, "Set cut material",
          [material = change.cut_material](const PieceId& p) {
            return SetSolid{p, true, material};
          },
          true);
    }
  }
  using CommandFor = std::function<Command(const PieceId&)>;
  // Requests one change of the selected pieces, or of all if there are none; `solids`: only of solid ones.
  void request_for(const std::vector<PieceId>& selected, const char* name, const CommandFor& command,
                   bool solids = false) {
    workspace_.changes.enqueue({.name = name,
                                .run =
                                    [this, selected, name, command, solids] {
                                      change_all(pieces_to_change(selected, solids), name, command);
                                      return true;
                                    },
                                .is_one = true});
  }
  std::vector<PieceId> pieces_to_change(const std::vector<PieceId>& selected, bool solids) const {
    std::vector<PieceId> pieces;
    for (const PieceRow& row : list_pieces(workspace_.world(), workspace_.view.look.pieces)) {
      const bool is_meant = selected.empty() || std::binary_search(selected.begin(), selected.end(), row.id);
      const bool fits = !row.part && (!solids || workspace_.world().body(row.id.body).solid);
      if (fits && is_meant) pieces.push_back(row.id);
    }
    return pieces;
  }
  void change_all(std::vector<PieceId> pieces, const char* name, const CommandFor& command) {
    if (pieces.empty()) return workspace_.message.error("Parts on joints have the material of their body.");
    cancel_stroke(workspace_);
    workspace_.changes.change(name, is_small(workspace_.session.document),
                              edit_all(std::move(pieces), command));
  }

  Workspace& workspace_;
  MaterialPanel panel_;
  LaserHeatRows heat_;
  PointerSpeed pointer_;
  std::optional<PointerAim> aim_;
  StrokeWatch watch_;
};

}  // namespace

void PointerSpeed::follow(const Vec2& pointer, double seconds) {
  const std::optional<Vec2> before = std::exchange(last_, pointer);
  if (!before || seconds <= 0) return;
  const double now = glm::distance(*before, pointer) / seconds;
  speed_ += (now - speed_) * std::min(1.0, seconds / kEven);
}

std::optional<PointerAim> aim_of(const Workspace& workspace, const PointerSpeed& pointer) {
  const CameraView view = workspace.view.seen();
  const Vec2 p = workspace.view.in_picture(workspace.input.pointer);
  const std::optional<SheetHit> met = sheet_hit(workspace.world(), workspace.view.look, view.ray(p.x, p.y));
  if (!met) return std::nullopt;
  const double half_height = view.parallel ? view.half_height() : met->length * view.tan_half_fov;
  const double pixel = 2 * half_height / workspace.view.pane().size.y;
  const double speed = pointer.pixels_per_second();
  return PointerAim{*met, speed > kResting ? speed * pixel : 0};
}

void StrokeWatch::follow(const Document& document, const std::optional<BeamPicture>& beam) {
  const std::optional<size_t> step = stroke_under_beam(document);
  const bool thermal = step && document.history().settings_of(*step).model == Model::kThermal;
  if (!beam || !thermal) return end(document);
  if (runs_ && *step != crossing_.step) end(document);
  if (!runs_) begin(document, *step);
  pass(document, *beam);
}

void StrokeWatch::begin(const Document& document, size_t step) {
  runs_ = true;
  way_.clear();
  through_ = not_through_ = 0;
  too_fast_ = 0;
  crossing_ = {};
  crossing_.step = step;
  crossing_.settings = document.history().settings_of(step);
  now_.reset();
}

// Returns the extent [m] along the beam of a sheet that the whole width of the beam hits.
double StrokeWatch::record_sheet(const World& world, const Pose& axis) {
  const double width = 2 * crossing_.settings.laser.radius;
  const std::optional<SheetHit> met = sheet_hit(world, {}, axis);
  if (!met) return width * kSteepest;
  crossing_.met = *met;
  return width * met->slant;
}

void StrokeWatch::pass(const Document& document, const BeamPicture& beam) {
  if (!beam.strike) return now_.reset();
  const World& world = document.world();
  Place place{{beam.from, glm::normalize(beam.to - beam.from)}, *beam.strike, world.energy().beam_on};
  const double radius = crossing_.settings.laser.radius;
  if (!way_.empty()) {
    const Place& before = way_.back();
    const double way = way_across(place.axis, before.strike, place.strike), time = place.clock - before.clock;
    if (way < kPlaceSpacing * radius) return rest(world, before);
    if (time <= 0) return;
    place.speed = way / time;
  }
  place.thickness = record_sheet(world, place.axis);
  way_.push_back(place);
  while (way_.size() > 1 && way_across(place.axis, way_[1].strike, place.strike) >= kBehind * radius) {
    way_.pop_front();
    judge(world, way_.front());
  }
}

bool StrokeWatch::is_open(const World& world, const Place& place) {
  const std::optional<double> left = first_hit(world, place.axis);
  return !left || *left > glm::distance(place.axis.origin, place.strike) + place.thickness;
}

void StrokeWatch::judge(const World& world, const Place& place) {
  const bool through = is_open(world, place);
  (through ? through_ : not_through_) += 1;
  if (!through) too_fast_ += place.speed;
  now_ = Now{through, place.speed};
}

void StrokeWatch::rest(const World& world, const Place& place) {
  if (world.energy().beam_on - place.clock >= kRests) now_ = Now{is_open(world, place), 0};
}

void StrokeWatch::end(const Document& document) {
  if (!std::exchange(runs_, false)) return;
  now_.reset();
  const UndoStack& history = document.history();
  if (crossing_.step >= history.position() || !history.cuts(crossing_.step)) return;  // it was undone
  if (way_.empty()) return;                                                           // no surface was hit
  for (size_t i = 1; i < way_.size(); ++i) judge(document.world(), way_[i]);
  now_.reset();
  way_.clear();
  const size_t all = through_ + not_through_;
  last_.reset();
  if (all == 0) return;
  crossing_.removed_faces = history.step(crossing_.step).totals().removed_faces;
  crossing_.share = static_cast<double>(through_) / static_cast<double>(all);
  crossing_.speed = not_through_ > 0 ? too_fast_ / static_cast<double>(not_through_) : 0;
  last_ = crossing_;
}

const StrokeWatch::Crossing* StrokeWatch::last(const Document& document) const {
  if (!last_ || document.history().last_cut() != last_->step) return nullptr;
  const HistoryStep& stroke = document.history().step(last_->step);
  return stroke.totals().removed_faces == last_->removed_faces ? &*last_ : nullptr;
}

std::string depth_text(const StepStatistics& statistics) {
  if (statistics.met_s <= 0) return "";
  return text_of("Last cut reached %.0f %% depth", 100 * statistics.depth_s / statistics.met_s);
}

static std::string unit_note(FileUnit unit) {
  if (unit == FileUnit::kMetre) return "";
  return ". The thermal model treats the unit of this file as a metre: convert the file to metres first";
}

std::string forecast_text(const LaserControls& laser, const SheetHit& met, double speed, FileUnit unit) {
  const std::string watts = text_of("%.5g W", laser.power);
  std::string thickness = text_of("%.3g mm", 1000 * met.sheet.thickness);
  if (met.slant > kSlanted)
    thickness += text_of(" (%.3g mm along the beam)", 1000 * met.slant * met.sheet.thickness);
  const LumpedCut cut = met.balance(laser.beam());
  if (speed > 0) {
    const double cuts = cut_thickness(cut, speed);
    return watts + " at " + length_label(speed, unit) + "/s cuts " +
           (std::isfinite(cuts) ? text_of("%.2g mm", 1000 * cuts)
                                : "any thickness, because the metal burns") +
           "; this sheet is " + thickness + unit_note(unit);
  }
  const double fastest = cutting_speed(cut, met.sheet.thickness);
  if (fastest <= 0)
    return watts + " is too little to cut " + thickness + " with this beam width" + unit_note(unit);
  return watts + " cuts this sheet of " + thickness + " at up to " + length_label(fastest, unit) + "/s" +
         unit_note(unit);
}

std::string pointer_text(const LaserControls& laser, const PointerAim& aim, FileUnit unit) {
  if (aim.speed <= 0) return "";
  const LumpedCut cut = aim.met.balance(laser.beam());
  const bool through = cut_thickness(cut, aim.speed) >= aim.met.sheet.thickness;
  return "The pointer moves at " + length_label(aim.speed, unit) + "/s, " +
         (through ? "slow enough to cut through" : "too fast to cut through");
}

std::string beam_text(const StrokeWatch::Now& now, FileUnit unit) {
  const std::string text = now.through ? "The beam cuts through" : "The beam does not cut through";
  return now.speed > 0 ? text + ", at " + length_label(now.speed, unit) + "/s" : text;
}

std::string remedy_text(const StrokeWatch::Crossing& crossing, FileUnit unit) {
  if (crossing.share >= 1 || crossing.speed <= 0) return "";
  const Laser& laser = crossing.settings.laser;
  const LumpedCut cut = crossing.met.balance(laser);
  const double thickness = crossing.met.sheet.thickness;
  if (cut_thickness(cut, crossing.speed) >= thickness) return "";
  const CutRemedies would = remedies(cut, thickness, crossing.speed);
  std::string text = "It would have cut through ";
  if (would.speed > 0)
    text += "at " + length_label(would.speed, unit) + "/s instead of " + length_label(crossing.speed, unit) +
            "/s";
  if (!std::isfinite(would.power)) return would.speed > 0 ? text : "The sheet does not absorb this beam";
  if (would.speed > 0) text += ", ";
  text += "with " + power_label(would.power) + " instead of " + power_label(laser.power);
  const double radius = 0.5 * would.kerf / crossing.met.slant;
  if (radius <= 0) return text + "; a smaller radius alone is not enough";
  return text + ", or with a radius of " + length_label(radius, unit) + " instead of " +
         length_label(laser.radius, unit);
}

std::string energy_text(const World& world) {
  const EnergyLedger& ledger = world.energy();
  return "Emitted " + energy_label(ledger.emitted) + ": " + energy_label(ledger.absorbed) + " absorbed, " +
         energy_label(ejected_energy(world)) + " of it ejected";
}

void LaserHeatRows::draw_geometric(LaserControls& laser, FileUnit unit) {
  double width = laser.width_of_heat();
  const LengthUnit in = label_unit(laser.standard_width_of_heat(), unit);
  if (length_field(fields_, "HAZ Width", width, in,
                   "Width of the heat-affected zone, from the melting point at the rim to ambient. 0: none, "
                   "-1: automatic.",
                   "", {std::numeric_limits<double>::lowest(), kMaxRadii * laser.radius}))
    laser.heat_width = width >= 0 ? std::optional(width) : std::nullopt;
}

void LaserHeatRows::draw_thermal(LaserControls& laser) {
  property("Power");
  real_slider({"Power", "##power", "Power of the beam. Double-click to type a number.", true}, laser.power,
              LaserControls::kMinPower, LaserControls::kMaxPower, "%.5g W", kWatts);
  mark_last_item("laser power");
  property("Oxygen");
  ImGui::Checkbox("##oxygen", &laser.oxygen);
  mark_last_item("oxygen");
  tooltip("Oxygen assist: mild steel burns in part, and its heat helps to cut. Empirical.");
}

void LaserHeatRows::draw_forecast(const Workspace& workspace, const Sheet& sheet,
                                  const std::optional<PointerAim>& aim) {
  const FileUnit unit = workspace.view.frame.unit;
  const std::string whose = aim ? "Under the pointer: " : "";
  const SheetHit met = aim ? aim->met : SheetHit{sheet};
  const std::string forecast = forecast_text(workspace.laser, met, workspace.laser.planned_speed, unit);
  ImGui::TextWrapped("%s", (whose + forecast).c_str());
  mark_last_item("laser forecast");
  tooltip("Forecast from the heat balance of the cut, including conduction into the sheet.");
  const std::string pointer = aim ? pointer_text(workspace.laser, *aim, unit) : "";
  if (!pointer.empty()) ImGui::TextWrapped("%s", pointer.c_str());
}

void LaserHeatRows::draw_strokes(const Workspace& workspace, const StrokeWatch& watch) {
  const FileUnit unit = workspace.view.frame.unit;
  if (watch.now()) return ImGui::TextWrapped("%s", beam_text(*watch.now(), unit).c_str());
  const auto& stroke = workspace.services.statistics.shown.stroke;
  const std::string depth = stroke ? depth_text(stroke->statistics) : "";
  if (depth.empty()) return;
  const StrokeWatch::Crossing* crossing = watch.last(workspace.session.document);
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

bool SheetEdit::sets_density() const {
  return preset || std::ranges::find(constants, &Substance::density) != constants.end();
}

Sheet SheetEdit::applied_to(Sheet own) const {
  if (thickness) own.thickness = after.thickness;
  if (sets_density()) own.density = after.density;
  for (double Substance::*member : constants) own.substance.*member = after.substance.*member;
  for (const NumberField<Substance>& field : kSubstanceFields) {
    if (preset) own.substance.*field.member = after.substance.*field.member;
  }
  return own;
}

const char* solid_disabled_reason(bool closed, const LaserControls& laser) {
  if (!closed) return "A solid must be closed, but this piece has boundary edges.";
  if (laser.model == Model::kThermal)
    return "The thermal model leaves no walls: select Geometric in the Laser panel.";
  if (laser.pattern == Pattern::kRays4)
    return "Pattern Four Rays leaves no walls: select Volume in the Laser panel.";
  if (laser.resolution.rim != Rim::kSmooth)
    return "Walls need a smooth rim: select it in the Resolution panel.";
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
    disabled_reason = "Finish or cancel the current cut first.";
  } else if (!solid) {
    disabled_reason = solid_disabled_reason(closed_.of(workspace.world(), piece), workspace.laser);
  }
  property("Solid");
  ImGui::BeginDisabled(disabled_reason != nullptr);
  const bool changed = ImGui::Checkbox("##solid", &solid);
  ImGui::EndDisabled();
  mark_last_item("solid");
  tooltip(disabled_reason != nullptr ? disabled_reason
                                     : "The faces enclose a volume, and cuts leave walls that close the "
                                       "pieces. Otherwise they are a sheet.");
  return changed ? std::optional(solid) : std::nullopt;
}

std::unique_ptr<Feature> material_feature(Workspace& workspace) {
  return std::make_unique<MaterialFeature>(workspace);
}

}  // namespace kerf
