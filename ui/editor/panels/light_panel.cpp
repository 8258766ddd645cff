#include "ui/editor/panels/light_panel.h"

#include <imgui.h>

#include <cmath>
#include <string>

#include "core/base/assert.h"
#include "ui/editor/panels/switch_row.h"
#include "ui/editor/view/light_presets.h"
#include "ui/editor/view/shadow_methods.h"
#include "ui/window/number_format.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

constexpr double kLeastIntensity = 0.02, kMostIntensity = 50;
constexpr double kLeastReach = 0.25, kMostReach = 50;  // diagonals

bool method_row(const char* label, const char* id, ShadowMethod& method) {
  property(label);
  bool changed = false;
  const auto is = [&](const MethodWords& m) { return m.method == method; };
  const std::span<const MethodWords> all = shadow_methods();
  const auto found = std::find_if(all.begin(), all.end(), is);
  KERF_ASSERT(found != all.end());
  const MethodWords& now = *found;
  if (ImGui::BeginCombo(id, now.name)) {
    for (const MethodWords& m : all) {
      if (ImGui::Selectable(m.name, m.method == method)) {
        changed = m.method != method;
        method = m.method;
      }
      tooltip(m.meaning);
    }
    ImGui::EndCombo();
  } else {
    tooltip(now.meaning);
  }
  return changed;
}

bool slider(const char* label, const char* id, double& value, double low, double high,
            const RealFormat& format, const char* meaning, ImGuiSliderFlags flags) {
  property(label);
  const bool changed = ImGui::SliderScalar(id, ImGuiDataType_Double, &value, &low, &high, format.c_str(),
                                           flags | ImGuiSliderFlags_AlwaysClamp);
  tooltip(meaning);
  return changed;
}

bool shadow_rows(ViewState& view) {
  ViewOptions& look = view.look;
  ShadowOptions& shadow = look.shadow;
  bool changed = false;
  property("Shadows");
  draw_switch(view, SwitchId::kShadows, "");
  changed |= method_row("Method", "##method", shadow.method);
  if (shadow.method != ShadowMethod::kRobust) {
    changed |=
        slider("Reach", "##reach", shadow.extrusion, kLeastReach, kMostReach, "%.2g sizes of the world",
               "How far the paper's volumes are extruded; what lies beyond gets no shadow.",
               ImGuiSliderFlags_Logarithmic);
  }
  property("");
  changed |= ImGui::Checkbox("Paper look", &shadow.paper_look);
  tooltip("Transparent black over what is in shadow, as in the paper, in place of leaving the light out.");
  property("");
  draw_switch(view, SwitchId::kCullBacks);
  return changed;
}

bool compare_rows(ViewState& view, const ShadowFigures& figures) {
  ShadowOptions& shadow = view.look.shadow;
  property("Compare");
  draw_switch(view, SwitchId::kCompare, "two methods");
  if (!view.look.show.shadow_compare) return false;
  bool changed = method_row("with", "##beside", shadow.beside);
  changed |= slider("Split", "##split", shadow.split, 0, 1, "%.2f", "Where the two meet.", 0);
  property("");
  ImGui::TextUnformatted(figures.differing ? text_of("%zu pixels differ", *figures.differing).c_str()
                                           : "counting the pixels that differ");
  tooltip("Pixels of the whole picture that are in shadow with one method and lit with the other.");
  return changed;
}

void trace_rows(ViewState& view, const ShadowFigures& figures) {
  property("Rays");
  draw_switch(view, SwitchId::kTrace, "trace");
  if (!view.look.show.shadow_reference) return;
  property("");
  ImGui::TextUnformatted(
      (figures.wrong ? text_of("%zu wrong", *figures.wrong) : tracing_text(figures)).c_str());
}

void choose_kind(Light& light, Light::Kind kind, const World::Bounds& bounds) {
  if (light.kind == kind) return;
  const Vec3 middle = (bounds.min + bounds.max) * 0.5;
  const Vec3 way = light.kind == Light::Kind::kPoint ? light.at - middle : light.at;
  const double length = glm::length(way);
  const Vec3 direction = length > 0 ? way / length : Vec3(0, 1, 0);
  light.at = kind == Light::Kind::kPoint ? middle + direction * bounds.diagonal() : direction;
  light.kind = kind;
}

bool light_rows(Light& light, const World::Bounds& bounds) {
  bool changed = false;
  property("Kind");
  int kind = light.kind == Light::Kind::kPoint ? 1 : 0;
  if (ImGui::Combo("##kind", &kind, "Directional\0Point\0")) {
    choose_kind(light, kind == 1 ? Light::Kind::kPoint : Light::Kind::kDirectional, bounds);
    changed = true;
  }
  tooltip("Drag its handle in the picture to move it.");
  property("Colour");
  glm::vec3 shown = glm::sqrt(glm::clamp(glm::vec3(light.colour), 0.0f, 1.0f));
  if (ImGui::ColorEdit3("##colour", &shown.x, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs)) {
    light.colour = Vec3(shown * shown);
    changed = true;
  }
  changed |=
      slider("Intensity", "##intensity", light.intensity, kLeastIntensity, kMostIntensity, "%.3g",
             "What arrives on a surface that faces it; of a lamp at a distance of one size of the world.",
             ImGuiSliderFlags_Logarithmic);
  return changed;
}

bool preset_row(ViewOptions& look, const World::Bounds& bounds, UpAxis up) {
  property("Preset");
  bool changed = false;
  if (ImGui::BeginCombo("##preset", "Choose")) {
    for (const LightPreset& preset : light_presets()) {
      if (ImGui::Selectable(preset.name)) {
        look.lights = lights_of(preset, bounds, up);
        look.shadow.inspected = 0;
        changed = true;
      }
      tooltip(preset.meaning);
    }
    ImGui::EndCombo();
  }
  return changed;
}

// Buttons to choose a light, to add one and to take the chosen one away.
bool choose_light(ViewOptions& look, UpAxis up) {
  std::vector<Light>& lights = look.lights;
  size_t& chosen = look.shadow.inspected;
  bool changed = false;
  for (size_t i = 0; i < lights.size(); ++i) {
    const std::string label = " " + std::to_string(i + 1) + " ";
    if (i > 0) ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Button,
                          ImGui::GetStyleColorVec4(i == chosen ? ImGuiCol_ButtonActive : ImGuiCol_Button));
    if (ImGui::Button(label.c_str())) {
      changed = chosen != i;
      chosen = i;
    }
    ImGui::PopStyleColor();
  }
  if (!lights.empty()) ImGui::SameLine();
  ImGui::BeginDisabled(lights.size() >= kMostLights);
  if (ImGui::Button("Add")) {
    add_light(look, up);
    changed = true;
  }
  tooltip("Up to four.");
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(lights.empty());
  if (ImGui::Button("Remove")) {
    remove_light(look);
    changed = true;
  }
  ImGui::EndDisabled();
  return changed;
}

}  // namespace

void draw_light_panel(ViewState& view, const World::Bounds& bounds, const ShadowFigures& figures) {
  ViewOptions& look = view.look;
  bool changed = choose_light(look, view.camera.up_axis());
  if (begin_properties("light")) {
    changed |= preset_row(look, bounds, view.camera.up_axis());
    if (look.shadow.inspected < look.lights.size())
      changed |= light_rows(look.lights[look.shadow.inspected], bounds);
    changed |= shadow_rows(view);
    changed |= compare_rows(view, figures);
    trace_rows(view, figures);
    end_properties();
  }
  if (changed) view.picture_old = true;
}

}  // namespace kerf
