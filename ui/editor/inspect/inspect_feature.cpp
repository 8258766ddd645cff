#include "ui/editor/inspect/inspect_feature.h"

#include <imgui.h>

#include <optional>

#include "ui/editor/inspect/face_facts.h"
#include "ui/editor/inspect/heat_probe.h"
#include "ui/editor/shared/files/file_frames.h"
#include "ui/editor/shared/picture/distance_mark.h"
#include "ui/editor/shared/picture/first_picture.h"
#include "ui/editor/shared/surface_point.h"
#include "ui/render/bodies/pick.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/landmarks.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

void draw_edges(const ViewState& view, const Body& body, const Pick& pick, ImDrawList& list) {
  const Triangle t = body.mesh.triangle(pick.face);
  const auto look = view.look.pieces.find({pick.body, body.mesh.data(pick.face).piece});
  const Vec3 offset = look != view.look.pieces.end() ? look->second.offset : Vec3(0);
  const FirstPicture picture(view);
  std::array<ImVec2, 3> corners;
  for (size_t i = 0; i < 3; ++i) {
    const auto at = picture.place_of(body.placement.to_world(t[i]) + offset);
    if (!at) return;
    corners[i] = to_im(*at);
  }
  list.AddPolyline(corners.data(), 3, IM_COL32(10, 12, 16, 190), ImDrawFlags_Closed, 4);
  list.AddPolyline(corners.data(), 3, colours::kPictureText, ImDrawFlags_Closed, 1.5f);
}

// Beside the pointer, on the side where there is room.
void draw_box(const ViewState& view, Vec2 pointer, const std::vector<std::string>& lines, ImDrawList& list) {
  const float em = ImGui::GetFontSize(), line = 1.25f * ImGui::GetTextLineHeight();
  Vec2 size(0, 1.2 * em + line * static_cast<float>(lines.size()));
  for (const std::string& text : lines)
    size.x = std::max<double>(size.x, ImGui::CalcTextSize(text.c_str()).x + 1.6 * em);
  const Area& area = view.layout.first;
  Vec2 at = pointer + Vec2(1.4 * em);
  if (at.x + size.x > area.at.x + area.size.x) at.x = pointer.x - 1.4 * em - size.x;
  if (at.y + size.y > area.at.y + area.size.y) at.y = pointer.y - 1.4 * em - size.y;
  at = glm::max(at, area.at);
  list.AddRectFilled(to_im(at), to_im(at + size), IM_COL32(0x1b, 0x1f, 0x26, 230), 3);
  for (size_t i = 0; i < lines.size(); ++i) {
    const ImVec2 text(static_cast<float>(at.x) + 0.8f * em,
                      static_cast<float>(at.y) + 0.7f * em + line * static_cast<float>(i));
    list.AddText(text, i == 0 ? colours::kPictureText : colours::kPictureSecondary, lines[i].c_str());
  }
  mark_area("face readout", {at, size});
}

// Draws over the picture what there is to know about the face under the pointer, in a box beside it, and the
// face's edges.
void draw_face_readout(const Workspace& on, ImDrawList& list) {
  const ViewState& view = on.view;
  if (!on.points() || view.in_second) return;
  const Vec2 p = view.in_picture(on.pointer);
  const auto seen = pick(on.world(), view.look, view.seen().ray(p.x, p.y));
  if (!seen) return;
  const Body& body = on.world().body(seen->body);
  draw_edges(view, body, *seen, list);
  draw_box(view, on.pointer, lines_of(face_facts(body, seen->face), body, view.frame.unit), list);
}

constexpr const char* kInspectTool = "Inspect and measure";

class InspectFeature : public Feature {
 public:
  explicit InspectFeature(Workspace& on) : on_(on) {}

  std::vector<ActionGroup> actions() override {
    UserAction action = tool_action(on_, kInspectTool, "M",
                                    "Tells what there is to know about the face under the pointer; two "
                                    "clicks measure the distance between two "
                                    "points.");
    action.run = [this, take = action.run] {
      take();
      measured_.clear();
    };
    return {{302, "Tool", {action}}};
  }

  std::unique_ptr<Interaction> claim(const Press& press) override {
    if (!inspects() || press.control) return nullptr;
    return std::make_unique<ClickOnce>([this] { measure(); });
  }
  bool let_go() override {
    if (measured_.empty()) return false;
    measured_.clear();
    return true;
  }
  const char* hint() const override {
    return inspects() ? "Inspect: click two points to measure their distance" : nullptr;
  }

  void advance(double) override {
    if (!inspects()) measured_.clear();
  }
  void follow_queue(double) override {
    if (on_.changes.is_pending()) return;
    const auto clicked = measured_.empty() ? std::nullopt : std::optional(measured_.back());
    probe_.follow(on_.world(), on_.view, clicked, inspects());
  }
  void forget() override { measured_.clear(); }

  void draw_marks(ImDrawList& list) override {
    if (inspects() && measured_.size() == 1) draw_measured_point(on_.view, measured_.front(), list);
    if (inspects() && measured_.size() == 2) {
      const double length = glm::length(measured_[1] - measured_[0]);
      draw_distance(on_.view, measured_[0], measured_[1], length_label(length, on_.view.frame.unit), list);
    }
    if (inspects()) draw_face_readout(on_, list);
    draw_heat_probe(probe_, on_.view.layout.first);
  }

 private:
  bool inspects() const { return on_.tool == kInspectTool; }
  void measure();

  Workspace& on_;
  std::vector<Vec3> measured_;  // m, the points that were clicked: at most two
  HeatProbe probe_;
};

// The third click begins another distance.
void InspectFeature::measure() {
  if (on_.view.in_second) return on_.message.say("Distances are measured in the left half.", true);
  const auto point = point_under_pointer(on_);
  if (!point) return on_.message.say("There is no surface under the pointer.", true);
  if (measured_.size() == 2) measured_.clear();
  measured_.push_back(*point);
  if (measured_.size() < 2)
    return on_.message.say("Click a second point to measure its distance from this one.");
  const Vec3 way = measured_[1] - measured_[0];
  const auto text = [&](double length) { return length_label(length, on_.view.frame.unit); };
  on_.message.say("Distance " + text(glm::length(way)) + "; along X " + text(std::abs(way.x)) + ", along Y " +
                  text(std::abs(way.y)) + ", along Z " + text(std::abs(way.z)));
}

}  // namespace

std::unique_ptr<Feature> inspect_feature(Workspace& on) { return std::make_unique<InspectFeature>(on); }

}  // namespace kerf
