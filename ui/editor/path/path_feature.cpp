#include "ui/editor/path/path_feature.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/base/json.h"
#include "core/document/job_files.h"
#include "core/document/save.h"
#include "core/document/text/json.h"
#include "ui/editor/path/drawing_placement.h"
#include "ui/editor/path/uncut_lines.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/document_session.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/window/layout.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr size_t kMaxPointRows = 7;

constexpr const char* kEmpty = "The path has no points.";

std::string summary(const PathWork& path, const ViewState& view) {
  if (path.empty())
    return with_shortcut(view, "Click points on a surface with the Path tool", "tool.path") +
           ", or load a path file.";
  double way = 0, seconds = 0;
  for (const StrokePath& stroke : path.strokes()) {
    way += way_of(stroke);
    seconds += duration_of(stroke);
  }
  const std::string counts =
      count_text(path.strokes().size(), "stroke") + ", " + count_text(path.points(), "point");
  if (way == 0 && seconds == 0) return counts;
  return counts + ", length " + length_label(way, view.frame.unit) + ", " + text_of("%.3g s", seconds);
}

// Returns the point with this number, counted over all strokes.
PathPoint numbered(const PathWork& path, size_t number) {
  KERF_ASSERT(number < path.points());
  size_t stroke = 0;
  for (; number >= path.strokes()[stroke].keys.size(); ++stroke) number -= path.strokes()[stroke].keys.size();
  return {stroke, number};
}

size_t number_of(const PathWork& path, PathPoint point) {
  size_t number = point.key;
  for (size_t i = 0; i < point.stroke; ++i) number += path.strokes()[i].keys.size();
  return number;
}

// Sets up the headings, which stay visible while the list scrolls. `unit`: of lengths.
void set_up_columns(const std::string& unit) {
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Point");
  for (const char* axis : {"X", "Y", "Z"}) ImGui::TableSetupColumn((axis + (" (" + unit + ")")).c_str());
  ImGui::TableHeadersRow();
}

constexpr const char* kPathPanel = "path";
constexpr const char* kPathKey = "path";  // in the head of a document
constexpr const char* kNoPoints = "The path has no points.";

class DragOfPoint : public Interaction {
 public:
  DragOfPoint(Workspace& workspace, PathWork& path) : workspace_(workspace), path_(path) {}

  // Returns the reason if nothing happened, else an empty text.
  std::string press(bool new_stroke) {
    return tool_.press(path_, workspace_.world(), workspace_.view, workspace_.input.pointer, new_stroke,
                       PathTool::beam_for(workspace_.world(), workspace_.laser.radius));
  }
  void move(const InputEvent&) override {
    tool_.move(path_, workspace_.world(), workspace_.view, workspace_.input.pointer);
  }
  const char* words() const override { return "Path: drag the point over the surface"; }

 private:
  Workspace& workspace_;
  PathWork& path_;
  PathTool tool_;
};

class PathFeature : public Feature {
 public:
  explicit PathFeature(Workspace& workspace) : workspace_(workspace) {
    workspace.links.file_takers.push_back(
        {accepts, [this](const std::filesystem::path& file) { waiting_.push_back(file); }});
  }

  std::vector<PanelPart> panel_parts() override {
    return {{kPathPanel, [this] { draw_panel(); }}};
  }
  std::vector<ToolOption> tool_options() override {
    return {{"path.speed", 6, [this] { panel_.draw_speed(path_, workspace_.view.frame.unit); },
             [this] { return !path_.empty(); }},
            {"path.resolution", 10, [this] { panel_.draw_resolution(at_panel_resolution_); }}};
  }
  std::vector<UserAction> actions() override { return joined({{take_tool_action()}, path_actions()}); }
  std::vector<Gesture> gestures() const override {
    return {{"add_point", "Click on a surface",
             "Add a point to the path, with the Path tool; Shift begins another stroke"},
            {"move_point", "Left drag on a point or its knob",
             "Move a point of the path over the surface, or turn its beam"}};
  }

