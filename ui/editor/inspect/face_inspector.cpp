#include "ui/editor/inspect/face_inspector.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/ids.h"
#include "core/base/json.h"
#include "core/base/platform.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/document_session.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/gizmo.h"
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
  const auto look = view.look.pieces.find({pick.body, body.mesh.data(pick.face).piece});
  const Vec3 offset = look != view.look.pieces.end() ? look->second.offset : Vec3(0);
  const PrimaryViewport picture(view);
  std::array<ImVec2, 3> corners;
  for (size_t i = 0; i < 3; ++i) {
    const auto at = picture.place_of(body.placement.to_world(t[i]) + offset);
    if (!at) return;
    corners[i] = to_im(*at);
  }
  list.AddPolyline(corners.data(), 3, IM_COL32(10, 12, 16, 190), ImDrawFlags_Closed, 4);
  list.AddPolyline(corners.data(), 3, colours::kPictureText, ImDrawFlags_Closed, 1.5f);
}

// Draws the box next to the pointer, on the side where there is room.
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

// Draws the edges of the face under the pointer, and its facts in a box next to the pointer.
void draw_face_readout(const Workspace& workspace, ImDrawList& list) {
  const ViewState& view = workspace.view;
  if (!workspace.input.points() || view.in_second) return;
  const Vec2 p = view.in_picture(workspace.input.pointer);
  const auto seen = pick(workspace.world(), view.look, view.seen().ray(p.x, p.y));
  if (!seen) return;
  const Body& body = workspace.world().body(seen->body);
  draw_edges(view, body, *seen, list);
  draw_box(view, workspace.input.pointer, lines_of(face_facts(body, seen->face), body, view.frame.unit),
           list);
}

class InspectFeature : public Feature {
 public:
  explicit InspectFeature(Workspace& workspace) : workspace_(workspace) {}

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
  void on_document_opened() override { measured_.clear(); }

  void draw_overlay(ImDrawList& list) override {
    if (inspects() && measured_.size() == 1) draw_measured_point(workspace_.view, measured_.front(), list);
    for (size_t i = 1; inspects() && i < measured_.size(); ++i) {
      const double length = glm::length(measured_[i] - measured_[i - 1]);
      draw_distance(workspace_.view, measured_[i - 1], measured_[i],
                    length_label(length, workspace_.view.frame.unit), list);
    }
    if (inspects() && measured_.size() == 3) draw_corner(list);
    if (inspects()) draw_face_readout(workspace_, list);
    draw_heat_probe(probe_, workspace_.view.layout.first);
  }

 private:
  // Draws the angle and the radius next to the middle point.
  void draw_corner(ImDrawList& list) const {
    const auto place = PrimaryViewport(workspace_.view).place_of(measured_[1]);
    if (!place) return;
    const float em = ImGui::GetFontSize();
    const std::string text = corner_text();
    const ImVec2 at = to_im(*place + Vec2(em, 0.5 * em)), size = ImGui::CalcTextSize(text.c_str());
    list.AddRectFilled({at.x - 0.5f * em, at.y - 0.25f * em}, {at.x + size.x + 0.5f * em, at.y + 1.3f * em},
                       IM_COL32(0x1b, 0x1f, 0x26, 230), 3);
    list.AddText(at, colours::kPictureText, text.c_str());
  }
  bool inspects() const { return workspace_.input.tool == kInspectTool; }
  // The fourth click begins another measurement.
  void measure() {
    if (workspace_.view.in_second) return workspace_.message.error("Measure distances in the left half.");
    const auto point = point_under_pointer(workspace_);
    if (!point) return workspace_.message.error("No surface under the pointer.");
    if (measured_.size() == 3) measured_.clear();
    measured_.push_back(*point);
    if (measured_.size() < 2) return workspace_.message.info("Click a second point to measure the distance.");
    const auto text = [&](double length) { return length_label(length, workspace_.view.frame.unit); };
    if (measured_.size() == 3) return workspace_.message.info(corner_text());
    const Vec3 way = measured_[1] - measured_[0];
    workspace_.message.info("Distance " + text(glm::length(way)) + "; along X " + text(std::abs(way.x)) +
                            ", along Y " + text(std::abs(way.y)) + ", along Z " + text(std::abs(way.z)) +
                            "; click a third point for the angle and the radius");
  }
  std::string corner_text() const {
    const Corner corner = measure_corner(measured_[0], measured_[1], measured_[2]);
    std::string text = text_of("Angle %.1f\u00b0", corner.degrees);
    if (corner.radius) text += ", radius " + length_label(*corner.radius, workspace_.view.frame.unit);
    return text;
  }

