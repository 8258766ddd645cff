#include "core/base/json.h"
#include "ui/editor/shared/features.h"

#include <imgui.h>

#include <GLFW/glfw3.h>

#include <cmath>

#include "core/base/assert.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/user_input.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/editor/view/legends.h"
#include "ui/render/view/view_switches.h"
#include "ui/window/property_rows.h"

namespace kerf {

namespace {

class DisplayPanel {
 public:
  void draw(Settings& settings, const ViewState& view);

 private:
  double wanted_scale_ = 0;  // of the text, while the slider moves
};

// Applies the size when the slider is released, because the slider itself changes with it.
void scale_row(Settings& settings, double& wanted) {
  property("UI Scale");
  constexpr double kLow = Settings::kMinScale * 100, kHigh = Settings::kMaxScale * 100;
  double percent = wanted > 0 ? 100 * wanted : 100 * settings.ui_scale;
  constexpr const char* kMeaning = "Size of panels and menus, relative to the scale of the display.";
  if (real_slider({"UI Scale", "##scale", kMeaning}, percent, kLow, kHigh, "%.0f %%"))
    wanted = std::round(percent / 5) * 0.05;
  if (ImGui::IsItemDeactivated() && wanted > 0) {
    settings.ui_scale = wanted;
    wanted = 0;
  }
}

void DisplayPanel::draw(Settings& settings, const ViewState& view) {
  if (!begin_properties("display")) return;
  choice_row(
      "Theme", "##theme", settings.theme, "Dark\0Light\0", nullptr,
      with_shortcut(view, "Colours of panels and menus; the viewport keeps its own.", "view.light_theme")
          .c_str());
  scale_row(settings, wanted_scale_);
  end_properties();
}

constexpr double kScaleStep = 0.125;

// A press on the axes: a click looks along an axis, a drag orbits.
class PressOnAxes : public Interaction {
 public:
  explicit PressOnAxes(Workspace& workspace) : workspace_(workspace), pressed_at_(workspace.input.pointer) {}

  void move(const InputEvent& event) override {
    if (orbit_) {
      orbit_->move(event);
    } else if (glm::length(workspace_.input.pointer - pressed_at_) > kClickReach) {
      orbit_.emplace(workspace_);
    }
  }
  void release(const InputEvent&) override {
    const auto axis = orbit_ ? std::nullopt : axis_end_under(workspace_.view, workspace_.input.pointer);
    if (axis) workspace_.view.camera.turn_to(axis->view.yaw, axis->view.pitch);
  }
  const char* words() const override { return orbit_ ? orbit_->words() : nullptr; }