  std::unique_ptr<Interaction> begin_interaction(const Press& press) override {
    if (!is_active() || press.control) return nullptr;
    auto drag = std::make_unique<DragOfPoint>(workspace_, path_);
    if (workspace_.view.in_second) {
      workspace_.message.error("Edit the path in the left half.");
      return drag;
    }
    end_exploded_view(workspace_.world(), workspace_.view);
    workspace_.message.clear();
    const std::string why = drag->press(press.shift);
    if (!why.empty()) workspace_.message.error(why);
    return drag;
  }
  const char* status_hint() const override {
    if (!is_active()) return nullptr;
    const std::string key = shortcut_of(workspace_.view, "path.run");
    hint_ = "Path: click to add a point, Shift+click for a new stroke" +
            (key.empty() ? "" : ", " + key + " to run");
    return hint_.c_str();
  }

  void update(double) override {
    load_waiting();
    record_finished_run();
    uncut_.update(workspace_);
    if (workspace_.input.held == nullptr) keep();
    workspace_.laser.planned_speed = path_.speed();
  }

  void on_world_changed(const Delta&) override { uncut_.clear(); }
  void on_document_opened() override {
    path_ = path_of_entry(head_entry(workspace_.session.scene, kPathKey), workspace_.world());
    kept_ = path_.changes();
    runs_from_.reset();
    uncut_ = UncutMarks();
  }
  // Draws the path while its tool is active or its panel is unfolded.
  void draw_overlay(ImDrawList& list) override {
    uncut_.draw(workspace_, list);
    if (!shows_path() || workspace_.cutting()) return;
    const PrimaryViewport picture(workspace_.view);
    const Area& first = workspace_.view.layout.first;
    list.PushClipRect(to_im(first.at), to_im(first.at + first.size), true);
    panel_.draw_hole_preview(workspace_.view, list);
    draw_path(path_, workspace_.world(), picture, list);
    list.PopClipRect();
  }
  void add_landmarks(Landmarks& landmarks) const override {
    if (!shows_path()) return;
    const PrimaryViewport picture(workspace_.view);
    for (const PathMark& mark : path_marks(path_, workspace_.world(), picture))
      landmarks.mark("path point " + std::to_string(mark.number), {mark.target, Vec2(0)});
    if (const auto knob = path_knob(path_, picture)) landmarks.mark("path knob", {knob->place, Vec2(0)});
  }
  void write_session_log(nlohmann::ordered_json& report) const override {
    nlohmann::ordered_json targets = nlohmann::ordered_json::array();
    for (size_t i = 0; i < path_.strokes().size(); ++i) {
      for (size_t k = 0; k < path_.strokes()[i].keys.size(); ++k)
        targets.push_back(vector_json(path_.target({i, k})));
    }
    if (uncut_.size() > 0) report["uncut_lines"] = uncut_.size();
    report["path"] = {{"strokes", path_.strokes().size()}, {"targets", targets}, {"speed", path_.speed()}};
  }

