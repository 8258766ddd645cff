#include "core/base/json.h"
#include "ui/editor/shared/features.h"

#include <imgui.h>

#include <GLFW/glfw3.h>

#include "core/document/save.h"
#include "core/document/stroke_path.h"
#include "core/document/stroke_settings.h"
#include "core/document/text/json.h"
#include "ui/editor/path/path_panel.h"
#include "ui/editor/path/path_tool.h"
#include "ui/editor/path/path_work.h"
#include "ui/editor/shared/document_session.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

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
        [this](const std::filesystem::path& file) { return take_file(file); });
  }

  std::vector<PanelPart> panel_parts() override {
    return {{kPathPanel, [this] { draw_panel(); }}};
  }
  std::vector<UserAction> actions() override { return joined({{take_tool_action()}, path_actions()}); }
  std::vector<Gesture> gestures() const override {
    return {{"add_point", "Click on a surface",
             "Add a point to the path, with the tool Path; Shift begins another stroke"},
            {"move_point", "Left drag on a point or its knob",
             "Move a point of the path over the surface, turn its beam"}};
  }

  std::unique_ptr<Interaction> begin_interaction(const Press& press) override;
  const char* status_hint() const override {
    return is_active() ? "Path: click to add a point, Shift+click for a new stroke, Ctrl+Enter to run"
                       : nullptr;
  }

  void update(double) override {
    load_waiting();
    if (workspace_.input.held == nullptr) keep();
    workspace_.laser.planned_speed = path_.speed();
  }

  void on_document_opened() override;

  void draw_overlay(ImDrawList& list) override;
  void add_landmarks(Landmarks& landmarks) const override;
  void write_session_log(nlohmann::ordered_json& report) const override;

 private:
  bool is_active() const { return workspace_.input.tool == kPathTool; }
  bool shows_path() const { return is_active() || workspace_.services.panels.shows(kPathPanel); }
  const char* run_disabled_reason() const;
  UserAction take_tool_action();
  std::vector<UserAction> path_actions();
  void draw_panel();

  bool take_file(const std::filesystem::path& file);
  std::string load(const std::filesystem::path& file);
  void select_file_to_load();
  void select_file_to_save();
  void save(const std::filesystem::path& file);
  void load_waiting();
  void keep();

  void request_run();
  void run();

  Workspace& workspace_;
  PathWork path_;
  bool at_panel_resolution_ = false;  // run with the Resolution panel, not like kerf cut --path
  PathPanel panel_;
  size_t kept_ = 0;                             // PathWork::changes() of the path stored in the document
  std::vector<std::filesystem::path> waiting_;  // path files, until a document is open
};

// Input
// --------------------------------------------------------------------------------------------------------

std::unique_ptr<Interaction> PathFeature::begin_interaction(const Press& press) {
  if (!is_active() || press.control) return nullptr;
  auto drag = std::make_unique<DragOfPoint>(workspace_, path_);
  if (workspace_.view.in_second) {
    workspace_.message.error("Edit the path in the left half.");
    return drag;
  }
  stand_together(workspace_.world(), workspace_.view);
  workspace_.message.clear();
  const std::string why = drag->press(press.shift);
  if (!why.empty()) workspace_.message.error(why);
  return drag;
}

const char* PathFeature::run_disabled_reason() const {
  if (path_.empty()) return "The path has no points: click a surface with the Path tool.";
  return workspace_.opening.loader.busy() ? "Wait until the file is open." : nullptr;
}

UserAction PathFeature::take_tool_action() {
  UserAction action = tool_action(
      workspace_, kPathTool, "Path", "O",
      "Click a surface to add a point, Shift+click for a new stroke; drag points and beams.", true);
  return action;
}

std::vector<UserAction> PathFeature::path_actions() {
  // The undo and redo keys act on the path while its tool is active, until the path is run.
  const auto takes_undo = [this] {
    return is_active() && path_.is_newer_than(workspace_.session.document.history().position());
  };
  const auto empty_path_reason = [this] { return path_.empty() ? kNoPoints : nullptr; };
  return {
      UserAction{.id = "path.run",
                 .name = "Run Path",
                 .shortcut = "Ctrl+Enter",
                 .pad_key = GLFW_KEY_KP_ENTER,
                 .tip = "Cuts along the path, like kerf cut --path.",
                 .run = [this] { request_run(); },
                 .disabled_reason = [this] { return run_disabled_reason(); }},
      UserAction{.id = "path.load",
                 .name = "Load Path...",
                 .tip = "Loads a path file (.json); you can also drop one on the window.",
                 .run = [this] { select_file_to_load(); }},
      UserAction{.id = "path.save",
                 .name = "Save Path...",
                 .tip = "Saves the path as a file (.json) for kerf cut --path.",
                 .run = [this] { select_file_to_save(); },
                 .disabled_reason = empty_path_reason},
      UserAction{.id = "path.clear",
                 .name = "Clear Path",
                 .tip = "Removes all points.",
                 .run = [this] { path_.begin_edit(), path_.clear(); },
                 .disabled_reason = empty_path_reason},
      UserAction{
          .id = "path.delete_point",
          .name = "Delete Point",
          .shortcut = "Del",
          .pad_key = GLFW_KEY_BACKSPACE,
          .tip = "Deletes the selected point of the path; Backspace does the same.",
          .run = [this] { path_.begin_edit(), path_.remove(*path_.selected()); },
          .disabled_reason = [this] { return path_.selected() ? nullptr : "Select a point of the path."; },
          .has_key_when = [this] { return is_active() && path_.selected(); }},
      UserAction{
          .id = "path.undo",
          .name = "Undo Path Edit",
          .shortcut = "Ctrl+Z",
          .tip = "The key works with the Path tool, until the path is run.",
          .run = [this] { path_.undo(); },
          .disabled_reason = [this] { return path_.can_undo() ? nullptr : "There is no path edit to undo."; },
          .has_key_when = [this, takes_undo] { return takes_undo() && path_.can_undo(); }},
      UserAction{.id = "path.redo",
                 .name = "Redo Path Edit",
                 .shortcut = "Ctrl+Shift+Z",
                 .tip = "Repeats the undone edit of the path.",
                 .run = [this] { path_.redo(); },
                 .disabled_reason = [this] { return path_.can_redo() ? nullptr : "No path edit to redo."; },
                 .has_key_when = [this, takes_undo] { return takes_undo() && path_.can_redo(); }},
  };
}