  Workspace& workspace_;
  std::vector<Vec3> measured_;  // m, the points that were clicked: at most three
  HeatProbe probe_;
};

constexpr const char* kName = "name";
constexpr const char* kFrom = "from";
constexpr const char* kTo = "to";

constexpr const char* kNothingToUndo = "No measurement edit to undo.";
constexpr const char* kNothingToRedo = "No measurement edit to redo.";
constexpr const char* kNoMeasurements = "There are no measurements.";

std::optional<Vec3> point_of(const nlohmann::json& json) {
  if (!json.is_array() || json.size() != 3) return std::nullopt;
  Vec3 point(0);
  for (int i = 0; i < 3; ++i) {
    const nlohmann::json& number = json[static_cast<size_t>(i)];
    if (!number.is_number() || !std::isfinite(number.get<double>())) return std::nullopt;
    point[i] = number.get<double>();
  }
  return point;
}

std::optional<RulerMark> mark_of(const nlohmann::json& json) {
  if (!json.is_object()) return std::nullopt;
  const nlohmann::json name = json.value(kName, nlohmann::json());
  const auto from = point_of(json.value(kFrom, nlohmann::json()));
  const auto to = point_of(json.value(kTo, nlohmann::json()));
  if (!name.is_string() || !from || !to) return std::nullopt;
  return RulerMark{name.get<std::string>(), *from, *to};
}

// Returns the text in quotes, with inner quotes doubled.
std::string quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string csv_number(double number) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), ",%.9g", number);
  return text.data();
}

constexpr const char* kRulerPanel = "ruler";
constexpr const char* kRulerKey = "rulers";  // in the head of a document
constexpr double kReachOfEnd = 8;            // screen coordinates

struct EndOfMark {
  size_t mark = 0;
  bool to = false;
};

class RulerFeature : public Feature {
 public:
  explicit RulerFeature(Workspace& workspace) : workspace_(workspace) {}

  std::vector<PanelPart> panel_parts() override {
    return {{kRulerPanel, [this] { draw_panel(); }}};
  }
  std::vector<UserAction> actions() override {
    const UserAction take = tool_action(workspace_, kRulerTool, "Ruler", "",
                                        "Click two points to add a measurement, which can be named, moved, "
                                        "saved and exported.",
                                        true);
    const auto action = [](const char* id, const char* name, const char* tip, std::function<void()> run,
                           std::function<const char*()> disabled_reason) {
      return make_action(id, name, "", tip, std::move(run), {.disabled_reason = std::move(disabled_reason)});
    };
    return {take,
            action(
                "ruler.undo", "Undo Measurement Edit", "Reverts the last edit of a measurement.",
                [this] { step(true); }, [this] { return list_.can_undo() ? nullptr : kNothingToUndo; }),
            action(
                "ruler.redo", "Redo Measurement Edit", "Repeats the undone edit of a measurement.",
                [this] { step(false); }, [this] { return list_.can_redo() ? nullptr : kNothingToRedo; }),
            action(
                "ruler.export", "Export Measurements...",
                "Writes the end points and lengths of all measurements to a table (.csv).",
                [this] { select_file_to_export(); },
                [this] { return list_.marks().empty() ? kNoMeasurements : nullptr; })};
  }

