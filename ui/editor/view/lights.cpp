#include "ui/editor/view/lights.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/screen/live_picture.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

const Vec3 kWarm(1.0, 0.72, 0.42), kCool(0.72, 0.86, 1.0), kPale(1.0, 0.93, 0.82);

Light sun(const Vec3& direction, const Vec3& colour, double intensity) {
  return {Light::Kind::kDirectional, direction, colour, intensity};
}

// Returns a lamp at a place in -1 .. 1 of the bounds, as bright at their centre as a sun of `intensity`.
Light lamp(const World::Bounds& bounds, const Vec3& place, const Vec3& colour, double intensity) {
  const Vec3 middle = (bounds.min + bounds.max) * 0.5, half = (bounds.max - bounds.min) * 0.5;
  const double diagonal = std::max(bounds.diagonal(), 1e-9);
  const Vec3 at = middle + place * half;
  const double share = std::max(glm::length(at - middle) / diagonal, 0.1);
  return {Light::Kind::kPoint, at, colour, intensity * share * share};
}

const std::array<LightPreset, 6> kLightPresets{{
    {"Workshop", "One key light from the upper left.",
     [](const World::Bounds&) { return std::vector{Light{}}; }},
    {"Noon", "The sun directly above.",
     [](const World::Bounds&) {
       return std::vector{sun({0.12, 1, 0.08}, kPale, 2.2)};
     }},
    {"Low Sun", "Warm and grazing, with long shadows.",
     [](const World::Bounds&) {
       return std::vector{sun({-1, 0.32, 0.45}, kWarm, 2.6)};
     }},
    {"Lamp Overhead", "A lamp close above the scene.",
     [](const World::Bounds& b) {
       return std::vector{lamp(b, {0.5, 3.2, 0.4}, kPale, 2.2)};
     }},
    {"Lamp Inside", "A lamp in the centre; light shines out through the holes.",
     [](const World::Bounds& b) {
       return std::vector{lamp(b, {0.02, 0.05, 0.02}, kWarm, 3.5)};
     }},
    {"Floodlights", "Four lamps around the scene, as in a stadium.",
     [](const World::Bounds& b) {
       return std::vector{lamp(b, {-3, 4, 2}, kPale, 0.8), lamp(b, {3, 4, 2}, kCool, 0.7),
                          lamp(b, {3, 4, -2}, kPale, 0.6), lamp(b, {-3, 4, -2}, kCool, 0.6)};
     }},
}};

constexpr double kReach = 12;     // pick radius of a handle, screen coordinates
constexpr double kSphere = 0.72;  // its radius, relative to half the height of the viewport

// Sphere around the pivot of the camera that always fits the viewport.
struct Sphere {
  Vec3 middle;
  double radius;
};

Sphere sphere_of(const CameraView& view) {
  return {view.eye + view.forward * view.focus, kSphere * view.half_height()};
}

Vec3 place_of(const Light& light, const CameraView& view) {
  if (light.kind == Light::Kind::kPoint) return light.at;
  const Sphere sphere = sphere_of(view);
  return sphere.middle + glm::normalize(light.at) * sphere.radius;
}

constexpr double kMinIntensity = 0.02, kMaxIntensity = 50;
constexpr double kMinReach = 0.25, kMaxReach = 50;  // diagonals

struct ShadowMethodRow {
  ShadowMethod method;
  const char *name, *tip;
};

constexpr std::array kShadowMethods{
    ShadowMethodRow{ShadowMethod::kRobust, "Robust",
                    "Each polygon spans a closed infinite volume, counted from behind. Correct for any mesh "
                    "and viewpoint."},
    ShadowMethodRow{ShadowMethod::kPaperOneVolume, "Paper, One Volume",
                    "Extrudes the silhouette of light-facing polygons, without caps. Correct for closed "
                    "meshes and lit viewpoints."},
    ShadowMethodRow{ShadowMethod::kPaperTwoVolumes, "Paper, Two Volumes",
                    "Adds a volume for the back-facing polygons: the paper's solution for hollow meshes."},
};

const ShadowMethodRow& row_of(ShadowMethod method) {
  return *std::ranges::find(kShadowMethods, method, &ShadowMethodRow::method);
}

