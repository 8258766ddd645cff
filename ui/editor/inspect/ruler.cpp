#include "ui/editor/inspect/ruler.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/json.h"
#include "core/base/platform.h"
#include "ui/editor/inspect/rim_circle.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/document_session.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/window/layout.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr const char* kName = "name";
constexpr const char* kFrom = "from";
constexpr const char* kTo = "to";
constexpr const char* kCircle = "circle";
constexpr const char* kNormal = "normal";
constexpr const char* kDeviation = "deviation";

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

std::optional<RulerMark::Circle> circle_of(const nlohmann::json& json) {
  if (!json.is_object()) return std::nullopt;
  const auto normal = point_of(json.value(kNormal, nlohmann::json()));
  const nlohmann::json deviation = json.value(kDeviation, nlohmann::json());
  if (!normal || !(glm::length(*normal) > 0) || !deviation.is_number()) return std::nullopt;
  return RulerMark::Circle{glm::normalize(*normal), deviation.get<double>()};
}

std::optional<RulerMark> mark_of(const nlohmann::json& json) {
  if (!json.is_object()) return std::nullopt;
  const nlohmann::json name = json.value(kName, nlohmann::json());
  const auto from = point_of(json.value(kFrom, nlohmann::json()));
  const auto to = point_of(json.value(kTo, nlohmann::json()));
  if (!name.is_string() || !from || !to) return std::nullopt;
  RulerMark mark{name.get<std::string>(), *from, *to};
  if (!json.contains(kCircle)) return mark;
  mark.circle = circle_of(json[kCircle]);
  return mark.circle ? std::optional(mark) : std::nullopt;
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

constexpr int kCirclePoints = 96;
constexpr double kSameCircle = 1e-6;  // max. difference, relative to the radius

// The measurement that clicks add.
enum class RulerKind { kDistance, kRimRadius };
constexpr const char* kRulerKinds[] = {"Distance", "Rim Radius"};

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
  std::vector<ToolOption> tool_options() override {
    return {
        {"ruler.kind", 7, [this] {
           if (marked_choice_row("Add", "##ruler kind", kind_, kRulerKinds, "ruler kind",
                                 "Distance takes two clicks; Rim Radius fits a circle to the clicked rim."))
             first_.reset();
         }}};
  }
  std::vector<UserAction> actions() override {
    const UserAction take =
        tool_action(workspace_, kRulerTool, "Ruler", "",
                    "Click two points, or a rim, to add a measurement that is saved with the "
                    "document and can be exported.",
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
                "Writes all measurements to a table (.csv) or as JSON.", [this] { select_file_to_export(); },
                [this] { return list_.marks().empty() ? kNoMeasurements : nullptr; })};
  }

  std::unique_ptr<Interaction> begin_interaction(const Press& press) override {
    if (!is_active() || press.control) return nullptr;
    if (workspace_.view.in_second) {
      workspace_.message.error("Measure in the left half.");
      return std::make_unique<ClickOnce>([] {});
    }
    if (end_exploded_view(workspace_.world(), workspace_.view)) {
      workspace_.message.info(kExplodedViewEnded);
      return std::make_unique<ClickOnce>([] {});
    }
    if (const auto end = end_under_pointer(); end && !first_) return std::make_unique<DragOfEnd>(*this, *end);
    return std::make_unique<ClickOnce>([this] { measure(); });
  }
  bool clear_selection() override { return std::exchange(first_, std::nullopt).has_value(); }
  const char* status_hint() const override {
    if (!is_active()) return nullptr;
    return kind_ == RulerKind::kRimRadius ? "Ruler: click the rim of a hole or a cut"
                                          : "Ruler: click two points to add a measurement; drag its ends";
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
      if (m.circle) draw_circle(m, list);
      draw_distance(workspace_.view, m.from, m.to, m.name + ": " + value_text(m), list);
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
      if (over()) return;
      const auto surface = point_under_pointer(feature_.workspace_);
      if (!surface) return;
      if (!std::exchange(edits_, true)) feature_.list_.begin_edit();
      feature_.list_.move(end_.mark, end_.to, *surface);
      feature_.keep();
    }
    // Undo and redo may remove the measurement, or put a circle in its place.
    bool over() const override {
      const std::vector<RulerMark>& marks = feature_.list_.marks();
      return end_.mark >= marks.size() || marks[end_.mark].circle.has_value();
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
      if (list_.marks()[i].circle) continue;
      for (const bool to : {false, true}) {
        const auto place = picture.place_of(to ? list_.marks()[i].to : list_.marks()[i].from);
        if (place && glm::length(*place - workspace_.input.pointer) < kReachOfEnd) return EndOfMark{i, to};
      }
    }
    return std::nullopt;
  }
  std::string value_text(const RulerMark& mark) const {
    return length_label(mark.length(), workspace_.view.frame.unit);
  }
  void draw_circle(const RulerMark& mark, ImDrawList& list) const {
    const PrimaryViewport viewport(workspace_.view);
    const Vec3 u = mark.to - mark.from, v = glm::cross(mark.circle->normal, u);
    std::vector<ImVec2> places;
    for (int i = 0; i < kCirclePoints; ++i) {
      const double angle = 2 * kPi * i / kCirclePoints;
      const auto place = viewport.place_of(mark.from + std::cos(angle) * u + std::sin(angle) * v);
      if (!place) return;
      places.push_back(to_im(*place));
    }
    list.AddPolyline(places.data(), kCirclePoints, IM_COL32(10, 12, 16, 190), ImDrawFlags_Closed, 4);
    list.AddPolyline(places.data(), kCirclePoints, colours::kPictureText, ImDrawFlags_Closed, 1.5f);
  }
  // Fits a circle to the rim at the pointer.
  void measure_rim() {
    const Vec2 pointer = workspace_.input.pointer;
    const auto rim = rim_at(workspace_.world(), workspace_.view, pointer);
    if (!rim)
      return workspace_.message.error("No rim under the pointer: click an open or sharp edge of a surface.");
    const auto circle = fit_circle(*rim);
    if (!circle) return workspace_.message.error("The rim encloses no area, so no circle fits it.");
    if (const RulerMark* known = list_.radius_of(circle->centre, circle->radius, circle->normal))
      return workspace_.message.info(known->name + " already measures this rim: " + value_text(*known));
    const PrimaryViewport viewport(workspace_.view);
    const Vec3 clicked = viewport.at_depth_of(circle->centre, pointer) - circle->centre;
    const Vec3 across = clicked - glm::dot(clicked, circle->normal) * circle->normal;
    const Vec3 towards = glm::length(across) > 0 ? across : rim->front() - circle->centre;
    list_.begin_edit();
    list_.add(circle->centre, circle->centre + circle->radius * glm::normalize(towards),
              RulerMark::Circle{circle->normal, circle->deviation});
    keep();
    const RulerMark& mark = list_.marks().back();
    const FileUnit unit = workspace_.view.frame.unit;
    workspace_.message.info(mark.name + ": " + value_text(mark) + ", diameter " +
                            length_label(2 * circle->radius, unit) + "; the rim deviates by up to " +
                            length_label(circle->deviation, unit));
  }
  // Measures from the last click, or begins a distance.
  void measure() {
    if (kind_ == RulerKind::kRimRadius) return measure_rim();
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
    workspace_.message.info(mark.name + ": " + value_text(mark));
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
    if (list_.marks().empty())
      ImGui::TextWrapped("Click two points on surfaces, or a rim, with the Ruler tool.");
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
                   "Writes the measurements to a table (.csv) or as JSON."))
      select_file_to_export();
  }
  void draw_row(size_t mark) {
    ImGui::PushID(static_cast<int>(mark));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string name = list_.marks()[mark].name;
    if (renamed_ == mark) {
      edit_name(mark);
    } else if (const float room = ImGui::GetContentRegionAvail().x;
               ImGui::Selectable((whole_label(fitted_text(name, room)) + "###name").c_str())) {
      renamed_ = mark;
      take_focus_ = field_drawn_ = true;
      fill_field(new_name_, name);
      old_name_ = new_name_.data();
    }
    mark_last_item("ruler name", static_cast<int>(mark));
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(value_text(list_.marks()[mark]).c_str());
    if (const auto& circle = list_.marks()[mark].circle) {
      const FileUnit unit = workspace_.view.frame.unit;
      tooltip(("Radius of the circle fitted to a rim, which deviates from it by up to " +
               length_label(circle->deviation, unit) + ".")
                  .c_str());
    }
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
    if (!entered || name.empty() || name == old_name_) return;
    list_.begin_edit();
    list_.rename(mark, name);
    keep();
  }
  void select_file_to_export() {
    browse(workspace_.services.browser,
           {.title = "Export Measurements",
            .verb = "Export",
            .hint = "File name (.csv or .json)",
            .endings = {".csv", ".json"},
            .take = [this](const std::filesystem::path& file) { return export_to(file); },
            .inputs = [this] { return inputs_of(workspace_.session); }},
           workspace_.settings.folder, "distances.csv");
  }
  std::string export_to(const std::filesystem::path& file) {
    const bool json = file.extension() == ".json";
    const Status written =
        write_file_atomically(file, json ? list_.to_json().dump(2) + "\n" : list_.to_csv());
    if (!written) return written.error().message;
    workspace_.message.info("Exported: " + file.string());
    return "";
  }

  Workspace& workspace_;
  RulerList list_;
  RulerKind kind_ = RulerKind::kDistance;
  std::optional<Vec3> first_;      // m, the clicked end of a distance that lacks the other
  std::optional<size_t> renamed_;  // the mark whose name is being edited
  bool take_focus_ = false;        // the field of the name is new
  bool field_drawn_ = false;       // in this frame
  std::string old_name_;           // as the field shows it first
  std::array<char, 96> new_name_{};
};

}  // namespace