  std::unique_ptr<Interaction> begin_interaction(const Press& press) override {
    if (!is_active() || press.control || workspace_.view.in_second) return nullptr;
    if (const auto end = end_under_pointer(); end && !first_) return std::make_unique<DragOfEnd>(*this, *end);
    return std::make_unique<ClickOnce>([this] { measure(); });
  }
  bool clear_selection() override { return std::exchange(first_, std::nullopt).has_value(); }
  const char* status_hint() const override {
    return is_active() ? "Ruler: click two points to add a measurement; drag its ends" : nullptr;
  }

  void on_document_opened() override {
    first_.reset();
    renamed_.reset();
    list_.read(head_entry(workspace_.session.scene, kRulerKey));
  }

  bool awaits_focus() const override { return renamed_ && take_focus_; }
  void draw_overlay(ImDrawList& list) override {
    if (!shown()) return;
    for (const RulerMark& m : list_.marks()) {
      draw_distance(workspace_.view, m.from, m.to,
                    m.name + ": " + length_label(m.length(), workspace_.view.frame.unit), list);
    }
    if (first_ && is_active()) draw_measured_point(workspace_.view, *first_, list);
  }
  void draw_windows() override {
    if (!std::exchange(field_drawn_, false)) renamed_.reset();
  }
  void add_landmarks(Landmarks& landmarks) const override {
    const PrimaryViewport picture(workspace_.view);
    for (size_t i = 0; i < list_.marks().size() && shown(); ++i) {
      const RulerMark& m = list_.marks()[i];
      if (const auto at = picture.place_of(m.from))
        landmarks.mark("ruler from " + std::to_string(i), {*at, Vec2(0)});
      if (const auto at = picture.place_of(m.to))
        landmarks.mark("ruler to " + std::to_string(i), {*at, Vec2(0)});
    }
  }
  void write_session_log(nlohmann::ordered_json& report) const override {
    report[kRulerKey] = list_.to_json();
  }

 private:
  // Moves an end over the surfaces.
  class DragOfEnd : public Interaction {
   public:
    DragOfEnd(RulerFeature& feature, EndOfMark end) : feature_(feature), end_(end) {}
    void move(const InputEvent&) override {
      const auto surface = point_under_pointer(feature_.workspace_);
      if (!surface || end_.mark >= feature_.list_.marks().size()) return;
      if (!std::exchange(edits_, true)) feature_.list_.begin_edit();
      feature_.list_.move(end_.mark, end_.to, *surface);
      feature_.keep();
    }
    const char* words() const override { return "Ruler: drag the end over the surface"; }

   private:
    RulerFeature& feature_;
    EndOfMark end_;
    bool edits_ = false;
  };

  bool is_active() const { return workspace_.input.tool == kRulerTool; }
  bool shown() const { return is_active() || workspace_.services.panels.shows(kRulerPanel); }
  void keep() { set_head_entry(workspace_.session.scene, kRulerKey, list_.to_json()); }
  std::optional<EndOfMark> end_under_pointer() const {
    const PrimaryViewport picture(workspace_.view);
    for (size_t i = 0; i < list_.marks().size(); ++i) {
      for (const bool to : {false, true}) {
        const auto place = picture.place_of(to ? list_.marks()[i].to : list_.marks()[i].from);
        if (place && glm::length(*place - workspace_.input.pointer) < kReachOfEnd) return EndOfMark{i, to};
      }
    }
    return std::nullopt;
  }
  // Measures from the last click, or begins a distance.
  void measure() {
    const auto surface = point_under_pointer(workspace_);
    if (!surface) return workspace_.message.error("No surface under the pointer.");
    if (!first_) {
      first_ = *surface;
      return workspace_.message.info("Click a second point to add the measurement.");
    }
    list_.begin_edit();
    list_.add(*std::exchange(first_, std::nullopt), *surface);
    keep();
    const RulerMark& mark = list_.marks().back();
    workspace_.message.info(mark.name + ": " + length_label(mark.length(), workspace_.view.frame.unit));
  }
  void step(bool back) {
    if (back) {
      list_.undo();
    } else {
      list_.redo();
    }
    renamed_.reset();
    keep();
  }

