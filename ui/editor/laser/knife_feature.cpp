#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <array>
#include <utility>

#include "core/base/assert.h"
#include "core/cut/knife.h"
#include "ui/editor/laser/knife_line.h"
#include "ui/editor/laser/laser_feature.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/window/gui.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr const char* kNoSection = "Show the section plane first.";
constexpr const char* kSectionTip = "Cuts visible pieces along the section plane by a knife of no width.";

// Prepares a cut. Returns false, with a message, while a file is being opened.
bool may_cut(Workspace& workspace) {
  if (workspace.opening.loader.busy()) {
    workspace.message.info("Cannot cut until " + workspace.opening.loader.order().name() + " is open.");
    return false;
  }
  end_exploded_view(workspace.world(), workspace.view);
  workspace.links.cut_once = true;
  return true;
}

void request_cut(Workspace& workspace, const KnifePlane& plane) {
  if (!workspace.opening.loader.busy() && !crosses(workspace.world(), plane))
    return workspace.message.info("The plane crosses no visible piece.");
  if (may_cut(workspace)) workspace.changes.enqueue(CutPlane{plane});
}

// Cuts along a curve; its points are as in CameraView::ray.
void request_cut(Workspace& workspace, const CameraView& camera, std::span<const Vec2> points, bool closed) {
  if (!may_cut(workspace)) return;
  const CutPath command{path_along_view(camera, points, closed, workspace.world().bounds())};
  workspace.changes.enqueue("Cut along the curve", [&workspace, command] {
    const auto cut = [command](Document& document, const Progress* progress) {
      Outcome outcome = document.apply(command, progress);
      if (outcome.ok() && outcome.delta.empty()) outcome.fail(failed("The line crosses no visible piece."));
      return outcome;
    };
    workspace.changes.change(command_label(command, workspace.view.frame.unit),
                             is_quick(workspace.session.document, command), cut);
  });
}

void draw_curve(std::span<const Vec2> points, ImDrawList& list) {
  std::vector<ImVec2> line;
  for (const Vec2& p : points) line.push_back(to_im(p));
  const auto count = static_cast<int>(line.size());
  list.AddPolyline(line.data(), count, IM_COL32(10, 12, 16, 150), 0, 3.0f);
  list.AddPolyline(line.data(), count, colours::accent(), 0, 1.5f);
}

// Draws the edge that closes a curve.
void draw_closing_edge(Vec2 from, Vec2 to, ImDrawList& list) {
  constexpr double kDash = 6, kGap = 4;  // screen coordinates
  const double length = glm::length(to - from);
  for (double at = 0; at < length; at += kDash + kGap) {
    const std::array dash{glm::mix(from, to, at / length),
                          glm::mix(from, to, std::min(at + kDash, length) / length)};
    draw_curve(dash, list);
  }
}

void draw_angle(double degrees, Vec2 at, ImDrawList& list) {
  const double em = ImGui::GetFontSize();
  list.AddText(to_im(at + Vec2(1.5 * em, -1.5 * em)), colours::kPictureText,
               text_of("%.0f\u00b0", degrees).c_str());
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
  void release(const InputEvent&) override {
    if (!(glm::length(to_ - from_) > kClickReach)) return;
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
    draw_curve(std::array{from_, to_}, list);
    if (const auto degrees = line_.degrees()) draw_angle(*degrees, to_, list);
    list.PopClipRect();
  }

 private:
  Workspace& workspace_;
  CameraView camera_;
  Vec2 from_, to_;  // screen coordinates
  StraightLine line_;
};

// The lasso of the Knife tool, until the button is released, which closes it.
class DrawnLasso : public Interaction {
 public:
  explicit DrawnLasso(Workspace& workspace)
      : workspace_(workspace), camera_(workspace.view.seen()), points_{workspace.input.pointer} {}

  void move(const InputEvent&) override {
    const Vec2 at = workspace_.input.pointer;
    if (at != points_.back()) points_.push_back(at);
  }
  void release(const InputEvent&) override {
    if (!is_drag()) return;
    std::vector<Vec2> loop = largest_loop(simplified(points_, kPixel, true));
    if (loop.empty()) return workspace_.message.info("The lasso encloses nothing.");
    for (Vec2& p : loop) p = workspace_.view.in_picture(p);
    request_cut(workspace_, camera_, loop, true);
  }
  bool cancel() override { return true; }
  const char* words() const override {
    return "Knife: release to cut out what the lasso encloses, Esc to cancel";
  }
  void draw(ImDrawList& list) const override {
    if (!is_drag()) return;
    draw_closing_edge(points_.back(), points_.front(), list);
    draw_curve(points_, list);
  }