void PathFeature::draw_panel() {
  panel_.draw(
      path_, at_panel_resolution_, workspace_.view, workspace_.world(),
      PathTool::beam_for(workspace_.world(), workspace_.laser.radius), run_disabled_reason(),
      {[this] { request_run(); }, [this] { select_file_to_load(); }, [this] { select_file_to_save(); }});
  keep();
}

// Files
// --------------------------------------------------------------------------------------------------------

// Accepts path files that are dropped on the window, opened by the menu, or named on the command line.
bool PathFeature::take_file(const std::filesystem::path& file) {
  if (!is_path_file(file)) return false;
  waiting_.push_back(file);
  return true;
}

// The path belongs to the document that is opened with it.
void PathFeature::load_waiting() {
  if (workspace_.opening.loader.busy()) return;
  for (const std::filesystem::path& file : std::exchange(waiting_, {})) {
    if (const std::string why = load(file); !why.empty()) workspace_.message.error(why);
  }
}

// Loads a path file, which can be undone, and activates the Path tool. Returns the reason on failure, else
// an empty text.
std::string PathFeature::load(const std::filesystem::path& file) {
  auto strokes = read_path_file(file);
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

void PathFeature::select_file_to_load() {
  browse(workspace_.services.browser,
         {.title = "Load Path",
          .verb = "Load",
          .hint = "Filter, or paste a full path",
          .listed = ".json",
          .take = [this](const std::filesystem::path& file) { return load(file); }},
         workspace_.settings.folder, "");
}

void PathFeature::select_file_to_save() {
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

void PathFeature::save(const std::filesystem::path& file) {
  const Status saved = save_path(file, path_.strokes());
  if (saved) path_.record_file(file);
  workspace_.message.show(saved ? "Saved: " + file.string() : saved.error().message, !saved.ok());
}

// The document
// --------------------------------------------------------------------------------------------------------

void PathFeature::keep() {
  if (kept_ == path_.changes()) return;
  kept_ = path_.changes();
  set_head_entry(workspace_.session.scene, kPathKey, path_entry(path_));
}

void PathFeature::on_document_opened() {
  path_ = path_of_entry(head_entry(workspace_.session.scene, kPathKey), workspace_.world());
  kept_ = path_.changes();
}

// Cutting
// --------------------------------------------------------------------------------------------------------

void PathFeature::request_run() {
  workspace_.changes.enqueue(
      {.name = "Run of the path", .run = [this] { return run(), true; }, .is_one = true});
}

// Cuts all strokes on another thread, or none if the user stops it.
void PathFeature::run() {
  if (const auto why = rejection_reason(path_.strokes())) return workspace_.message.error(*why);
  cancel_stroke(workspace_);
  path_.record_run(workspace_.session.document.history().position());
  std::function<Resolution(double)> resolution;
  if (at_panel_resolution_)
    resolution = [controls = workspace_.laser.resolution](double radius) { return controls.of(radius); };
  const auto cut = [commands = path_commands(path_.strokes(), workspace_.world().bounds().diagonal(),
                                             resolution)](Document& document, const Progress* progress) {
    Outcome outcome = document.run_whole(commands, progress);
    if (!outcome.ok() && outcome.error().message == cancelled().message)
      outcome.fail(failed("Path stopped; nothing was cut."));
    return outcome;
  };
  workspace_.changes.change("Cutting the path", false, cut, "Path cut.");
  workspace_.links.cut_once = true;
}

// Report
// --------------------------------------------------------------------------------------------------------

// Draws the path while its tool is active or its panel is unfolded.
void PathFeature::draw_overlay(ImDrawList& list) {
  if (!shows_path() || workspace_.cutting()) return;
  const FirstPicture picture(workspace_.view);
  const Area& first = workspace_.view.layout.first;
  list.PushClipRect(to_im(first.at), to_im(first.at + first.size), true);
  draw_path(path_, workspace_.world(), picture, list);
  list.PopClipRect();
}

void PathFeature::add_landmarks(Landmarks& landmarks) const {
  if (!shows_path()) return;
  const FirstPicture picture(workspace_.view);
  for (const PathMark& mark : path_marks(path_, workspace_.world(), picture))
    landmarks.mark("path point " + std::to_string(mark.number), {mark.target, Vec2(0)});
  if (const auto knob = path_knob(path_, picture)) landmarks.mark("path knob", {knob->place, Vec2(0)});
}

void PathFeature::write_session_log(nlohmann::ordered_json& report) const {
  nlohmann::ordered_json targets = nlohmann::ordered_json::array();
  for (size_t i = 0; i < path_.strokes().size(); ++i) {
    for (size_t k = 0; k < path_.strokes()[i].keys.size(); ++k)
      targets.push_back(vector_json(path_.target({i, k})));
  }
  report["path"] = {{"strokes", path_.strokes().size()}, {"targets", targets}, {"speed", path_.speed()}};
}

}  // namespace

std::unique_ptr<Feature> path_feature(Workspace& workspace) {
  return std::make_unique<PathFeature>(workspace);
}

}  // namespace kerf
