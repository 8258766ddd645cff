#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>

#include "core/base/assert.h"
#include "core/cut/knife.h"
#include "ui/editor/laser/knife_line.h"
#include "ui/editor/laser/laser_feature.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr const char* kNoSection = "Show the section plane first.";
constexpr const char* kSectionTip = "Cuts visible pieces along the section plane by a knife of no width.";

void request_cut(Workspace& workspace, const KnifePlane& plane) {
  if (workspace.opening.loader.busy())
    return workspace.message.info("Cannot cut until " + workspace.opening.loader.order().name() +
                                  " is open.");
  if (!crosses(workspace.world(), plane))
    return workspace.message.info("The plane crosses no visible piece.");
  end_exploded_view(workspace.world(), workspace.view);
  workspace.links.cut_once = true;
  workspace.changes.enqueue(CutPlane{plane});
}

// The line of the Knife tool, until the button is released.
class DrawnLine : public Interaction {
 public:
  explicit DrawnLine(Workspace& workspace)
      : workspace_(workspace), camera_(workspace.view.seen()), from_(workspace.input.pointer), to_(from_) {}

  // The angle is that of the whole line, not only of its part since Shift was pressed.
  void move(const InputEvent& event) override {
    line_ = StraightLine();
    line_.follow(from_, false);
    to_ = line_.follow(workspace_.input.pointer, (event.mods & GLFW_MOD_SHIFT) != 0);
  }
  void release(const InputEvent& event) override {
    if (event.button != GLFW_MOUSE_BUTTON_LEFT || !(glm::length(to_ - from_) > kClickReach)) return;
    const ViewState& view = workspace_.view;
    request_cut(workspace_, plane_through(camera_, view.in_picture(from_), view.in_picture(to_)));
  }
  bool cancel() override { return true; }
  const char* words() const override {
    return "Knife: release to cut, Esc to cancel, Shift to snap the angle";
  }

  void draw(ImDrawList& list) const override {
    const double length = glm::length(to_ - from_);
    if (!(length > kClickReach)) return;
    const Area& pane = workspace_.view.pane();
    const Vec2 beyond = (glm::length(pane.size) / length) * (to_ - from_);
    list.PushClipRect(to_im(pane.at), to_im(pane.at + pane.size), true);
    list.AddLine(to_im(from_ - beyond), to_im(to_ + beyond), colours::kPictureSecondary, 1.0f);
    list.AddLine(to_im(from_), to_im(to_), IM_COL32(10, 12, 16, 150), 3.0f);
    list.AddLine(to_im(from_), to_im(to_), colours::accent(), 1.5f);
    if (const auto degrees = line_.degrees()) {
      const double em = ImGui::GetFontSize();
      list.AddText(to_im(to_ + Vec2(1.5 * em, -1.5 * em)), colours::kPictureText,
                   text_of("%.0f\u00b0", *degrees).c_str());
    }
    list.PopClipRect();
  }

 private:
  Workspace& workspace_;
  CameraView camera_;
  Vec2 from_, to_;  // screen coordinates
  StraightLine line_;
};

class KnifeFeature : public Feature {
 public:
  explicit KnifeFeature(Workspace& workspace) : workspace_(workspace) {}

  std::vector<PanelPart> panel_parts() override {
    return {{"view.section_cut", [this] { draw_button(); }}};
  }
  std::vector<UserAction> actions() override {
    return {tool_action(workspace_, kKnifeTool, "Knife", "Q",
                        "Cuts visible pieces in two along a line that you drag; removes nothing."),
            make_action("section.cut", "Cut at Section Plane", "", kSectionTip, [this] { cut_at_section(); },
                        {.disabled_reason = [this] { return section() ? nullptr : kNoSection; }})};
  }
  std::vector<Gesture> gestures() const override {
    return {{"cut_line", "Left drag of a line",
             "Cut along it, with the tool Knife; Shift snaps the angle, Esc cancels"}};
  }

  std::unique_ptr<Interaction> begin_interaction(const Press&) override {
    if (!is_active()) return nullptr;
    workspace_.view.camera.finish();
    workspace_.message.clear();
    return std::make_unique<DrawnLine>(workspace_);
  }
  const char* status_hint() const override {
    return is_active() ? "Knife: drag a line to cut along it" : nullptr;
  }

 private:
  bool is_active() const { return workspace_.input.tool == kKnifeTool; }
  const SectionPlane* section() const { return shown_section(workspace_.view.look); }
  void cut_at_section() {
    KERF_ASSERT(section() != nullptr);
    const SectionPlane plane = *section();
    request_cut(workspace_, {plane.normal, glm::dot(plane.normal, plane.point)});
  }
  void draw_button() {
    if (section() == nullptr) return;
    if (ImGui::Button("Cut at Section Plane", {-1, 0})) cut_at_section();
    mark_last_item("section cut");
    tooltip(kSectionTip);
  }

  Workspace& workspace_;
};

}  // namespace

KnifePlane plane_through(const CameraView& view, Vec2 from, Vec2 to) {
  const Pose a = view.ray(from.x, from.y), b = view.ray(to.x, to.y);
  const Vec3 normal = glm::cross(a.direction, b.origin + b.direction - (a.origin + a.direction));
  const double length = glm::length(normal);
  KERF_ASSERT(length > 0);
  return {normal / length, glm::dot(normal, a.origin) / length};
}

bool crosses(const World& world, const KnifePlane& plane) {
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.hidden) continue;
    bool above = false, below = false;
    for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
      if (!body.mesh.is_live(FaceId(slot))) continue;
      for (const Vec3& p : body.mesh.triangle(FaceId(slot))) {
        const double height = glm::dot(plane.normal, body.placement.to_world(p)) - plane.distance;
        above = above || height > 0;
        below = below || height < 0;
      }
      if (above && below) return true;
    }
  }
  return false;
}

std::unique_ptr<Feature> knife_feature(Workspace& workspace) {
  return std::make_unique<KnifeFeature>(workspace);
}

}  // namespace kerf