bool method_row(const char* label, const char* id, ShadowMethod& method) {
  property(label);
  bool changed = false;
  const ShadowMethodRow& now = row_of(method);
  if (begin_fitted_combo(id, now.name)) {
    for (const ShadowMethodRow& m : kShadowMethods) {
      if (ImGui::Selectable(m.name, m.method == method)) {
        changed = m.method != method;
        method = m.method;
      }
      tooltip(m.tip);
    }
    ImGui::EndCombo();
  } else {
    tooltip(now.tip);
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
         "Length of the paper's volumes in world sizes; objects beyond it receive no shadow.", true},
        shadow.extrusion, kMinReach, kMaxReach, "%.2g sizes");
  }
  property("");
  changed |= ImGui::Checkbox("Paper Style", &shadow.paper_look);
  tooltip("Draws shadows as transparent black, as in the paper, instead of omitting the light.");
  property("");
  draw_switch(view, SwitchId::kCullBacks);
  return changed;
}

bool compare_rows(ViewState& view, const ShadowStatistics& statistics) {
  ShadowOptions& shadow = view.look.shadow;
  property("Compare");
  draw_switch(view, SwitchId::kCompare, "Two Methods");
  if (!view.look.show.shadow_compare) return false;
  bool changed = method_row("With", "##second", shadow.beside);
  changed |= slider_row({"Split", "##split", "Position of the boundary between the two methods."},
                        shadow.split, 0, 1, "%.2f");
  property("");
  ImGui::TextUnformatted(statistics.differing ? (count_text(*statistics.differing, "pixel") +
                                                 (*statistics.differing == 1 ? " differs" : " differ"))
                                                    .c_str()
                                              : "counting pixels...");
  tooltip("Pixels of the viewport in shadow with one method and lit with the other.");
  return changed;
}

void trace_rows(ViewState& view, const ShadowStatistics& statistics) {
  property("Rays");
  draw_switch(view, SwitchId::kTrace, "Trace");
  if (!view.look.show.shadow_reference) return;
  property("");
  ImGui::TextUnformatted(
      (statistics.wrong ? count_text(*statistics.wrong, "wrong pixel") : tracing_text(statistics)).c_str());
}

void select_kind(Light& light, Light::Kind kind, const World::Bounds& bounds) {
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
  if (choice_row("Type", "##kind", kind, "Directional\0Point\0", nullptr,
                 "Drag the handle in the viewport to move the light.")) {
    select_kind(light, kind, bounds);
    changed = true;
  }
  property("Colour");
  glm::vec3 shown = glm::sqrt(glm::clamp(glm::vec3(light.colour), 0.0f, 1.0f));
  if (ImGui::ColorEdit3("##colour", &shown.x, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs)) {
    light.colour = Vec3(shown * shown);
    changed = true;
  }
  changed |=
      slider_row({"Intensity", "##intensity",
                  "Light on a surface that faces it; for a lamp at a distance of one world size.", true},
                 light.intensity, kMinIntensity, kMaxIntensity, "%.3g");
  return changed;
}

