#include "ui/editor/view/legends.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/user_input.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/editor/view/lights.h"
#include "ui/render/passes/heat_colours.h"
#include "ui/render/passes/mark_passes.h"
#include "ui/render/view/colours.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

using namespace overlay_colours;

namespace {

using Rows = std::vector<Legend::Row>;

Legend::Row sentence(std::string text) { return {0, std::move(text), false}; }

Legend legend_of_boxes(const ViewOptions& look) {
  const BoxColours colours = colours_of(look.tree.palette);
  const bool hit_only = look.show.aabb_hit || look.tree.hit_only;
  Legend legend;
  legend.title = look.tree.leaves_only ? "Leaf Nodes" : "AABB Tree";
  legend.rows.push_back({colours.hit, "hit by the beam"});
  if (!hit_only) legend.rows.push_back({colours.untouched, "not hit"});
  if (!hit_only) legend.rows.push_back({colours.edited, "face created by a cut"});
  if (look.tree_path) legend.rows.push_back({colours.path, "path to the face under the pointer"});
  if (look.tree.one_level)
    legend.rows.push_back(sentence("only level " + std::to_string(look.tree.deepest) + " below the root"));
  else if (!look.tree.leaves_only && look.tree.deepest < TreeOverlay().deepest)
    legend.rows.push_back(sentence("down to level " + std::to_string(look.tree.deepest) + " below the root"));
  return legend;
}

Legend legend_of_counts() {
  Legend legend{"Occluders (Stencil Count)", {{kLit, "none"}}};
  for (size_t i = 0; i < kCounts.size(); ++i)
    legend.rows.push_back({kCounts[i], std::to_string(i + 1) + (i + 1 == kCounts.size() ? " or more" : "")});
  return legend;
}

Legend legend_of_comparison(const ViewOptions& look, const ShadowStatistics& shadows) {
  return {"Shadow Methods",
          {sentence("left: " + std::string(method_name(look.shadow.method))),
           sentence("right: " + std::string(method_name(look.shadow.beside))),
           sentence((shadows.differing ? count_text(*shadows.differing, "pixel") : "counting pixels that") +
                    (shadows.differing == 1u ? " is" : " are") + " in shadow with"),
           sentence("one of them and lit with the other")}};
}

Legend legend_of_rays(const ShadowStatistics& shadows) {
  return {"Ray-Traced Shadows",
          {{kTracedLit, "lit"},
           {kTracedShadow, "in shadow"},
           {kWrong, "viewport differs: " +
                        (shadows.wrong ? count_text(*shadows.wrong, "pixel") : tracing_text(shadows))}}};
}

// Returns the legend of a view; empty if it has no colours of its own.
Legend legend_of(SwitchId view, const ViewOptions& look, const ShadowStatistics& shadows) {
  switch (view) {
    case SwitchId::kSilhouette:
      return {"Silhouette: Volume Sides per Edge",
              {{kOneSide, "one"}, {kTwoSides, "two"}, {kMoreSides, "three or more"}}};
    case SwitchId::kShadowVolumes:
      return {"Shadow Volumes", {{kVolumeFront, "front faces"}, {kVolumeBack, "back faces"}}};
    case SwitchId::kShadowCounts:
      return legend_of_counts();
    case SwitchId::kFacing:
      return {"Light-Facing", {{kFacing, "facing it"}, {kAverted, "facing away"}, {kEdgeOn, "edge-on"}}};
    case SwitchId::kCompare:
      return legend_of_comparison(look, shadows);
    case SwitchId::kTrace:
      return legend_of_rays(shadows);
    case SwitchId::kSizes:
      return {"Refinement Level",
              {{0xf5e3a0, "split most often"},
               {0xee8f2e, "split less"},
               {0xa23a36, "split least"},
               {0x48535f, "as loaded"}}};
    case SwitchId::kBoxes:
      return legend_of_boxes(look);
    case SwitchId::kBoxesHit:
      return look.show.aabb || !look.show.aabb_hit ? Legend() : legend_of_boxes(look);
    case SwitchId::kPieces:
      return {"Pieces",
              {{0x6f7174, "part of the body"}, sentence("other colours: one separated piece each")}};
    case SwitchId::kFaceNumbers:
      return {"Face Numbers", {{0xf2f5f7, "present"}, {0xff8a78, "removed"}}};
    case SwitchId::kGraph:
      return {"Component Graph, Last Cut",
              {{kReached, "connected faces"},
               {kApart, "faces that the cut separated"},
               {kRemoved, "removed faces"},
               {kLoop, "loops of removed faces"}}};
    case SwitchId::kContacts:
      return {"Contacts", {{kHeavyContact, "the largest impulse"}, {kLightContact, "none"}}};
    case SwitchId::kColliders:
      return {"Colliders", {{kColliderPoint, "points"}, {kColliderChord, "chords"}}};
    case SwitchId::kCentres:
      return {"Centres of Mass", {{kAwake, "awake"}, {kAsleep, "asleep"}, {kPinned, "pinned"}}};
    case SwitchId::kJoints:
      return {"Joints", {{kHinge, "hinges"}, {kHub, "hubs"}, {kWeld, "welds"}}};
    case SwitchId::kHeat:
    case SwitchId::kShadows:
    case SwitchId::kRimGlow:
    case SwitchId::kWire:
    case SwitchId::kShading:
    case SwitchId::kTextures:
    case SwitchId::kSection:
    case SwitchId::kNormals:
    case SwitchId::kGhost:
    case SwitchId::kTwoSided:
    case SwitchId::kCullBacks:
    case SwitchId::kSparks:
    case SwitchId::kAntialias:
      break;
  }
  return {};
}

const char* meaning_of(StageMarks::Kind kind) {
  switch (kind) {
    case StageMarks::Kind::kSwept:
      return "swept volume";
    case StageMarks::Kind::kHit:
      return "hit faces";
    case StageMarks::Kind::kAdded:
      return "new faces";
    case StageMarks::Kind::kRemoved:
      return "removed faces";
    case StageMarks::Kind::kEntered:
      return "boxes entered by the query";
    case StageMarks::Kind::kCulled:
      return "boxes culled";
    case StageMarks::Kind::kMissed:
      return "boxes of missed faces";
    case StageMarks::Kind::kTouched:
      return "boxes of hit faces";
    case StageMarks::Kind::kLast:
      break;
  }
  return "last tested box";
}

Legend legend_of_stage(const StageMarks& marks) {
  std::set<StageMarks::Kind> kinds;
  for (const StageMarks::OfBody& body : marks.bodies) {
    for (const StageMarks::Line& line : body.lines) kinds.insert(line.kind);
  }
  Legend legend{"Step Mode", {}};
  for (const StageMarks::Kind kind : kinds) legend.rows.push_back({colour_of(kind), meaning_of(kind)});
  if (!marks.came_off.empty()) legend.rows.push_back({kApart, "separated piece"});
  if (!marks.stayed.empty()) legend.rows.push_back({kReached, "remainder"});
  return legend;
}

uint32_t hex_of(const glm::vec3& screen) {
  const glm::uvec3 c(glm::round(255.0f * screen));
  return c.r << 16 | c.g << 8 | c.b;
}

// Lists the largest value first.
Legend legend_of_scalars(const ScalarField& field) {
  Legend legend{field.name, {}};
  for (size_t i = field.labels.size(); i-- > 0;) {
    const double t = static_cast<double>(i) / static_cast<double>(field.labels.size() - 1);
    legend.rows.push_back({hex_of(scalar_colour(field.scale, t)), field.labels[i]});
  }
  return legend;
}

ImU32 opaque(uint32_t hex) { return IM_COL32(hex >> 16 & 0xffu, hex >> 8 & 0xffu, hex & 0xffu, 255); }

void draw_swatch(const Legend::Row& row, ImVec2 at, float side, ImDrawList& list) {
  const ImU32 colour = opaque(row.colour);
  list.AddRectFilled(at, {at.x + side, at.y + side}, colour, 2);
  list.AddRect(at, {at.x + side, at.y + side}, IM_COL32(255, 255, 255, 70), 2);
}

float width_of(const Legend& legend, float swatch) {
  float width = ImGui::CalcTextSize(legend.title.c_str()).x;
  for (const Legend::Row& row : legend.rows)
    width = std::max(width, ImGui::CalcTextSize(row.meaning.c_str()).x + (row.swatch ? swatch : 0));
  return width;
}

void draw_legend(const Legend& legend, ImVec2 at, ImVec2 size, ImDrawList& list) {
  const float em = ImGui::GetFontSize(), line = 1.2f * em, side = 0.8f * em;
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, colours::shade(), 3);
  ImVec2 pen{at.x + 0.6f * em, at.y + 0.5f * em};
  list.AddText(pen, colours::text(), legend.title.c_str());
  for (const Legend::Row& row : legend.rows) {
    pen.y += line;
    if (row.swatch) draw_swatch(row, {pen.x, pen.y + 0.5f * (ImGui::GetTextLineHeight() - side)}, side, list);
    list.AddText({pen.x + (row.swatch ? 1.4f * em : 0), pen.y}, colours::secondary(), row.meaning.c_str());
  }
}