 private:
  static constexpr double kPixel = 1;  // screen coordinates

  bool is_drag() const {
    return std::ranges::any_of(points_,
                               [&](const Vec2& p) { return glm::length(p - points_.front()) > kClickReach; });
  }

  Workspace& workspace_;
  CameraView camera_;
  std::vector<Vec2> points_;  // places of the pointer, screen coordinates; not empty
};

// The polyline of the Knife tool, drawn click by click.
class DrawnPolyline {
 public:
  explicit DrawnPolyline(Workspace& workspace) : workspace_(workspace) {}

  bool empty() const { return points_.empty(); }
  void clear() { points_.clear(); }
  // Adds the place of the pointer, or ends the polyline: at its first point, or with the second of two clicks
  // at one place.
  void click(const InputEvent& event) {
    if (workspace_.view.in_second) return workspace_.message.error("Draw the line in the left half.");
    if (points_.empty()) camera_ = workspace_.view.seen();
    const Vec2 at = snapped();
    const bool again = !points_.empty() && glm::length(at - points_.back()) <= kClickReach;
    if (again && event.seconds - clicked_at_ <= kDoubleClick) return finish(false);
    if (closes(at)) return finish(true);
    if (!again && would_cross(points_, at))
      return workspace_.message.info("The line would cross itself there.");
    if (!again) points_.push_back(at);
    clicked_at_ = event.seconds;
  }
  void follow(bool shift) { shift_ = shift; }
  void remove_last() { points_.pop_back(); }
  // Cuts along the polyline, wherever the pointer is, and removes it.
  void finish(bool closed) {
    std::vector<Vec2> points = std::exchange(points_, {});
    if (points.size() < 2) return workspace_.message.info("A polyline needs two points.");
    for (Vec2& p : points) p = workspace_.view.in_first(p);
    request_cut(workspace_, camera_, points, closed);
  }
  // Removes the polyline if the view or the tool has changed.
  void drop_if_lost(bool is_active) {
    if (points_.empty() || (is_active && workspace_.view.seen_first() == camera_)) return;
    if (is_active) workspace_.message.info("The view has changed: draw the line again.");
    clear();
  }

  void draw(ImDrawList& list) const {
    if (points_.empty()) return;
    const Vec2 at = snapped();
    std::vector<Vec2> line = points_;
    if (workspace_.input.viewport_hovered) line.push_back(closes(at) ? points_.front() : at);
    draw_curve(line, list);
    for (const Vec2& p : points_) list.AddCircleFilled(to_im(p), 3, colours::accent());
    if (closes(at)) list.AddCircle(to_im(points_.front()), 7, colours::kPictureText, 0, 1.5f);
    if (const auto degrees = angle()) draw_angle(*degrees, at, list);
  }

 private:
  static constexpr double kDoubleClick = 0.4;  // s

  bool closes(Vec2 at) const {
    return points_.size() >= 3 && glm::length(at - points_.front()) <= 2 * kClickReach &&
           !would_cross(std::span(points_).subspan(1), points_.front());
  }
  Vec2 snapped() const {
    StraightLine line;
    if (points_.empty() || !shift_) return workspace_.input.pointer;
    line.follow(points_.back(), false);
    return line.follow(workspace_.input.pointer, true);
  }
  std::optional<double> angle() const {
    StraightLine line;
    if (points_.empty() || !shift_) return std::nullopt;
    line.follow(points_.back(), false);
    line.follow(workspace_.input.pointer, true);
    return line.degrees();
  }

  Workspace& workspace_;
  CameraView camera_;         // of the first point
  std::vector<Vec2> points_;  // screen coordinates, in the first half of a split view
  double clicked_at_ = 0;     // s, at the last point
  bool shift_ = false;        // held at the last event
};

class KnifeFeature : public Feature {
 public:
  explicit KnifeFeature(Workspace& workspace) : workspace_(workspace), polyline_(workspace) {}

