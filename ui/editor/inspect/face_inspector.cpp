#include "ui/editor/inspect/face_inspector.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/ids.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

double degrees_between(const Vec3& a, const Vec3& b) {
  const double sine = glm::length(glm::cross(a, b)), cosine = glm::dot(a, b);
  return sine == 0 && cosine == 0 ? 0 : std::atan2(sine, cosine) * 180 / kPi;
}

template <typename Text>
std::string joined(const std::array<double, 3>& values, const char* between, const Text& text) {
  return text(values[0]) + between + text(values[1]) + between + text(values[2]);
}

// "12", "boundary", "12 + 40 + 41 (ring of 4)".
std::string across(const std::vector<FaceId>& faces) {
  if (faces.empty()) return "boundary";
  std::string text;
  for (const FaceId f : faces) text += (text.empty() ? "" : " + ") + std::to_string(f.index);
  if (faces.size() > 1) text += " (ring of " + std::to_string(faces.size() + 1) + ")";
  return text;
}

std::string temperature_text(const FaceFacts& facts) {
  const std::string now = text_of("Temperature   %.0f K", facts.temperature);
  return facts.hottest > facts.temperature + 1 ? now + text_of(", maximum %.0f K", facts.hottest) : now;
}

constexpr double kBefore = 1e-3, kWithin = 1e-4;  // diagonals of the world
constexpr double kMinSpan = 100;                  // K

std::optional<double> temperature_at(const World& world, const ViewState& view, const Pose& ray) {
  const auto seen = pick(world, view.look, ray);
  const double diagonal = world.loaded_bounds().diagonal();
  if (!seen || seen->length > (kBefore + kWithin) * diagonal) return std::nullopt;
  const Body& body = world.body(seen->body);
  return body.heat.temperature(body.mesh, seen->face, body.sheet.substance, body.sheet.thickness);
}

struct Plot {
  ImVec2 at, size;
  double from = 0, to = 1, least = kAmbient, most = kAmbient;

  ImVec2 place(const HeatProbe::Sample& s) const {
    return {at.x + static_cast<float>((s.seconds - from) / (to - from)) * size.x,
            at.y + size.y - static_cast<float>((s.temperature - least) / (most - least)) * size.y};
  }
};

Plot plot_of(const std::vector<HeatProbe::Sample>& samples, ImVec2 at, ImVec2 size) {
  KERF_ASSERT(samples.front().seconds < samples.back().seconds);
  Plot plot{at, size, samples.front().seconds, samples.back().seconds};
  for (const HeatProbe::Sample& s : samples) plot.most = std::max(plot.most, s.temperature);
  plot.most = std::max(plot.most, kAmbient + kMinSpan);
  return plot;
}

void draw_edges(const ViewState& view, const Body& body, const Pick& pick, ImDrawList& list) {
  const Triangle t = body.mesh.triangle(pick.face);
  const BodyLooks looks(pick.body, body, view.look);
  const PieceLook& look = looks.of(body.mesh, pick.face);
  const PrimaryViewport picture(view);
  std::array<ImVec2, 3> corners;
  for (size_t i = 0; i < 3; ++i) {
    const auto at = picture.place_of(look.turn * body.placement.to_world(t[i]) + look.offset);
    if (!at) return;
    corners[i] = to_im(*at);
  }
  list.AddPolyline(corners.data(), 3, IM_COL32(10, 12, 16, 190), ImDrawFlags_Closed, 4);
  list.AddPolyline(corners.data(), 3, colours::kPictureText, ImDrawFlags_Closed, 1.5f);
}

bool meet(const Area& a, const Area& b) {
  return a.at.x < b.at.x + b.size.x && b.at.x < a.at.x + a.size.x && a.at.y < b.at.y + b.size.y &&
         b.at.y < a.at.y + a.size.y;
}

// Returns the first place around the pointer within the area where a box leaves `avoided` free, or else the
// first one, moved into the area.
Vec2 place_of_box(const Area& area, Vec2 pointer, Vec2 size, const Area& avoided) {
  const Vec2 gap(1.4 * ImGui::GetFontSize()), low = pointer - gap - size, high = pointer + gap;
  for (const Vec2& at : {high, Vec2(low.x, high.y), Vec2(high.x, low.y), low}) {
    const bool is_within =
        glm::max(at, area.at) == at && glm::min(at + size, area.at + area.size) == at + size;
    if (is_within && !meet({at, size}, avoided)) return at;
  }
  return glm::max(glm::min(high, area.at + area.size - size), area.at);
}