 private:
  Workspace& workspace_;
  Vec2 pressed_at_;
  std::optional<Orbit> orbit_;
};

void copy_view(const ViewState& view, Message& message) {
  ImGui::SetClipboardText(view_text({view.seen().near().eye, view.camera.pivot()}).c_str());
  message.info("Copied the camera as text");
}

void paste_view(ViewState& view, Message& message) {
  const char* text = ImGui::GetClipboardText();
  const Result<View> pasted = parse_view_text(text != nullptr ? text : "");
  if (!pasted) return message.error(pasted.error().message);
  view.camera.look(pasted->eye, pasted->target);
  message.clear();
}

void change_scale(Settings& settings, double by) {
  settings.ui_scale = std::clamp(settings.ui_scale + by, Settings::kMinScale, Settings::kMaxScale);
}

// Returns the action of a standard view. Each pair of views shares a key; the second one adds Ctrl.
UserAction look_action(ViewState& view, size_t which) {
  constexpr std::array kIds{"view.front", "view.back", "view.right", "view.left", "view.top", "view.bottom"};
  static_assert(kIds.size() == kStandardViews.size());
  constexpr std::array kKeys{"1", "3", "7"};
  constexpr std::array kPadKeys{GLFW_KEY_KP_1, GLFW_KEY_KP_3, GLFW_KEY_KP_7};
  const StandardView& looked = kStandardViews.at(which);
  const bool opposite = which % 2 == 1;
  UserAction action{.id = kIds.at(which),
                    .name = looked.name,
                    .shortcut = std::string(opposite ? "Ctrl+" : "") + kKeys.at(which / 2),
                    .pad_key = kPadKeys.at(which / 2),
                    .tip = "Also on the number pad, and by clicking the axes in the corner."};
  action.run = [&view, &looked] { view.camera.turn_to(looked.yaw, looked.pitch); };
  return action;
}

UserAction switch_action(ViewState& view, Message& message, const ViewSwitch& s) {
  UserAction action{.id = action_id(s), .name = action_name(s), .tip = s.tip};
  if (s.key != 0) action.shortcut = std::string(1, s.key);
  action.run = [&view, &message, &s] {
    s.flip(view.look);
    view.picture_old = true;
    if (!s.is_two_state()) message.info(std::string(s.label) + ": " + s.states[s.get(view.look)]);
  };
  action.checked = [&view, &s] { return s.get(view.look) != 0; };
  return action;
}

// Returns the first half without the label in its corner.
Area under_label(const Layout& l) {
  const Vec2 label(0, l.split() ? 2.2 * ImGui::GetTextLineHeight() + ImGui::GetFontSize() : 0);
  return {l.first.at + label, l.first.size - label};
}

class ViewFeature : public Feature {
 public:
  // The legends drawn here replace those of the renderer.
  explicit ViewFeature(Workspace& workspace) : workspace_(workspace) { workspace_.view.look.legends = false; }

  std::vector<PanelPart> panel_parts() override {
    return {{"view.switches", [this] { draw_switches(); }},
            {"display", [this] { display_.draw(workspace_.settings, workspace_.view); }}};
  }
  std::vector<UserAction> actions() override {
    return joined(
        {text_of_view_actions(), camera_actions(), switch_actions(), {theme_action()}, scale_actions()});
  }
  std::vector<Gesture> gestures() const override {
    return {
        {"look_along_axis", "Click on the axes in the corner", "Look along that axis; a drag there orbits"}};
  }

  std::unique_ptr<Interaction> begin_interaction(const Press&) override {
    return is_on_axes(workspace_.view, workspace_.input.pointer) ? std::make_unique<PressOnAxes>(workspace_)
                                                                 : nullptr;
  }

  void draw_overlay(ImDrawList& list) override {
    draw_axes_gizmo(workspace_.view, workspace_.input.pointer_in_viewport(), list);
    workspace_.view.legends =
        draw_legends(legends_of(workspace_.view.look, workspace_.services.statistics.shadows),
                     under_label(workspace_.view.layout));
  }
  void add_landmarks(Landmarks& landmarks) const override {
    for (const AxisEnd& end : axis_ends(workspace_.view)) landmarks.mark(name_of(end), {end.at, Vec2(0)});
  }
  void write_session_log(nlohmann::ordered_json& report) const override;

 private:
  void draw_switches() {
    for (const ViewSwitch& s : view_switches()) {
      if (s.in_view_panel) draw_switch(workspace_.view, s.id);
    }
  }
  std::vector<UserAction> text_of_view_actions();
  std::vector<UserAction> camera_actions();
  std::vector<UserAction> switch_actions();
  UserAction theme_action();
  std::vector<UserAction> scale_actions();