 private:
  bool is_active() const { return workspace_.input.tool == kPathTool; }
  bool shows_path() const { return is_active() || workspace_.services.panels.shows(kPathPanel); }
  const char* run_disabled_reason() const {
    if (path_.empty()) return "The path has no points: click a surface with the Path tool.";
    return workspace_.opening.loader.busy() ? "Wait until the file is open." : nullptr;
  }
  UserAction take_tool_action() {
    UserAction action = tool_action(
        workspace_, kPathTool, "Path", "O",
        "Click a surface to add a point, Shift+click for a new stroke; drag points and beams.", true);
    return action;
  }
  std::vector<UserAction> path_actions() {
    // The undo and redo keys act on the path while its tool is active, until the path is run.
    const auto takes_undo = [this] {
      return is_active() && path_.is_newer_than(workspace_.session.document.history().position());
    };
    const auto empty_path_reason = [this] { return path_.empty() ? kNoPoints : nullptr; };
    return {
        UserAction{.id = "path.run",
                   .name = "Run Path",
                   .shortcut = "Ctrl+Enter",
                   .also = {GLFW_KEY_KP_ENTER, GLFW_MOD_CONTROL},
                   .tip = "Cuts along the path, like kerf cut --path.",
                   .run = [this] { request_run(); },
                   .disabled_reason = [this] { return run_disabled_reason(); }},
        make_action("path.load", "Load Path...", "",
                    "Loads a path (.json) or a G-code program; you can also drop one on the window.",
                    [this] { select_file_to_load(); }),
        make_action("path.save", "Save Path...", "", "Saves the path as a file (.json) for kerf cut --path.",
                    [this] { select_file_to_save(); }, {.disabled_reason = empty_path_reason}),
        make_action("path.clear", "Clear Path", "", "Removes all points.",
                    [this] { path_.begin_edit(), path_.clear(); }, {.disabled_reason = empty_path_reason}),
        UserAction{
            .id = "path.delete_point",
            .name = "Delete Point",
            .shortcut = "Del",
            .also = {GLFW_KEY_BACKSPACE},
            .tip = "Deletes the selected point of the path; Backspace does the same.",
            .run = [this] { path_.begin_edit(), path_.remove(*path_.selected()); },
            .disabled_reason = [this] { return path_.selected() ? nullptr : "Select a point of the path."; },
            .has_key_when = [this] { return is_active() && path_.selected(); }},
        make_action(
            "path.undo", "Undo Path Edit", "Ctrl+Z",
            "Reverts the last path edit. The key works with the Path tool until the path is run.",
            [this] { path_.undo(); },
            {.disabled_reason = [this] { return path_.can_undo() ? nullptr : "No path edit to undo."; },
             .has_key_when = [this, takes_undo] { return takes_undo() && path_.can_undo(); }}),
        make_action(
            "path.redo", "Redo Path Edit", "Ctrl+Shift+Z", "Repeats the undone edit of the path.",
            [this] { path_.redo(); },
            {.disabled_reason = [this] { return path_.can_redo() ? nullptr : "No path edit to redo."; },
             .has_key_when = [this, takes_undo] { return takes_undo() && path_.can_redo(); }}),
    };
  }
  void draw_panel() {
    panel_.draw(
        path_, at_panel_resolution_, workspace_.view, workspace_.world(),
        PathTool::beam_for(workspace_.world(), workspace_.laser.radius), run_disabled_reason(),
        {[this] { request_run(); }, [this] { select_file_to_load(); }, [this] { select_file_to_save(); }});
    uncut_.draw_list();
    keep();
  }
  // Accepts path files that are dropped on the window, opened by the menu, or named on the command line.
  static bool accepts(const std::filesystem::path& file) {
    return is_path_file(file) || job_kind(file) == JobFile::Kind::kProgram;
  }
  // Reads a path file, or a program, whose beam points down and whose lengths are true in the unit of the
  // document.
  Result<std::vector<StrokePath>> read(const std::filesystem::path& file) const {
    if (job_kind(file) != JobFile::Kind::kProgram) return read_path_file(file);
    constexpr double kOfRadius = 50;
    const auto job =
        read_job(file, JobFile::Kind::kProgram,
                 workspace_.laser.radius * metres_per_unit(workspace_.view.frame.unit) / kOfRadius);
    if (!job) return job.error();
    const FileFrame& frame = workspace_.view.frame;
    JobPlane plane = *plane_onto(kBeamAxes.at(static_cast<size_t>(downward_beam(frame.up))));
    plane.scale = 1 / metres_per_unit(frame.unit);
    return program_strokes(job->program, plane, std::nullopt);
  }
  // Loads such a file, which can be undone, and activates the Path tool. Returns the reason on failure, else
  // an empty text.
  std::string load(const std::filesystem::path& file) {
    auto strokes = read(file);
    if (!strokes) return strokes.error().message;
    path_.begin_edit();
    path_.load(std::move(*strokes), workspace_.world());
    path_.record_file(file);
    workspace_.input.tool = kPathTool;
    workspace_.services.panels.show(kPathPanel);
    workspace_.message.info("Loaded: " + file.string() + ", " + count_text(path_.strokes().size(), "stroke") +
                            ", " + count_text(path_.points(), "point"));
    return "";
  }
  void select_file_to_load() {
    browse(workspace_.services.browser,
           {.title = "Load Path",
            .verb = "Load",
            .hint = "Filter, or paste a full path",
            .only = FileKind::kPaths,
            .take = [this](const std::filesystem::path& file) { return load(file); }},
           workspace_.settings.folder, "");
  }
  void select_file_to_save() {
    const std::string name = path_.file().filename().string();
    browse(workspace_.services.browser,
           {.title = "Save Path",
            .verb = "Save",
            .hint = "File name (.json)",
            .listed = ".json",
            .endings = {".json"},
            .take =
                [this](const std::filesystem::path& file) {
                  save(file);
                  return "";
                },
            .inputs = [this] { return inputs_of(workspace_.session); }},
           workspace_.settings.folder, name.empty() ? "path.json" : name);
  }
  void save(const std::filesystem::path& file) {
    if (const auto why = rejection_reason(path_.strokes())) return workspace_.message.error(*why);
    const Status saved = save_path(file, path_.strokes());
    if (saved) path_.record_file(file);
    workspace_.message.show(saved ? "Saved: " + file.string() : saved.error().message, !saved.ok());
  }
  // A path dropped while a document is opened belongs to that document.
  void load_waiting() {
    if (workspace_.opening.loader.busy()) return;
    for (const std::filesystem::path& file : std::exchange(waiting_, {})) {
      if (const std::string why = load(file); !why.empty()) workspace_.message.error(why);
    }
  }
  void keep() {
    if (kept_ == path_.changes()) return;
    kept_ = path_.changes();
    set_head_entry(workspace_.session.scene, kPathKey, path_entry(path_));
  }