// Draws the box next to the pointer, on the side where there is room.
void draw_box(const ViewState& view, Vec2 pointer, const std::vector<std::string>& lines, const Area& avoided,
              ImDrawList& list) {
  const float em = ImGui::GetFontSize(), line = 1.25f * ImGui::GetTextLineHeight();
  Vec2 size(0, 1.2 * em + line * static_cast<float>(lines.size()));
  for (const std::string& text : lines)
    size.x = std::max<double>(size.x, ImGui::CalcTextSize(text.c_str()).x + 1.6 * em);
  const Vec2 at = place_of_box(view.layout.first, pointer, size, avoided);
  list.AddRectFilled(to_im(at), to_im(at + size), IM_COL32(0x1b, 0x1f, 0x26, 230), 3);
  for (size_t i = 0; i < lines.size(); ++i) {
    const ImVec2 text(static_cast<float>(at.x) + 0.8f * em,
                      static_cast<float>(at.y) + 0.7f * em + line * static_cast<float>(i));
    list.AddText(text, i == 0 ? colours::kPictureText : colours::kPictureSecondary, lines[i].c_str());
  }
  mark_area("face readout", {at, size});
}

// Draws the edges of the face under the pointer, and its facts in a box next to the pointer that leaves
// `avoided` free.
void draw_face_readout(const Workspace& workspace, const Area& avoided, ImDrawList& list) {
  const ViewState& view = workspace.view;
  if (!workspace.input.points() || view.in_second) return;
  const Vec2 p = view.in_picture(workspace.input.pointer);
  const auto seen = pick(workspace.world(), view.look, view.seen().ray(p.x, p.y));
  if (!seen) return;
  const Body& body = workspace.world().body(seen->body);
  const FaceFacts facts = face_facts(body, seen->face);
  const std::string piece = name_of_piece(workspace.world(), view.look.pieces, {seen->body, facts.piece});
  draw_edges(view, body, *seen, list);
  draw_box(view, workspace.input.pointer, lines_of(facts, piece, view.frame.unit), avoided, list);
}

// The values that clicks measure; kAll states the distance of two points and the rest with a third.
enum class MeasuredKind { kAll, kDistance, kAngle, kRadius };
constexpr const char* kKinds[] = {"All", "Distance", "Angle", "Radius"};

class InspectFeature : public Feature {
 public:
  explicit InspectFeature(Workspace& workspace) : workspace_(workspace) {}

  std::vector<ToolOption> tool_options() override {
    return {{"measure.kind", 7, [this] {
               if (marked_choice_row("Measure", "##kind", kind_, kKinds, "measured kind",
                                     "Distance takes two clicks, angle and radius take three."))
                 measured_.clear();
             }}};
  }

  std::vector<UserAction> actions() override {
    UserAction action =
        tool_action(workspace_, kInspectTool, "Inspect and Measure", "M",
                    "Shows data of the face under the pointer; clicks measure distance, angle and radius.");
    action.run = [this, take = action.run] {
      take();
      measured_.clear();
    };
    return {action};
  }

  std::unique_ptr<Interaction> begin_interaction(const Press& press) override {
    if (!inspects() || press.control) return nullptr;
    if (!workspace_.view.in_second && end_exploded_view(workspace_.world(), workspace_.view)) {
      workspace_.message.info(kExplodedViewEnded);
      return std::make_unique<ClickOnce>([] {});
    }
    return std::make_unique<ClickOnce>([this] { measure(); });
  }
  bool clear_selection() override {
    if (measured_.empty()) return false;
    measured_.clear();
    return true;
  }
  const char* status_hint() const override {
    return inspects() ? "Measure: click two points, or three for an angle" : nullptr;
  }

  void update(double) override {
    if (!inspects()) measured_.clear();
  }
  void after_queue(double) override {
    if (workspace_.changes.is_pending()) return;
    const auto clicked = measured_.empty() ? std::nullopt : std::optional(measured_.back());
    probe_.follow(workspace_.world(), workspace_.view, clicked, inspects());
  }
  void on_document_opened() override {
    measured_.clear();
    probe_ = HeatProbe();
  }

  void draw_overlay(ImDrawList& list) override {
    if (inspects() && measured_.size() == 1) draw_measured_point(workspace_.view, measured_.front(), list);
    for (size_t i = 1; inspects() && i < measured_.size(); ++i) {
      const double length = glm::length(measured_[i] - measured_[i - 1]);
      draw_distance(workspace_.view, measured_[i - 1], measured_[i],
                    length_label(length, workspace_.view.frame.unit), list);
    }
    if (inspects()) draw_face_readout(workspace_, corner_label(), list);
    if (inspects() && measured_.size() == 3) draw_corner(list);
    draw_heat_probe(probe_, workspace_.view.layout.first);
  }