  Workspace& workspace_;
  DisplayPanel display_;
};

std::vector<UserAction> ViewFeature::text_of_view_actions() {
  return {
      UserAction{.id = "view.copy_camera",
                 .name = "Copy Camera",
                 .shortcut = "Ctrl+C",
                 .tip = "Copies the position of the camera as text.",
                 .run = [this] { copy_view(workspace_.view, workspace_.message); }},
      UserAction{.id = "view.paste_camera",
                 .name = "Paste Camera",
                 .shortcut = "Ctrl+V",
                 .tip = "Sets the camera from text in the clipboard.",
                 .run = [this] { paste_view(workspace_.view, workspace_.message); }},
  };
}

std::vector<UserAction> ViewFeature::camera_actions() {
  std::vector<UserAction> actions{
      UserAction{.id = "view.frame_all",
                 .name = "Frame All",
                 .shortcut = "F",
                 .tip = "Fits the scene in the viewport and keeps the direction of view.",
                 .run =
                     [this] {
                       workspace_.view.camera.frame(workspace_.world().bounds(), workspace_.view.aspect());
                     }},
      UserAction{.id = "view.reset",
                 .name = "Reset View",
                 .shortcut = "Home",
                 .tip = "Restores the view as it was when the file was opened.",
                 .run = [this] { go_home(workspace_.view, workspace_.world().bounds()); }},
  };
  for (size_t i = 0; i < kStandardViews.size(); ++i) actions.push_back(look_action(workspace_.view, i));
  actions.push_back(
      UserAction{.id = "view.orthographic",
                 .name = "Orthographic",
                 .shortcut = "5",
                 .pad_key = GLFW_KEY_KP_5,
                 .tip = "Projection without perspective: sizes do not depend on the distance.",
                 .run = [this] { workspace_.view.camera.set_parallel(!workspace_.view.camera.parallel()); },
                 .checked = [this] { return workspace_.view.camera.parallel(); }});
  return actions;
}

std::vector<UserAction> ViewFeature::switch_actions() {
  std::vector<UserAction> actions;
  for (const ViewSwitch& each : view_switches()) {
    if (each.label[0] != '\0') actions.push_back(switch_action(workspace_.view, workspace_.message, each));
  }
  return actions;
}

UserAction ViewFeature::theme_action() {
  Theme& theme = workspace_.settings.theme;
  return {.id = "view.light_theme",
          .name = "Light Theme",
          .shortcut = "F9",
          .tip = "Light panels and menus; the viewport keeps its colours.",
          .run = [&theme] { theme = theme == Theme::kLight ? Theme::kDark : Theme::kLight; },
          .checked = [&theme] { return theme == Theme::kLight; }};
}

std::vector<UserAction> ViewFeature::scale_actions() {
  Settings& settings = workspace_.settings;
  return {
      UserAction{.id = "view.scale_up",
                 .name = "Increase UI Scale",
                 .shortcut = "Ctrl+=",
                 .tip = "Size of panels and menus.",
                 .run = [&settings] { change_scale(settings, kScaleStep); },
                 .disabled_reason =
                     [&settings] {
                       return settings.ui_scale >= Settings::kMaxScale ? "Already at the maximum size."
                                                                       : nullptr;
                     }},
      UserAction{.id = "view.scale_down",
                 .name = "Decrease UI Scale",
                 .shortcut = "Ctrl+-",
                 .tip = "Size of panels and menus.",
                 .run = [&settings] { change_scale(settings, -kScaleStep); },
                 .disabled_reason =
                     [&settings] {
                       return settings.ui_scale <= Settings::kMinScale ? "Already at the minimum size."
                                                                       : nullptr;
                     }},
  };
}

void ViewFeature::write_session_log(nlohmann::ordered_json& report) const {
  nlohmann::ordered_json& all = report["view"];
  for (const ViewSwitch& s : view_switches()) {
    const size_t state = s.get(workspace_.view.look);
    KERF_ASSERT(state < s.states.size());
    all[s.report] = s.is_two_state() ? nlohmann::ordered_json(state == 1) : s.states[state];
  }
  all["section_plane"] = nullptr;
  if (const SectionPlane* plane = shown_section(workspace_.view.look))
    all["section_plane"] = section_text(*plane);
  all["boxes_deepest"] = workspace_.view.look.tree.deepest;
  all["boxes_leaves_only"] = workspace_.view.look.tree.leaves_only;
  const Vec3 eye = workspace_.view.seen().near().eye;
  all["eye"] = {eye.x, eye.y, eye.z};
  all["orthographic"] = workspace_.view.camera.parallel();
  all["frame"] = frame_to_json(workspace_.view.frame);
}

}  // namespace

std::unique_ptr<Feature> view_feature(Workspace& workspace) {
  return std::make_unique<ViewFeature>(workspace);
}

}  // namespace kerf