constexpr double kCoarseFrom = 1000;  // K, upper end of a scale that is labelled every 500 K

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
  choice_row("Theme", "##theme", settings.theme, "Dark\0Light\0", nullptr,
             with_shortcut(view, "Colours of panels, menus and viewport.", "view.light_theme").c_str());
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
  message.info("Copied the camera as text.");
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
                    .also = {kPadKeys.at(which / 2), opposite ? GLFW_MOD_CONTROL : 0},
                    .tip = "Looks along an axis; the number pad and the axes in the corner do the same."};
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

Area right_of_toolbar(const ViewState& view, const Area& area) {
  if (view.toolbar.size.x == 0) return area;
  const Vec2 covered(view.toolbar.at.x + view.toolbar.size.x - area.at.x - 0.5 * ImGui::GetFontSize(), 0);
  return {area.at + covered, area.size - covered};
}

// Draws the ground as a line if the view sees it edge-on, where its plane is invisible.
void draw_ground_line(const ViewState& view, const World& world, ImDrawList& list) {
  const PrimaryViewport picture(view);
  const CameraView& camera = picture.camera();
  const Vec3 up = from_y_up({0, 1, 0}, view.frame.up);
  if (!camera.parallel || std::abs(glm::dot(camera.forward, up)) > 1e-6) return;
  const Vec3 middle = camera.eye + camera.focus * camera.forward;
  const double height = height_of_drawn_ground(world, view.frame.up);
  const auto place = picture.place_of(middle + (height - glm::dot(middle, up)) * up);
  const Area& half = view.layout.first;
  if (!place || place->y < half.at.y || place->y > half.at.y + half.size.y) return;
  const auto y = static_cast<float>(place->y), left = static_cast<float>(half.at.x);
  list.AddLine({left, y}, {left + static_cast<float>(half.size.x), y}, colours::kPictureSecondary, 1);
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

  // The section belongs to the document, and keeps its state.
  void on_document_opened() override {
    const bool section = workspace_.view.look.show.section;
    reset_overlays(workspace_.view.look);
    workspace_.view.look.show.section = section;
  }

  void draw_overlay(ImDrawList& list) override {
    draw_ground_line(workspace_.view, workspace_.world(), list);
    draw_axes_gizmo(workspace_.view, workspace_.input.pointer_in_viewport(), list);
    const ViewOptions& look = workspace_.view.look;
    std::vector<Legend> legends = legends_of(look, workspace_.services.statistics.shadows);
    if (look.show.heat) legends.push_back(legend_of_heat(end_of_heat_scale(workspace_.world())));
    workspace_.view.legends =
        draw_legends(legends, right_of_toolbar(workspace_.view, workspace_.view.layout.split()
                                                                    ? under_label(workspace_.view.layout)
                                                                    : workspace_.view.below_header()));
  }
  void add_landmarks(Landmarks& landmarks) const override {
    for (const AxisEnd& end : axis_ends(workspace_.view)) landmarks.mark(name_of(end), {end.at, Vec2(0)});
  }
  void write_session_log(nlohmann::ordered_json& report) const override {
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

 private:
  void draw_switches() {
    for (const ViewSwitch& s : view_switches()) {
      if (s.in_view_panel) draw_switch(workspace_.view, s.id);
    }
  }
  std::vector<UserAction> text_of_view_actions() {
    return {
        make_action("view.copy_camera", "Copy Camera", "Ctrl+Shift+C",
                    "Copies the position of the camera as text.",
                    [this] { copy_view(workspace_.view, workspace_.message); }),
        make_action("view.paste_camera", "Paste Camera", "Ctrl+Shift+V",
                    "Sets the camera from text in the clipboard.",
                    [this] { paste_view(workspace_.view, workspace_.message); }),
    };
  }
  std::vector<UserAction> camera_actions() {
    std::vector<UserAction> actions{
        make_action("view.frame_all", "Frame All", "Home",
                    "Fits the scene in the viewport and keeps the direction of view.",
                    [this] {
                      ViewState& view = workspace_.view;
                      view.camera.frame(drawn_bounds(workspace_.world(), view.look), view.aspect());
                    }),
        make_action("view.reset_overlays", "Reset Overlays", "",
                    "Turns off all overlays and debug views and restores the shadows.",
                    [this] {
                      reset_overlays(workspace_.view.look);
                      workspace_.view.picture_old = true;
                    }),
        make_action("view.reset", "Reset View", "Ctrl+Home",
                    "Restores the view as it was when the file was opened.",
                    [this] { go_home(workspace_.view, workspace_.world().bounds()); }),
    };
    for (size_t i = 0; i < kStandardViews.size(); ++i) actions.push_back(look_action(workspace_.view, i));
    actions.push_back(
        UserAction{.id = "view.orthographic",
                   .name = "Orthographic",
                   .shortcut = "5",
                   .also = {GLFW_KEY_KP_5},
                   .tip = "Switches to a projection without perspective.",
                   .run = [this] { workspace_.view.camera.set_parallel(!workspace_.view.camera.parallel()); },
                   .checked = [this] { return workspace_.view.camera.parallel(); }});
    return actions;
  }
  std::vector<UserAction> switch_actions() {
    std::vector<UserAction> actions;
    for (const ViewSwitch& each : view_switches()) {
      if (each.label[0] != '\0') actions.push_back(switch_action(workspace_.view, workspace_.message, each));
    }
    return actions;
  }
  UserAction theme_action() {
    Theme& theme = workspace_.settings.theme;
    return make_action("view.light_theme", "Light Theme", "F9",
                       "Switches panels, menus and viewport between light and dark colours.",
                       [&theme] { theme = theme == Theme::kLight ? Theme::kDark : Theme::kLight; },
                       {.checked = [&theme] { return theme == Theme::kLight; }});
  }
  std::vector<UserAction> scale_actions() {
    Settings& settings = workspace_.settings;
    return {
        make_action("view.scale_up", "Increase UI Scale", "Ctrl+=", "Changes the size of panels and menus.",
                    [&settings] { change_scale(settings, kScaleStep); },
                    {.disabled_reason =
                         [&settings] {
                           return settings.ui_scale >= Settings::kMaxScale ? "Already at the maximum size."
                                                                           : nullptr;
                         }}),
        make_action("view.scale_down", "Decrease UI Scale", "Ctrl+-", "Changes the size of panels and menus.",
                    [&settings] { change_scale(settings, -kScaleStep); },
                    {.disabled_reason =
                         [&settings] {
                           return settings.ui_scale <= Settings::kMinScale ? "Already at the minimum size."
                                                                           : nullptr;
                         }}),
    };
  }

  Workspace& workspace_;
  DisplayPanel display_;
};

}  // namespace