  void request_run() {
    workspace_.changes.enqueue({.name = "Run path", .run = [this] { return run(), true; }, .is_one = true});
  }
  // Cuts all strokes on another thread, or none if the user stops it.
  void run() {
    if (const auto why = rejection_reason(path_.strokes())) return workspace_.message.error(*why);
    cancel_stroke(workspace_);
    runs_from_ = workspace_.session.document.history().position();
    const double diagonal = workspace_.world().bounds().diagonal();
    PlannedRun planned = planned_run(path_.strokes(), workspace_.laser, diagonal, at_panel_resolution_);
    uncut_.begin(workspace_, path_.strokes());
    workspace_.changes.change("Cutting the path", false, cut_along(std::move(planned.commands), "Path"),
                              planned.message);
    workspace_.links.cut_once = true;
  }
  // A run that was stopped or that met no surface leaves no step in the history.
  void record_finished_run() {
    if (!runs_from_ || workspace_.changes.is_pending()) return;
    const size_t from = *std::exchange(runs_from_, std::nullopt);
    if (workspace_.session.document.history().position() > from) path_.record_run(from);
  }

  Workspace& workspace_;
  PathWork path_;
  bool at_panel_resolution_ = false;  // run with the Resolution panel, not like kerf cut --path
  PathPanel panel_;
  UncutMarks uncut_;
  std::optional<size_t> runs_from_;             // position of the history before the current run
  size_t kept_ = 0;                             // PathWork::changes() of the path stored in the document
  std::vector<std::filesystem::path> waiting_;  // path files, until a document is open
  mutable std::string hint_;                    // returned by status_hint()
};

}  // namespace

