#include "ui/editor/material/material_panel.h"

#include <imgui.h>

#include <algorithm>

#include "ui/editor/view/piece_set.h"
#include "ui/render/assets.h"
#include "ui/window/landmarks.h"
#include "ui/window/property.h"

namespace kerf {

std::optional<PieceId> piece_of_sheet(const World& world, const ViewState& view) {
  const auto chosen = first_chosen(view.look.pieces);
  if (chosen && world.contains(chosen->body)) return chosen;
  const std::vector<BodyId> bodies = world.ids();
  if (bodies.empty()) return std::nullopt;
  return PieceId{bodies.front(), 0};
}

// A number of the sheet that is shown in another unit, which has this size. What is typed is limited to what
// a journal can hold (see SetSheet).
bool MaterialPanel::number(const char* name, double& value, double unit, const Limits& within,
                           const RealFormat& format, const char* meaning) {
  double shown = value / unit;
  if (!fields_.number(name, shown, format, meaning)) return false;
  value = std::clamp(shown * unit, within.least, within.most);
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
                                [&](const Material& m) { return m.substance == sheet.substance; });
  bool changed = false;
  if (ImGui::BeginCombo("##material", own != materials->end() ? own->title.c_str() : "Of its own")) {
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

bool MaterialPanel::draw_thermal_numbers(Substance& s) {
  constexpr Limits kShare{0, 1};
  bool changed = number("Heat, solid", s.heat_solid, 1, {1e-3, 1e6}, "%.4g J/(kg K)",
                        "What it takes to heat it by a kelvin.");
  changed |=
      number("Heat, liquid", s.heat_liquid, 1, {1e-3, 1e6}, "%.4g J/(kg K)", "The same once it is molten.");
  changed |=
      number("Conductivity", s.conductivity, 1, {0, 1e6}, "%.4g W/(m K)", "How well it conducts heat.");
  changed |= number("Melts at", s.transition, 1, {kAmbient + 1, 1e5}, "%.4g K",
                    "Where it melts, or decomposes. With the latent heat on top it is gone.");
  changed |=
      number("Latent heat", s.latent, 1000, {0, 1e9}, "%.4g kJ/kg", "What melting takes, or decomposing.");
  changed |=
      number("Emissivity", s.emissivity, 1, kShare, "%.3g", "0 to 1: how well it radiates, from both sides.");
  changed |= number("Absorbs, fibre", s.absorptivity_fibre, 1, kShare, "%.3g",
                    "0 to 1: the share of a beam of 1.07 \xc2\xb5m that stays in it.");
  changed |= number("Absorbs, CO2", s.absorptivity_co2, 1, kShare, "%.3g",
                    "0 to 1: the share of a beam of 10.6 \xc2\xb5m that stays in it.");
  return changed;
}

bool MaterialPanel::draw_numbers(Sheet& sheet) {
  bool changed =
      number("Thickness", sheet.thickness, 0.001, {1e-9, 1e3}, "%.4g mm", "Of the sheet that the faces are.");
  if (number("Density", sheet.substance.density, 1, {1e-3, 1e6}, "%.5g kg/m\xc2\xb3", "Of the material.")) {
    sheet.density = sheet.substance.density;
    changed = true;
  }
  if (ImGui::TreeNode("Constants of the material")) {
    if (begin_properties("constants")) {
      changed |= draw_thermal_numbers(sheet.substance);
      end_properties();
    }
    ImGui::TreePop();
  }
  return changed;
}

void MaterialPanel::draw(const World& world, const ViewState& view, Requests& requests) {
  const auto piece = piece_of_sheet(world, view);
  if (!piece) return ImGui::TextDisabled("Nothing is open.");
  const Body& body = world.body(piece->body);
  const size_t chosen = chosen_pieces(view.look.pieces);
  const std::string of = chosen == 0   ? std::string("All pieces")
                         : chosen == 1 ? body.name_of(piece->label)
                                       : std::to_string(chosen) + " chosen pieces";
  ImGui::TextDisabled("%s", of.c_str());
  tooltip("Changes are for the chosen pieces, or for all of them if none is chosen.");
  Sheet sheet = body.sheet;
  bool changed = false;
  if (begin_properties("sheet")) {
    changed = draw_presets(sheet);
    changed |= draw_numbers(sheet);
    end_properties();
  }
  if (changed) requests.sheet = sheet;
}

}  // namespace kerf