std::vector<Legend> legends_of(const ViewOptions& look, const ShadowStatistics& shadows) {
  std::vector<Legend> legends;
  for (const ViewSwitch& s : view_switches()) {
    if (s.get(look) == 0) continue;
    if (Legend legend = legend_of(s.id, look, shadows); !legend.title.empty())
      legends.push_back(std::move(legend));
  }
  if (look.scalar) legends.push_back(legend_of_scalars(*look.scalar));
  if (look.stage) {
    if (Legend legend = legend_of_stage(*look.stage); !legend.rows.empty())
      legends.push_back(std::move(legend));
  }
  return legends;
}

Legend legend_of_heat(double hottest) {
  KERF_ASSERT(hottest > kAmbient);
  const double step = hottest > kCoarseFrom ? 500 : 100;
  std::vector<double> labelled{hottest};
  for (double t = step * std::floor(hottest / step); t > kAmbient; t -= step) {
    if (std::min(hottest - t, t - kAmbient) > 0.25 * step) labelled.push_back(t);
  }
  labelled.push_back(kAmbient);
  Legend legend{"Temperature", {}};
  for (const double t : labelled) {
    legend.rows.push_back({hex_of(heat_colour((t - kAmbient) / (hottest - kAmbient))), text_of("%.0f K", t)});
  }
  legend.rows.front().meaning += ", melting point";
  return legend;
}

Area draw_legends(const std::vector<Legend>& legends, const Area& picture) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float em = ImGui::GetFontSize();
  const auto x = static_cast<float>(picture.at.x) + em,
             bottom = static_cast<float>(picture.at.y + picture.size.y) - em;
  auto y = static_cast<float>(picture.at.y) + em;
  Area taken{picture.at + Vec2(em), Vec2(0)};
  for (size_t i = 0; i < legends.size(); ++i) {
    const ImVec2 size{width_of(legends[i], 1.4f * em) + 1.2f * em,
                      (1.2f * static_cast<float>(legends[i].rows.size() + 1) + 0.8f) * em};
    if (y + size.y > bottom) break;
    draw_legend(legends[i], {x, y}, size, list);
    mark_area(("legend " + legends[i].title).c_str(), {{x, y}, {size.x, size.y}});
    taken.size.x = std::max<double>(taken.size.x, size.x);
    taken.size.y = y + size.y - taken.at.y;
    y += size.y + 0.5f * em;
  }
  return taken;
}

std::unique_ptr<Feature> view_feature(Workspace& workspace) {
  return std::make_unique<ViewFeature>(workspace);
}

}  // namespace kerf