void RulerList::begin_edit() {
  undone_to_.push_back(marks_);
  redone_to_.clear();
}

void RulerList::add(const Vec3& from, const Vec3& to, const std::optional<RulerMark::Circle>& circle) {
  const std::string kind = circle ? "Radius " : "Distance ";
  const auto has = [&](const std::string& name) {
    return std::any_of(marks_.begin(), marks_.end(), [&](const RulerMark& m) { return m.name == name; });
  };
  size_t number = marks_.size() + 1;
  while (has(kind + std::to_string(number))) ++number;
  marks_.push_back({kind + std::to_string(number), from, to, circle});
}

const RulerMark* RulerList::radius_of(const Vec3& centre, double radius, const Vec3& normal) const {
  const auto known = std::ranges::find_if(marks_, [&](const RulerMark& m) {
    return m.circle && glm::length(m.from - centre) <= kSameCircle * radius &&
           std::abs(m.length() - radius) <= kSameCircle * radius &&
           glm::length(glm::cross(m.circle->normal, normal)) <= kSameCircle;
  });
  return known != marks_.end() ? &*known : nullptr;
}

void RulerList::move(size_t mark, bool to_end, const Vec3& at) {
  KERF_ASSERT(mark < marks_.size() && !marks_[mark].circle);
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
    nlohmann::json& entry = all.emplace_back(nlohmann::json::object());
    entry = {{kName, m.name}, {kFrom, {m.from.x, m.from.y, m.from.z}}, {kTo, {m.to.x, m.to.y, m.to.z}}};
    if (!m.circle) continue;
    const Vec3& normal = m.circle->normal;
    entry[kCircle] = {{kNormal, {normal.x, normal.y, normal.z}}, {kDeviation, m.circle->deviation}};
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
  std::string text = "name,from x,from y,from z,to x,to y,to z,length,kind,deviation\n";
  for (const RulerMark& m : marks_) {
    text += quoted(m.name);
    for (const double number : {m.from.x, m.from.y, m.from.z, m.to.x, m.to.y, m.to.z, m.length()})
      text += csv_number(number);
    text += m.circle ? ",radius" + csv_number(m.circle->deviation) : ",distance,";
    text += '\n';
  }
  return text;
}

std::unique_ptr<Feature> ruler_feature(Workspace& workspace) {
  return std::make_unique<RulerFeature>(workspace);
}

}  // namespace kerf