 private:
  // The box of the angle and the radius, next to the middle point; empty without three points.
  Area corner_label() const {
    if (measured_.size() < 3) return {};
    const auto place = PrimaryViewport(workspace_.view).place_of(measured_[1]);
    if (!place) return {};
    const double em = ImGui::GetFontSize();
    return {*place + Vec2(0.5, 0.25) * em, {ImGui::CalcTextSize(corner_text().c_str()).x + em, 1.55 * em}};
  }
  void draw_corner(ImDrawList& list) const {
    const Area box = corner_label();
    if (box.size.x == 0) return;
    list.AddRectFilled(to_im(box.at), to_im(box.at + box.size), IM_COL32(0x1b, 0x1f, 0x26, 230), 3);
    list.AddText(to_im(box.at + Vec2(0.5, 0.25) * double(ImGui::GetFontSize())), colours::kPictureText,
                 corner_text().c_str());
    mark_area("measured corner", box);
  }
  bool inspects() const { return workspace_.input.tool == kInspectTool; }
  size_t clicks() const { return kind_ == MeasuredKind::kDistance ? 2 : 3; }
  // A click after the last one begins another measurement.
  void measure() {
    if (workspace_.view.in_second) return workspace_.message.error("Measure distances in the left half.");
    const auto point = point_under_pointer(workspace_);
    if (!point) return workspace_.message.error("No surface under the pointer.");
    if (measured_.size() == clicks()) measured_.clear();
    measured_.push_back(*point);
    if (measured_.size() < 2) return workspace_.message.info("Click a second point to measure.");
    const auto text = [&](double length) { return length_label(length, workspace_.view.frame.unit); };
    if (measured_.size() == 3) return workspace_.message.info(corner_text());
    if (kind_ == MeasuredKind::kAngle || kind_ == MeasuredKind::kRadius)
      return workspace_.message.info("Click a third point to measure.");
    const Vec3 way = measured_[1] - measured_[0];
    workspace_.message.info("Distance " + text(glm::length(way)) + "; along X " + text(std::abs(way.x)) +
                            ", along Y " + text(std::abs(way.y)) + ", along Z " + text(std::abs(way.z)) +
                            (clicks() > 2 ? "; click a third point for the angle and the radius" : ""));
  }
  std::string corner_text() const {
    const Corner corner = measure_corner(measured_[0], measured_[1], measured_[2]);
    const std::string angle = text_of("Angle %.1f\u00b0", corner.degrees);
    if (kind_ == MeasuredKind::kAngle) return angle;
    const std::string radius =
        corner.radius ? length_label(*corner.radius, workspace_.view.frame.unit) : "infinite";
    return kind_ == MeasuredKind::kRadius ? "Radius " + radius : angle + ", radius " + radius;
  }

  Workspace& workspace_;
  MeasuredKind kind_ = MeasuredKind::kAll;
  std::vector<Vec3> measured_;  // m, the points that were clicked: at most three
  HeatProbe probe_;
};

}  // namespace

Corner measure_corner(const Vec3& from, const Vec3& at, const Vec3& to) {
  Corner corner{degrees_between(from - at, to - at), std::nullopt};
  const double area = glm::length(glm::cross(from - at, to - at));
  if (area > 0)
    corner.radius = glm::length(from - at) * glm::length(to - at) * glm::length(to - from) / (2 * area);
  return corner;
}

FaceFacts face_facts(const Body& body, FaceId face) {
  KERF_ASSERT(body.mesh.is_live(face));
  const FaceData& data = body.mesh.data(face);
  const Triangle t = body.mesh.triangle(face);
  const std::array<VertexId, 3> corners = body.mesh.corners(face);
  FaceFacts facts{face,
                  body.loaded_face(body.loaded_base(face)),
                  data.halvings,
                  body.label(face),
                  triangle_area(t),
                  {},
                  {},
                  {},
                  {}};
  facts.temperature = body.heat.temperature(body.mesh, face, body.sheet.substance, body.sheet.thickness);
  facts.hottest = body.heat.hottest_of(body.mesh, face);
  facts.slot = tree_slot(body.tree, body.mesh, face).value_or(TreeSlot());
  for (size_t i = 0; i < 3; ++i) {
    const size_t next = (i + 1) % 3, last = (i + 2) % 3;
    facts.edges[i] = glm::length(t[next] - t[i]);
    facts.angles[i] = degrees_between(t[next] - t[i], t[last] - t[i]);
    std::vector<Mesh::Side> sides;
    body.mesh.append_edge_sides(face, corners[i], corners[next], sides);
    for (const Mesh::Side& side : sides) facts.neighbours[i].push_back(side.face);
  }
  return facts;
}