  void draw_panel() {
    if (list_.marks().empty()) ImGui::TextWrapped("Click two points on surfaces with the Ruler tool.");
    if (!list_.marks().empty() && ImGui::BeginTable("distances", 3, ImGuiTableFlags_RowBg)) {
      const float em = ImGui::GetFontSize();
      ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch);
      ImGui::TableSetupColumn("Length", ImGuiTableColumnFlags_WidthFixed, 5 * em);
      ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 4 * em);
      for (size_t i = 0; i < list_.marks().size(); ++i) draw_row(i);
      ImGui::EndTable();
    }
    if (row_button("Undo", 3, list_.can_undo() ? nullptr : kNothingToUndo,
                   "Reverts the last edit of a measurement."))
      step(true);
    ImGui::SameLine();
    if (row_button("Redo", 3, list_.can_redo() ? nullptr : kNothingToRedo,
                   "Repeats the undone edit of a measurement."))
      step(false);
    ImGui::SameLine();
    if (row_button("Export", 3, list_.marks().empty() ? kNoMeasurements : nullptr,
                   "Writes the measurements to a table (.csv)."))
      select_file_to_export();
  }
  void draw_row(size_t mark) {
    ImGui::PushID(static_cast<int>(mark));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string name = list_.marks()[mark].name;
    if (renamed_ == mark) {
      edit_name(mark);
    } else if (ImGui::Selectable(fitted_label(name + "###name", ImGui::GetContentRegionAvail().x).c_str())) {
      renamed_ = mark;
      take_focus_ = field_drawn_ = true;
      new_name_.fill('\0');
      std::memcpy(new_name_.data(), name.data(), std::min(name.size(), new_name_.size() - 1));
    }
    mark_last_item("ruler name", static_cast<int>(mark));
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(length_label(list_.marks()[mark].length(), workspace_.view.frame.unit).c_str());
    ImGui::TableNextColumn();
    const bool removed = ImGui::SmallButton("Remove");
    mark_last_item("ruler remove", static_cast<int>(mark));
    ImGui::PopID();
    if (!removed) return;
    list_.begin_edit();
    list_.remove(mark);
    renamed_.reset();
    keep();
  }
  // Enter applies the name; any other end of the edit discards it.
  void edit_name(size_t mark) {
    field_drawn_ = true;
    if (take_focus_) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    const bool entered =
        ImGui::InputText("##name", new_name_.data(), new_name_.size(),
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (take_focus_) {
      take_focus_ = !ImGui::IsItemActive();
      return;
    }
    if (!entered && ImGui::IsItemActive()) return;
    renamed_.reset();
    const std::string name = new_name_.data();
    if (!entered || name.empty() || name == list_.marks()[mark].name) return;
    list_.begin_edit();
    list_.rename(mark, name);
    keep();
  }
  void select_file_to_export() {
    browse(workspace_.services.browser,
           {.title = "Export Measurements",
            .verb = "Export",
            .hint = "File name (.csv)",
            .endings = {".csv"},
            .take = [this](const std::filesystem::path& file) { return export_to(file); },
            .inputs = [this] { return inputs_of(workspace_.session); }},
           workspace_.settings.folder, "distances.csv");
  }
  std::string export_to(const std::filesystem::path& file) {
    const Status written = write_file_atomically(file, list_.to_csv());
    if (!written) return written.error().message;
    workspace_.message.info("Exported: " + file.string());
    return "";
  }

  Workspace& workspace_;
  RulerList list_;
  std::optional<Vec3> first_;      // m, the clicked end of a distance that lacks the other
  std::optional<size_t> renamed_;  // the mark whose name is being edited
  bool take_focus_ = false;        // the field of the name is new
  bool field_drawn_ = false;       // in this frame
  std::array<char, 96> new_name_{};
};

// Input
// --------------------------------------------------------------------------------------------------------

// Panel
// --------------------------------------------------------------------------------------------------------

// Viewport
// --------------------------------------------------------------------------------------------------------

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