PlannedRun planned_run(std::span<const StrokePath> strokes, const LaserControls& laser, double diagonal,
                       bool at_panel_resolution) {
  PlannedRun run{{}, "Path cut."};
  if (laser.model == Model::kGeometric) {
    std::function<Resolution(double)> resolution;
    if (at_panel_resolution)
      resolution = [controls = laser.resolution](double radius) {
        return radius > 0 ? controls.of(radius) : Resolution();  // the knife needs none
      };
    run.commands = path_commands(strokes, diagonal, resolution);
    return run;
  }
  LaserControls own = laser;
  own.radius = default_settings(StrokePath(), diagonal).laser.radius;
  if (!at_panel_resolution) {
    own.pattern = Pattern::kVolume;
    own.resolution = {.edge_fraction = 1, .rim = Rim::kFaces};  // the defaults of kerf cut --model thermal
  }
  run.commands = own.commands_of(strokes, diagonal, false);
  const auto instant = static_cast<size_t>(std::ranges::count_if(
      strokes, [](const StrokePath& s) { return s.radius != 0.0 && duration_of(s) <= 0; }));
  if (instant > 0)
    run.message = "Path cut; " + count_text(instant, "stroke") +
                  (instant == 1 ? " lasts no time and emits" : " last no time and emit") + " no energy.";
  return run;
}

void PathPanel::draw_buttons(PathWork& path, const ViewState& view, const char* run_disabled_reason,
                             const PathActions& requests) {
  const std::string run = with_shortcut(view, "Cuts along the path, like kerf cut --path.", "path.run");
  if (row_button("Run", 4, run_disabled_reason, run.c_str())) requests.run();
  ImGui::SameLine();
  if (row_button("Load", 4, nullptr,
                 "Loads a path (.json) or a G-code program; you can also drop one on the window."))
    requests.load();
  ImGui::SameLine();
  const char* empty_path_reason = path.empty() ? kEmpty : nullptr;
  if (row_button("Save", 4, empty_path_reason, "Saves the path as a file (.json) for kerf cut --path."))
    requests.save();
  ImGui::SameLine();
  if (!row_button("Clear", 4, empty_path_reason, "Removes all points; undo restores them.")) return;
  path.begin_edit();
  path.clear();
}

void PathPanel::draw_speed(PathWork& path, FileUnit unit) {
  double speed = path.speed();
  const char* meaning =
      path.has_times_of_file()
          ? "Mean speed of the beam origin by the times in the file; typing a speed replaces these times."
          : "Speed of the origin of the beam.";
  if (!length_field(fields_, "Speed", speed, label_unit(speed, unit), meaning, "/s", kPositive)) return;
  path.begin_edit();
  path.set_speed(speed);
}

// Returns the point whose numbers are shown: the selected one. A press in the viewport selects another one
// before a field that it leaves has reported its entry, which belongs to the point before.
const std::optional<PathPoint>& PathPanel::point_of_fields(const PathWork& path) {
  if (!fields_.is_active() || !edited_ || !path.has(*edited_)) edited_ = path.selected();
  return edited_;
}

void PathPanel::draw_radius(PathWork& path, size_t stroke, const World& world, FileUnit unit) {
  const StrokePath& drawn = path.strokes()[stroke];
  double radius = default_settings(drawn, world.bounds().diagonal()).laser.radius;
  if (!length_field(fields_, "Beam Radius", radius, label_unit(radius, unit),
                    drawn.radius ? "Radius of the stroke with the selected point."
                                 : "Radius of the stroke with the selected point; by default 1/400 of the "
                                   "diagonal of all meshes.",
                    "", kPositive))
    return;
  path.begin_edit();
  path.set_radius(stroke, radius);
}

void PathPanel::draw_resolution(bool& at_panel_resolution) {
  choice_row("Resolution", "##cut", at_panel_resolution, "As kerf cut\0As Resolution Panel\0",
             "path resolution",
             "Cuts with the resolution and rim of kerf cut --path, or of the Resolution panel.");
}

void PathPanel::draw_beam(PathWork& path, bool& at_panel_resolution, const World& world, FileUnit unit) {
  if (path.empty() || !begin_properties("beam")) return;
  draw_speed(path, unit);
  draw_resolution(at_panel_resolution);
  if (const auto& point = point_of_fields(path)) draw_radius(path, point->stroke, world, unit);
  end_properties();
}