bool preset_row(ViewOptions& look, const World::Bounds& bounds, UpAxis up) {
  property("Preset");
  bool changed = false;
  if (begin_fitted_combo("##preset", "Select Preset")) {
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

bool select_light(ViewOptions& look, UpAxis up) {
  std::vector<Light>& lights = look.lights;
  size_t& selected = look.shadow.inspected;
  bool changed = false;
  for (size_t i = 0; i < lights.size(); ++i) {
    const std::string label = " " + std::to_string(i + 1) + " ";
    if (i > 0) ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Button,
                          ImGui::GetStyleColorVec4(i == selected ? ImGuiCol_ButtonActive : ImGuiCol_Button));
    if (ImGui::Button(label.c_str())) {
      changed = selected != i;
      selected = i;
    }
    ImGui::PopStyleColor();
  }
  if (!lights.empty()) ImGui::SameLine();
  ImGui::BeginDisabled(lights.size() >= kMaxLights);
  if (ImGui::Button("Add")) {
    add_light(look, up);
    changed = true;
  }
  tooltip("Adds a light, up to four.");
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

// Draws the lights and shadow options. `bounds`: of the world.
void draw_light_panel(ViewState& view, const World::Bounds& bounds, const ShadowStatistics& statistics) {
  ViewOptions& look = view.look;
  bool changed = select_light(look, view.camera.up_axis());
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

constexpr const char* kLightPanel = "light";

class LightFeature : public Feature {
 public:
  LightFeature(const DocumentSession& session, ViewState& view, const PointerInput& input, Services& services)
      : session_(session), view_(view), input_(input), services_(services) {}

  std::vector<PanelPart> panel_parts() override {
    return {{kLightPanel,
             [this] { draw_light_panel(view_, session_.world().bounds(), services_.statistics.shadows); }}};
  }
  std::vector<UserAction> actions() override { return light_actions(); }
  std::vector<Gesture> gestures() const override {
    return {{"move_light", "Left drag on a light", "Move it, while the Light panel is open"}};
  }

  std::unique_ptr<Interaction> begin_interaction(const Press&) override {
    const auto light = light_under(view_, input_.pointer);
    if (!light || !shows_handles()) return nullptr;
    return std::make_unique<PlainDrag>("Moving a light", [this, light = *light](const InputEvent&) {
      drag_light(view_, light, input_.pointer);
    });
  }

  void on_document_opened() override { view_.look.shadow.inspected = 0; }

  void draw_overlay(ImDrawList& list) override {
    if (shows_handles() && !is_cutting(input_, session_.document)) draw_light_handles(view_, list);
  }
  void add_landmarks(Landmarks& landmarks) const override {
    for (size_t i = 0; i < view_.look.lights.size() && shows_handles(); ++i) {
      if (const auto handle = light_handle(view_, i))
        landmarks.mark("light " + std::to_string(i), {*handle, Vec2(0)});
    }
  }
  // Reports the position of each light, and its handle in the window if visible.
  void write_session_log(nlohmann::ordered_json& report) const override {
    nlohmann::ordered_json& all = report["lights"] = nlohmann::ordered_json::array();
    for (size_t i = 0; i < view_.look.lights.size(); ++i) {
      const Vec3& at = view_.look.lights[i].at;
      nlohmann::ordered_json light{{"at", {at.x, at.y, at.z}}};
      const auto handle = light_handle(view_, i);
      if (handle && shows_handles()) light["handle"] = {handle->x, handle->y};
      all.push_back(light);
    }
    const auto& wrong = services_.statistics.shadows.wrong;
    report["pixels_that_rays_have_otherwise"] =
        wrong ? nlohmann::ordered_json(*wrong) : nlohmann::ordered_json();
  }

 private:
  bool shows_handles() const { return services_.panels.shows(kLightPanel); }
  std::vector<UserAction> light_actions() {
    ViewOptions& look = view_.look;
    UserAction add =
        picture_action(view_, "light.add", "Add Light",
                       "Adds a directional light; drag its handle while the Light panel is open.",
                       [this] { add_light(view_.look, view_.camera.up_axis()); });
    add.disabled_reason = [&look] {
      return look.lights.size() < kMaxLights ? nullptr : "There are already four lights, the maximum.";
    };
    UserAction remove =
        picture_action(view_, "light.remove", "Remove Light", "Removes the light shown in the Light panel.",
                       [&look] { remove_light(look); });
    remove.disabled_reason = [&look] { return look.lights.empty() ? "There is no light." : nullptr; };
    UserAction next = picture_action(
        view_, "light.next", "Next Light", "Selects the next light in the Light panel.", [&look] {
          KERF_ASSERT(!look.lights.empty());
          look.shadow.inspected = (look.shadow.inspected + 1) % look.lights.size();
        });
    next.disabled_reason = [&look] { return look.lights.size() < 2 ? "There is no other light." : nullptr; };
    return {UserAction{.id = "light.preset", .name = "Light Preset", .items = [this] { return presets(); }},
            add, remove, next,
            flag_action(view_, "light.paper_look", "Paper Shadow Style", look.shadow.paper_look,
                        "Draws shadows as transparent black instead of omitting the light.")};
  }
  std::vector<UserAction> presets() {
    std::vector<UserAction> actions;
    for (const LightPreset& preset : light_presets()) {
      actions.push_back({.name = preset.name, .tip = preset.meaning});
      actions.back().run = [this, &preset] {
        view_.look.lights = lights_of(preset, session_.world().bounds(), view_.camera.up_axis());
        view_.look.shadow.inspected = 0;
        view_.picture_old = true;
      };
    }
    return actions;
  }

  const DocumentSession& session_;
  ViewState& view_;
  const PointerInput& input_;
  Services& services_;
};

}  // namespace

const char* method_name(ShadowMethod method) { return row_of(method).name; }

std::span<const LightPreset> light_presets() { return kLightPresets; }

std::vector<Light> lights_of(const LightPreset& preset, const World::Bounds& bounds, UpAxis up) {
  const Vec3 a = to_y_up(bounds.min, up), b = to_y_up(bounds.max, up);
  std::vector<Light> lights = preset.lights({glm::min(a, b), glm::max(a, b)});
  for (Light& light : lights) light.at = from_y_up(light.at, up);
  return lights;
}

void add_light(ViewOptions& look, UpAxis up) {
  KERF_ASSERT(look.lights.size() < kMaxLights);
  Light another;
  another.at = from_y_up({0.7, 0.8, -0.4}, up);
  another.intensity = 1;
  look.shadow.inspected = look.lights.size();
  look.lights.push_back(another);
}

void remove_light(ViewOptions& look) {
  KERF_ASSERT(!look.lights.empty());
  const size_t selected = std::min(look.shadow.inspected, look.lights.size() - 1);
  look.lights.erase(look.lights.begin() + static_cast<std::ptrdiff_t>(selected));
  look.shadow.inspected = 0;
}

std::optional<Vec2> light_handle(const ViewState& view, size_t light) {
  if (light >= view.look.lights.size()) return std::nullopt;
  const PrimaryViewport picture(view);
  const auto at = picture.place_of(place_of(view.look.lights[light], picture.camera()));
  return at && view.layout.first.contains(*at) ? at : std::nullopt;
}

std::optional<size_t> light_under(const ViewState& view, Vec2 at) {
  for (size_t i = 0; i < view.look.lights.size(); ++i) {
    const std::optional<Vec2> handle = light_handle(view, i);
    if (handle && glm::length(*handle - at) < kReach) return i;
  }
  return std::nullopt;
}

void drag_light(ViewState& view, size_t light, Vec2 to) {
  if (light >= view.look.lights.size()) return;
  Light& dragged = view.look.lights[light];
  const PrimaryViewport picture(view);
  if (dragged.kind == Light::Kind::kPoint) {
    dragged.at = picture.at_depth_of(dragged.at, to);
  } else {
    const Sphere sphere = sphere_of(picture.camera());
    const Vec3 now = place_of(dragged, picture.camera());
    dragged.at =
        glm::normalize(dragged_around(picture, sphere.middle, sphere.radius, now, to) - sphere.middle);
  }
  view.look.shadow.inspected = light;
  view.picture_old = true;
}

void draw_light_handles(const ViewState& view, ImDrawList& list) {
  for (size_t i = 0; i < view.look.lights.size(); ++i) {
    const std::optional<Vec2> at = light_handle(view, i);
    if (!at) continue;
    const Light& light = view.look.lights[i];
    const bool selected = view.look.shadow.inspected == i;
    const ImVec4 colour(static_cast<float>(std::sqrt(std::min(light.colour.x, 1.0))),
                        static_cast<float>(std::sqrt(std::min(light.colour.y, 1.0))),
                        static_cast<float>(std::sqrt(std::min(light.colour.z, 1.0))), 1);
    list.AddCircleFilled(to_im(*at), 7.5f, IM_COL32(10, 12, 16, 170));
    list.AddCircleFilled(to_im(*at), 5, ImGui::ColorConvertFloat4ToU32(colour));
    list.AddCircle(to_im(*at), 9, selected ? colours::accent() : colours::kPictureSecondary, 0, 1.5f);
    // Rays distinguish the sun from a lamp.
    for (int ray = 0; light.kind == Light::Kind::kDirectional && ray < 8; ++ray) {
      const Vec2 out(std::cos(0.785398 * ray), std::sin(0.785398 * ray));
      list.AddLine(to_im(*at + out * 11.0), to_im(*at + out * 15.0),
                   selected ? colours::accent() : colours::kPictureSecondary, 1.5f);
    }
  }
}

std::unique_ptr<Feature> light_feature(Workspace& workspace) {
  return std::make_unique<LightFeature>(workspace.session, workspace.view, workspace.input,
                                        workspace.services);
}

}  // namespace kerf
