#include "ui/editor/material/material_feature.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "core/base/assets.h"
#include "core/document/files/material_reader.h"
#include "core/document/text/world_fields.h"
#include "ui/editor/material/laser_heat_rows.h"
#include "ui/editor/material/pointer_aim.h"
#include "ui/editor/material/solid_row.h"
#include "ui/editor/material/stroke_watch.h"
#include "ui/editor/shared/long_change.h"
#include "ui/editor/shared/pieces/piece_set.h"
#include "ui/window/fitted_text.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_fields.h"
#include "ui/window/property.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

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
  MaterialChange draw(const Workspace& on);

 private:
  bool draw_presets(Sheet& sheet);
  bool draw_numbers(Sheet& sheet);
  bool draw_constants(Substance& substance);
  template <typename Owner>
  bool number(const NumberField<Owner>& field, const RealFormat& format, Owner& owner);

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

// What is typed is limited to what a journal can hold. Lengths are saved in metres.
template <typename Owner>
bool MaterialPanel::number(const NumberField<Owner>& field, const RealFormat& format, Owner& owner) {
  double shown = owner.*field.member / field.scale;
  const bool is_length = std::string_view(field.range.unit) == "m";
  const NumberUnit unit{is_length ? Quantity::kLength : Quantity::kPlain, field.scale};
  const NumberRange range{field.range.least / field.scale, field.range.most / field.scale};
  if (!fields_.number(field.label, shown, format, field.meaning, is_length ? unit : NumberUnit(), range))
    return false;
  owner.*field.member = std::clamp(shown * field.scale, field.range.least, field.range.most);
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

// The compiler checks the formats, so that the rows are unrolled.
bool MaterialPanel::draw_constants(Substance& substance) {
  bool changed = false;
  const auto row = [&](const NumberField<Substance>& field, const RealFormat& format) {
    if (field.label == nullptr || field.member == &Substance::density) return;
    changed |= number(field, format, substance);
  };
  [&]<size_t... i>(std::index_sequence<i...>) { (row(kSubstanceFields[i], kSubstanceFields[i].format), ...); }
  (std::make_index_sequence<std::size(kSubstanceFields)>());
  return changed;
}

bool MaterialPanel::draw_numbers(Sheet& sheet) {
  bool changed = number(kThickness, kThickness.format, sheet);
  constexpr const NumberField<Substance>& kDensityOfMaterial = substance_field(&Substance::density);
  if (number(kDensityOfMaterial, kDensityOfMaterial.format, sheet.substance)) {
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

MaterialChange MaterialPanel::draw(const Workspace& on) {
  MaterialChange change;
  const auto piece = piece_of_sheet(on.world(), on.view);
  if (!piece) {
    ImGui::TextDisabled("Nothing is open.");
    return change;
  }
  const Body& body = on.world().body(piece->body);
  const size_t chosen = chosen_pieces(on.view.look.pieces);
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
    change.solid = solid_.draw(on, *piece);
    end_properties();
  }
  if (changed) change.sheet = sheet;
  return change;
}

class MaterialFeature : public Feature {
 public:
  explicit MaterialFeature(Workspace& on) : on_(on) {}

  std::vector<Panel> panels() override {
    return {{"Laser", Tab::kCut, 110, true, [this] { draw_heat(); }},
            {"Material", Tab::kHeat, 200, true, [this] { draw_material(); }}};
  }
  void advance(double seconds) override {
    pointer_.follow(on_.pointer, seconds);
    aim_ = thermal() && on_.points() ? aim_of(on_, pointer_) : std::nullopt;
  }
  void follow_queue(double) override {
    if (!on_.changes.is_pending()) watch_.follow(on_.work.document, on_.beam.picture(on_.work.document));
  }
  bool moving() const override { return aim_ && aim_->speed > 0; }
  void forget() override { watch_ = StrokeWatch(); }
  void draw_marks(ImDrawList& list) override;

 private:
  void draw_heat() {
    const auto piece = piece_of_sheet(on_.world(), on_.view);
    heat_.draw(on_, piece ? on_.world().body(piece->body).sheet : Sheet(), aim_, watch_);
  }
  bool thermal() const { return on_.laser.model == Model::kThermal; }
  void draw_material() {
    const MaterialChange change = panel_.draw(on_);
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
    on_.changes.ask({.name = name,
                     .run = [this, name, command] { return change_all(name, command), true; },
                     .is_one = true});
  }
  void change_all(const char* name, const CommandFor& command);

  Workspace& on_;
  MaterialPanel panel_;
  LaserHeatRows heat_;
  PointerSpeed pointer_;
  std::optional<PointerAim> aim_;
  StrokeWatch watch_;
};

// Beside the pointer, because that is where one looks while a stroke is drawn.
void MaterialFeature::draw_marks(ImDrawList& list) {
  if (!watch_.now() || !on_.beam.cutting()) return;
  const bool through = watch_.now()->through;
  const float size = ImGui::GetFontSize();
  const ImVec2 at = to_im(on_.pointer + Vec2(1.2 * size, 0.8 * size));
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
  const PieceMap& looks = on_.view.look.pieces;
  const bool all = chosen_pieces(looks) == 0;
  for (const PieceRow& row : list_pieces(on_.world(), looks)) {
    const auto look = looks.find(row.id);
    const bool chosen = look != looks.end() && look->second.selected;
    if (!row.part && (all || chosen)) pieces.push_back(row.id);
  }
  cancel_stroke(on_);
  on_.changes.change(name, is_small(on_.work.document), edit_all(std::move(pieces), command));
}

}  // namespace

std::unique_ptr<Feature> material_feature(Workspace& on) { return std::make_unique<MaterialFeature>(on); }

}  // namespace kerf