void PathPanel::draw_row(PathWork& path, PathPoint point, int number, double unit, double diagonal) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const bool selected = path.selected() == point;
  ImGui::PushID(number);
  if (selected) ImGui::PushStyleColor(ImGuiCol_Text, colours::accent());
  const std::string label = std::to_string(point.stroke + 1) + "." + std::to_string(point.key + 1);
  if (ImGui::Selectable(label.c_str(), selected, ImGuiSelectableFlags_SpanAllColumns))
    shown_ = point, path.select(point);
  mark_last_item("path row", number);
  for (int i = 0; i < 3; ++i) {
    ImGui::TableNextColumn();
    draw_fitted_text(number_text(path.target(point)[i] / unit, "%.4g", diagonal / unit));
  }
  if (selected) ImGui::PopStyleColor();
  ImGui::PopID();
}

void PathPanel::draw_list(PathWork& path, const World& world, FileUnit unit) {
  constexpr ImGuiTableFlags kList =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
  const size_t points = path.points();
  if (points == 0) return;
  const float height = height_of_rows(std::min(points, kMaxPointRows) + 1);
  if (!ImGui::BeginTable("points", 4, kList, {0, height})) return;
  const double diagonal = world.loaded_bounds().diagonal();
  const LengthUnit shown = label_unit(diagonal, unit);
  set_up_columns(shown.name);
  draw_rows_in_sight(points, [&](size_t i) {
    draw_row(path, numbered(path, i), static_cast<int>(i), shown.metres, diagonal);
  });
  if (path.selected() && path.selected() != shown_) {
    shown_ = path.selected();
    scroll_to_row(number_of(path, *shown_), height);
  }
  ImGui::EndTable();
}

void PathPanel::draw_selected(PathWork& path, const World& world, FileUnit unit) {
  if (!point_of_fields(path) || !begin_properties("point")) return;
  const PathPoint point = *edited_;
  Vec3 target = path.target(point), direction = path.pose(point).direction;
  double distance = path.distance(point);
  bool edited =
      fields_.vector("Target", target, "%.5g",
                     "Position of the selected point, in the unit of the file; its beam moves with it.",
                     file_unit(unit), world.loaded_bounds().diagonal());
  edited = fields_.vector("Direction", direction, "%.4g", "Direction of the beam, of any length.") || edited;
  edited =
      length_field(fields_, "Distance", distance, label_unit(distance, unit),
                   "Distance of the beam origin from the target. The beam cuts everything within its range.",
                   "", kPositive) ||
      edited;
  end_properties();
  if (!edited) return;
  if (direction == Vec3(0))
    return report_refused_entry("Direction stays the same: one of its numbers must not be 0");
  direction = beam_direction(direction);
  path.begin_edit();
  path.set(point, {target - direction * distance, direction}, distance);
}

void PathPanel::draw(PathWork& path, bool& at_panel_resolution, const ViewState& view, const World& world,
                     const PathTool::Beam& beam, const char* run_disabled_reason,
                     const PathActions& requests) {
  const FileUnit unit = view.frame.unit;
  draw_buttons(path, view, run_disabled_reason, requests);
  secondary_text(summary(path, view));
  draw_beam(path, at_panel_resolution, world, unit);
  draw_list(path, world, unit);
  draw_selected(path, world, unit);
  const bool unfolded = ImGui::TreeNodeEx("Holes", ImGuiTreeNodeFlags_NoTreePushOnOpen);
  mark_last_item("Holes header");
  tooltip("Adds a grid or circle of holes around the selected point.");
  if (unfolded) holes_.draw(path, world, view.look, beam.radius, beam.speed, unit);
}

std::unique_ptr<Feature> path_feature(Workspace& workspace) {
  return std::make_unique<PathFeature>(workspace);
}

}  // namespace kerf