std::vector<std::string> lines_of(const FaceFacts& facts, const std::string& piece, FileUnit unit) {
  const auto length = [&](double metres) { return length_label(metres, unit); };
  const auto angle = [](double degrees) { return text_of("%.1f\u00b0", degrees); };
  const std::string level = facts.halvings == 0 ? "as loaded"
                                                : count_text(static_cast<size_t>(facts.halvings), "halving") +
                                                      " of loaded face " + std::to_string(facts.loaded.index);
  return {"Face " + std::to_string(facts.face.index) + ", " + level,
          "Piece   " + piece,
          "Area   " + area_label(facts.area, unit),
          "Edges   " + joined(facts.edges, ", ", length),
          "Angles   " + joined(facts.angles, ", ", angle),
          "Neighbours   " + across(facts.neighbours[0]) + ", " + across(facts.neighbours[1]) + ", " +
              across(facts.neighbours[2]),
          temperature_text(facts),
          "Tree   block " + std::to_string(facts.slot.block) + ", place " +
              std::to_string(facts.slot.place + 1) + " of up to 4" +
              (facts.slot.hit ? "; hit by the beam" : "")};
}

void HeatProbe::follow(const World& world, const ViewState& view, const std::optional<Vec3>& clicked,
                       bool inspects) {
  const bool keeps = !clicked && !inspects && view.look.show.heat;
  if (clicked != at_ && !keeps) {
    at_ = clicked;
    samples_.clear();
    if (!at_) return;
    const Vec3 eye = view.seen_first().eye, way = glm::normalize(*at_ - eye);
    ray_ = {*at_ - kBefore * world.loaded_bounds().diagonal() * way, way};
  }
  if (!at_ || (!inspects && !view.look.show.heat)) return;
  const double seconds = static_cast<double>(world.clock()) / kTicksPerSecond;
  if (!samples_.empty() && seconds < samples_.back().seconds) samples_.clear();
  if (!samples_.empty() && seconds == samples_.back().seconds) return;
  if (const auto now = temperature_at(world, view, ray_)) add({seconds, *now});
}

// Drops every second sample if there are too many.
void HeatProbe::add(const Sample& sample) {
  if (samples_.size() >= kMaxSamples) {
    size_t kept = 0;
    for (size_t i = 0; i < samples_.size(); i += 2) samples_[kept++] = samples_[i];
    samples_.resize(kept);
  }
  samples_.push_back(sample);
}

void draw_heat_probe(const HeatProbe& probe, const Area& picture) {
  const std::vector<HeatProbe::Sample>& samples = probe.samples();
  if (samples.size() < 2) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float em = ImGui::GetFontSize(), line = 1.2f * em;
  const ImVec2 size(17 * em, 9 * em);
  const Vec2 end = picture.at + picture.size;
  const ImVec2 at(static_cast<float>(end.x) - size.x - em, static_cast<float>(end.y) - size.y - em);
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, IM_COL32(0x1b, 0x1f, 0x26, 230), 3);
  list.AddText({at.x + 0.6f * em, at.y + 0.4f * em}, colours::kPictureText,
               text_of("%.0f K at the point", samples.back().temperature).c_str());
  const Plot plot = plot_of(samples, {at.x + 0.6f * em, at.y + 0.8f * em + line},
                            {size.x - 1.2f * em, size.y - 1.6f * em - 2 * line});
  list.AddRectFilled(plot.at, {plot.at.x + plot.size.x, plot.at.y + plot.size.y}, IM_COL32(10, 12, 16, 160));
  std::vector<ImVec2> curve;
  for (const HeatProbe::Sample& s : samples) curve.push_back(plot.place(s));
  list.AddPolyline(curve.data(), static_cast<int>(curve.size()), colours::accent(), 0, 1.6f);
  list.AddText({plot.at.x + 0.3f * em, plot.at.y + 0.1f * em}, colours::kPictureSecondary,
               text_of("%.0f K", plot.most).c_str());
  const float below = plot.at.y + plot.size.y + 0.2f * em;
  list.AddText({plot.at.x, below}, colours::kPictureSecondary,
               text_of("over %.3g s", plot.to - plot.from).c_str());
  mark_area("heat probe", {{at.x, at.y}, {size.x, size.y}});
}

std::unique_ptr<Feature> inspect_feature(Workspace& workspace) {
  return std::make_unique<InspectFeature>(workspace);
}

}  // namespace kerf