  std::vector<PanelPart> panel_parts() override {
    return {{"view.section_cut", [this] { draw_button(); }}};
  }
  std::vector<ToolOption> tool_options() override {
    return {{"knife.shape", 6, [this] {
               choice_row("Shape", "##shape", shape_, "Line\0Lasso\0Polyline\0", "knife shape",
                          "Cut along a straight line, round a lasso, or along clicked points.");
             }}};
  }
  std::vector<UserAction> actions() override {
    return {tool_action(workspace_, kKnifeTool, "Knife", "Q",
                        "Cuts visible pieces along a line that you draw; removes nothing."),
            make_action("section.cut", "Cut at Section Plane", "", kSectionTip, [this] { cut_at_section(); },
                        {.disabled_reason = [this] { return section() ? nullptr : kNoSection; }}),
            shape_action("knife.line", "Knife: Line", "Cuts along a straight line that you drag.",
                         KnifeShape::kLine),
            shape_action("knife.lasso", "Knife: Lasso", "Cuts round a closed line that you drag.",
                         KnifeShape::kLasso),
            shape_action("knife.polyline", "Knife: Polyline",
                         "Cuts along the points that you click; a click on the first one closes it.",
                         KnifeShape::kPolyline)};
  }
  std::vector<Gesture> gestures() const override {
    return {
        {"cut_line", "Left drag with the Knife tool", "Cut along a line; Shift snaps the angle, Esc cancels"},
        {"cut_polyline", "Clicks with the Knife tool",
         "Cut along a polyline; Enter, a double click or the first point ends it"}};
  }

  bool handle_event(const InputEvent& event, bool) override {
    polyline_.follow((event.mods & GLFW_MOD_SHIFT) != 0);
    if (event.kind != InputEvent::Kind::kKey || polyline_.empty()) return false;
    if ((event.mods & GLFW_MOD_CONTROL) != 0 || !are_keys_free()) return false;
    switch (event.button) {
      case GLFW_KEY_ENTER:
      case GLFW_KEY_KP_ENTER:
        if (event.again) return false;  // it may be held from a dialog
        polyline_.finish(false);
        return true;
      case GLFW_KEY_BACKSPACE:
        polyline_.remove_last();
        return true;
      default:
        return false;
    }
  }
  std::unique_ptr<Interaction> begin_interaction(const Press& press) override {
    if (!is_active()) return nullptr;
    end_exploded_view(workspace_.world(), workspace_.view);
    workspace_.view.camera.finish();
    workspace_.message.clear();
    if (shape_ == KnifeShape::kLasso) return std::make_unique<DrawnLasso>(workspace_);
    if (shape_ == KnifeShape::kLine) return std::make_unique<DrawnLine>(workspace_);
    polyline_.click(press.event);
    return std::make_unique<ClickOnce>([] {});
  }
  bool discard_draft() override {
    const bool any = !polyline_.empty();
    polyline_.clear();
    return any;
  }
  const char* status_hint() const override {
    if (!is_active()) return nullptr;
    if (!polyline_.empty()) return "Knife: Enter to cut, Backspace to remove a point, Esc to cancel";
    return shape_ == KnifeShape::kLine    ? "Knife: drag a line to cut along it"
           : shape_ == KnifeShape::kLasso ? "Knife: drag a lasso to cut out what it encloses"
                                          : "Knife: click points to cut along them";
  }
  void update(double) override { polyline_.drop_if_lost(is_active() && shape_ == KnifeShape::kPolyline); }
  void on_document_opened() override { polyline_.clear(); }
  void draw_overlay(ImDrawList& list) override { polyline_.draw(list); }

 private:
  bool is_active() const { return workspace_.input.tool == kKnifeTool; }
  UserAction shape_action(const char* id, const char* name, const char* tip, KnifeShape shape) {
    return setting_action(id, name, tip, shape_, shape, [this] { workspace_.input.tool = kKnifeTool; });
  }
  const SectionPlane* section() const { return shown_section(workspace_.view.look); }
  void cut_at_section() {
    KERF_ASSERT(section() != nullptr);
    const SectionPlane plane = *section();
    request_cut(workspace_, KnifePlane{plane.normal, glm::dot(plane.normal, plane.point)});
  }
  void draw_button() {
    if (section() == nullptr) return;
    if (ImGui::Button("Cut at Section Plane", {-1, 0})) cut_at_section();
    mark_last_item("section cut");
    tooltip(kSectionTip);
  }

  Workspace& workspace_;
  KnifeShape shape_ = KnifeShape::kLine;
  DrawnPolyline polyline_;
};

}  // namespace

std::unique_ptr<Feature> knife_feature(Workspace& workspace) {
  return std::make_unique<KnifeFeature>(workspace);
}

}  // namespace kerf
