#include "ui/editor/light/light_feature.h"

#include <imgui.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/assert.h"
#include "ui/editor/light/light_handle.h"
#include "ui/editor/light/light_presets.h"
#include "ui/editor/shared/panels/panel_rows.h"
#include "ui/editor/shared/picture/shadow_methods.h"
#include "ui/screen/shadow_statistics.h"
#include "ui/window/fitted_text.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"
#include "ui/window/slider.h"

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
  if (begin_fitted_combo(id, now.name)) {
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

bool slider_row(const Slider& slider, double& value, double low, double high, const RealFormat& format) {
  property(slider.name);
  return real_slider(slider, value, low, high, format);
}

bool shadow_rows(ViewState& view) {
  ViewOptions& look = view.look;
  ShadowOptions& shadow = look.shadow;
  bool changed = false;
  property("Shadows");
  draw_switch(view, SwitchId::kShadows, "");
  changed |= method_row("Method", "##method", shadow.method);
  if (shadow.method != ShadowMethod::kRobust) {
    changed |= slider_row(
        {"Reach", "##reach",
         "How far the paper's volumes are extruded, in sizes of the world; what lies beyond gets no "
         "shadow.",
         true},
        shadow.extrusion, kLeastReach, kMostReach, "%.2g sizes");
  }
  property("");
  changed |= ImGui::Checkbox("Paper look", &shadow.paper_look);
  tooltip("Transparent black over what is in shadow, as in the paper, in place of leaving the light out.");
  property("");
  draw_switch(view, SwitchId::kCullBacks);
  return changed;
}

bool compare_rows(ViewState& view, const ShadowStatistics& statistics) {
  ShadowOptions& shadow = view.look.shadow;
  property("Compare");
  draw_switch(view, SwitchId::kCompare, "two methods");
  if (!view.look.show.shadow_compare) return false;
  bool changed = method_row("with", "##beside", shadow.beside);
  changed |= slider_row({"Split", "##split", "Where the two meet."}, shadow.split, 0, 1, "%.2f");
  property("");
  ImGui::TextUnformatted(statistics.differing ? text_of("%zu pixels differ", *statistics.differing).c_str()
                                              : "counting the pixels that differ");
  tooltip("Pixels of the whole picture that are in shadow with one method and lit with the other.");
  return changed;
}

void trace_rows(ViewState& view, const ShadowStatistics& statistics) {
  property("Rays");
  draw_switch(view, SwitchId::kTrace, "trace");
  if (!view.look.show.shadow_reference) return;
  property("");
  ImGui::TextUnformatted(
      (statistics.wrong ? text_of("%zu wrong", *statistics.wrong) : tracing_text(statistics)).c_str());
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
  Light::Kind kind = light.kind;
  if (choice_row("Kind", "##kind", kind, "Directional\0Point\0", nullptr,
                 "Drag its handle in the picture to move it.")) {
    choose_kind(light, kind, bounds);
    changed = true;
  }
  property("Colour");
  glm::vec3 shown = glm::sqrt(glm::clamp(glm::vec3(light.colour), 0.0f, 1.0f));
  if (ImGui::ColorEdit3("##colour", &shown.x, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs)) {
    light.colour = Vec3(shown * shown);
    changed = true;
  }
  changed |= slider_row(
      {"Intensity", "##intensity",
       "What arrives on a surface that faces it; of a lamp at a distance of one size of the world.", true},
      light.intensity, kLeastIntensity, kMostIntensity, "%.3g");
  return changed;
}

bool preset_row(ViewOptions& look, const World::Bounds& bounds, UpAxis up) {
  property("Preset");
  bool changed = false;
  if (begin_fitted_combo("##preset", "Choose")) {
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

// The lights and how their shadows are cast. `bounds` are those of the world.
void draw_light_panel(ViewState& view, const World::Bounds& bounds, const ShadowStatistics& statistics) {
  ViewOptions& look = view.look;
  bool changed = choose_light(look, view.camera.up_axis());
  if (begin_properties("light")) {
    changed |= preset_row(look, bounds, view.camera.up_axis());
    if (look.shadow.inspected < look.lights.size())
      changed |= light_rows(look.lights[look.shadow.inspected], bounds);
    changed |= shadow_rows(view);
    changed |= compare_rows(view, statistics);
    trace_rows(view, statistics);
    end_properties();
  }
  if (changed) view.picture_old = true;
}

constexpr const char* kLightPanel = "Light";

class LightFeature : public Feature {
 public:
  explicit LightFeature(Workspace& on) : on_(on) {}

  std::vector<Panel> panels() override {
    return {{kLightPanel, Tab::kLook, 1310, false,
             [this] { draw_light_panel(on_.view, on_.world().bounds(), on_.statistics.shadows); }}};
  }
  std::vector<ActionGroup> actions() override { return {{1300, "Light", light_actions()}}; }
  std::vector<Gesture> gestures() const override {
    return {{130, "Left drag on a light", "Move it, while the Light panel is open"}};
  }

  std::unique_ptr<Interaction> claim(const Press&) override {
    const auto light = light_under(on_.view, on_.pointer);
    if (!light || !shows_handles()) return nullptr;
    return std::make_unique<PlainDrag>("Moving a light", [this, light = *light](const InputEvent&) {
      drag_light(on_.view, light, on_.pointer);
    });
  }

  void forget() override { on_.view.look.shadow.inspected = 0; }

  void draw_marks(ImDrawList& list) override {
    if (shows_handles() && !on_.cutting()) draw_light_handles(on_.view, list);
  }
  void mark(Landmarks& landmarks) const override {
    for (size_t i = 0; i < on_.view.look.lights.size() && shows_handles(); ++i) {
      if (const auto handle = light_handle(on_.view, i))
        landmarks.mark("light " + std::to_string(i), {*handle, Vec2(0)});
    }
  }
  // Where each light is, and its handle in the window where that is shown.
  void report(nlohmann::ordered_json& report) const override {
    nlohmann::ordered_json& all = report["lights"] = nlohmann::ordered_json::array();
    for (size_t i = 0; i < on_.view.look.lights.size(); ++i) {
      const Vec3& at = on_.view.look.lights[i].at;
      nlohmann::ordered_json light{{"at", {at.x, at.y, at.z}}};
      const auto handle = light_handle(on_.view, i);
      if (handle && shows_handles()) light["handle"] = {handle->x, handle->y};
      all.push_back(light);
    }
    const auto& wrong = on_.statistics.shadows.wrong;
    report["pixels_that_rays_have_otherwise"] =
        wrong ? nlohmann::ordered_json(*wrong) : nlohmann::ordered_json();
  }

 private:
  bool shows_handles() const { return on_.panels.shows(kLightPanel); }
  std::vector<UserAction> light_actions();
  std::vector<UserAction> presets();

  Workspace& on_;
};

std::vector<UserAction> LightFeature::presets() {
  std::vector<UserAction> actions;
  for (const LightPreset& preset : light_presets()) {
    actions.push_back({.name = preset.name, .tip = preset.meaning});
    actions.back().run = [&on = on_, &preset] {
      ViewOptions& look = on.view.look;
      look.lights = lights_of(preset, on.world().bounds(), on.view.camera.up_axis());
      look.shadow.inspected = 0;
      on.view.picture_old = true;
    };
  }
  return actions;
}

std::vector<UserAction> LightFeature::light_actions() {
  ViewState& view = on_.view;
  ViewOptions& look = view.look;
  UserAction add = picture_action(view, "Add a light",
                                  "A directional light; its handle is dragged while the Light panel is open.",
                                  [&view] { add_light(view.look, view.camera.up_axis()); });
  add.why_not = [&look] {
    return look.lights.size() < kMostLights ? nullptr : "There are four lights already.";
  };
  UserAction remove = picture_action(view, "Remove the chosen light", "The one that the Light panel shows.",
                                     [&look] { remove_light(look); });
  remove.why_not = [&look] { return look.lights.empty() ? "There is no light." : nullptr; };
  UserAction next =
      picture_action(view, "Next light", "Chooses the light whose values the Light panel shows.", [&look] {
        KERF_ASSERT(!look.lights.empty());
        look.shadow.inspected = (look.shadow.inspected + 1) % look.lights.size();
      });
  next.why_not = [&look] { return look.lights.size() < 2 ? "There is no other light." : nullptr; };
  return {UserAction{.name = "Light preset", .items = [this] { return presets(); }, .in_menu = false}, add,
          remove, next,
          flag_action(view, "Shadows: paper look", look.shadow.paper_look,
                      "Transparent black over what is in shadow, in place of leaving the light out.")};
}

}  // namespace

std::unique_ptr<Feature> light_feature(Workspace& on) { return std::make_unique<LightFeature>(on); }

}  // namespace kerf