std::vector<std::string> lines_of(const FaceFacts& facts, const Body& body, FileUnit unit) {
  const auto length = [&](double metres) { return length_label(metres, unit); };
  const auto angle = [](double degrees) { return text_of("%.1f\u00b0", degrees); };
  const std::string level = facts.halvings == 0
                                ? "as loaded"
                                : "halved " + std::to_string(facts.halvings) + " times from loaded face " +
                                      std::to_string(facts.loaded.index);
  return {"Face " + std::to_string(facts.face.index) + ", " + level,
          "Piece   " + body.name_of(facts.piece),
          "Area   " + area_label(facts.area, unit),
          "Edges   " + joined(facts.edges, ", ", length),
          "Angles   " + joined(facts.angles, ", ", angle),
          "Neighbours   " + across(facts.neighbours[0]) + ", " + across(facts.neighbours[1]) + ", " +
              across(facts.neighbours[2]),
          temperature_text(facts),
          "Tree   block " + std::to_string(facts.slot.block) + ", place " +
              std::to_string(facts.slot.place + 1) + " of up to 4" +
              (facts.slot.hit ? "; visited by the beam" : "")};
}

void HeatProbe::follow(const World& world, const ViewState& view, const std::optional<Vec3>& clicked,
                       bool inspects) {
  if (clicked != at_) {
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

void RulerList::begin_edit() {
  undone_to_.push_back(marks_);
  redone_to_.clear();
}

void RulerList::add(const Vec3& from, const Vec3& to) {
  const auto has = [&](const std::string& name) {
    return std::any_of(marks_.begin(), marks_.end(), [&](const RulerMark& m) { return m.name == name; });
  };
  size_t number = marks_.size() + 1;
  while (has("Distance " + std::to_string(number))) ++number;
  marks_.push_back({"Distance " + std::to_string(number), from, to});
}

void RulerList::move(size_t mark, bool to_end, const Vec3& at) {
  KERF_ASSERT(mark < marks_.size());
  (to_end ? marks_[mark].to : marks_[mark].from) = at;
}

void RulerList::rename(size_t mark, std::string name) {
  KERF_ASSERT(mark < marks_.size());
  marks_[mark].name = std::move(name);
}

void RulerList::remove(size_t mark) {
  KERF_ASSERT(mark < marks_.size());
  marks_.erase(marks_.begin() + static_cast<std::ptrdiff_t>(mark));
}

void RulerList::undo() {
  KERF_ASSERT(can_undo());
  redone_to_.push_back(std::exchange(marks_, std::move(undone_to_.back())));
  undone_to_.pop_back();
}

void RulerList::redo() {
  KERF_ASSERT(can_redo());
  undone_to_.push_back(std::exchange(marks_, std::move(redone_to_.back())));
  redone_to_.pop_back();
}

nlohmann::json RulerList::to_json() const {
  if (marks_.empty()) return nullptr;
  nlohmann::json all = nlohmann::json::array();
  for (const RulerMark& m : marks_) {
    all.push_back(
        {{kName, m.name}, {kFrom, {m.from.x, m.from.y, m.from.z}}, {kTo, {m.to.x, m.to.y, m.to.z}}});
  }
  return all;
}

void RulerList::read(const nlohmann::json& entry) {
  *this = RulerList();
  if (!entry.is_array()) return;
  for (const nlohmann::json& json : entry) {
    if (auto mark = mark_of(json)) marks_.push_back(std::move(*mark));
  }
}

std::string RulerList::to_csv() const {
  std::string text = "name,from x,from y,from z,to x,to y,to z,length\n";
  for (const RulerMark& m : marks_) {
    text += quoted(m.name);
    for (const double number : {m.from.x, m.from.y, m.from.z, m.to.x, m.to.y, m.to.z, m.length()})
      text += csv_number(number);
    text += '\n';
  }
  return text;
}

std::unique_ptr<Feature> ruler_feature(Workspace& workspace) {
  return std::make_unique<RulerFeature>(workspace);
}

}  // namespace kerf
