#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>

#include "core/base/json.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

// A step of the history, or a group of steps.
struct Row {
  size_t position = 0;  // of the history, after the step
  std::string removed;  // the area that the step removed
  std::string weight;
};

// The steps of the history, to jump to by a click, and their memory limit.
class HistoryPanel {
 public:
  void draw(Workspace& workspace);

 private:
  void draw_list(WorldChanges& changes, const Document& document, FileUnit unit);
  void list_rows(const StepGroups& groups, const UndoStack& history, FileUnit unit);

  std::vector<Row> rows_;
  size_t shown_ = 0;  // the position that the list was scrolled to
};

constexpr size_t kMaxRows = 10;

// Formats the memory of the before-images of the steps from .. to - 1, by which they are undone at once.
std::string weight_text(const UndoStack& history, size_t from, size_t to) {
  size_t bytes = 0;
  for (size_t i = from; i < to; ++i) {
    if (history.step(i).images() == HistoryStep::Images::kNone) return "pending";
    bytes += history.step(i).totals().bytes;
  }
  if (!history.holds_images(from, to)) return "by replay";
  const double kilobytes = static_cast<double>(bytes) / 1024;
  return kilobytes < 1000 ? text_of("%.0f kB", kilobytes) : text_of("%.1f MB", kilobytes / 1024);
}

std::string removed_text(const UndoStack& history, size_t from, size_t to, FileUnit unit) {
  double area = 0;
  for (size_t i = from; i < to; ++i) area += history.step(i).totals().removed_area;
  return area > 0 ? area_label(area, unit) : "";
}

// Returns the row of a position of the history, and of its group if it ends one.
Row row_at(const UndoStack& history, const StepGroups& groups, size_t position, FileUnit unit) {
  if (position == 0) return {};
  const StepGroups::Group* group = groups.at(position, true);
  const size_t from = group != nullptr ? group->from : position - 1;
  return {position, removed_text(history, from, position, unit), weight_text(history, from, position)};
}

// Names the step, or the group of steps, that an undo (`back`) or a redo from a position covers.
std::string step_or_group(const UndoStack& history, const StepGroups& groups, size_t position, bool back,
                          FileUnit unit) {
  const StepGroups::Group* group = groups.at(position, back);
  return group != nullptr ? group->name : step_words(history, back ? position - 1 : position, unit);
}

float widest(const std::vector<Row>& rows, std::string Row::*text) {
  float width = 1;
  for (const Row& row : rows) width = std::max(width, ImGui::CalcTextSize((row.*text).c_str()).x);
  return width;
}

// Draws the row. Returns true if it was clicked and does not end at the current position `now`.
bool draw_row(size_t now, const Row& row, const std::string& name) {
  const size_t position = row.position;
  ImGui::PushID(static_cast<int>(position));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const bool undone = position > now;
  if (position == now) ImGui::PushStyleColor(ImGuiCol_Text, colours::accent());
  if (undone) ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  const std::string label = whole_label(fitted_text(name, ImGui::GetContentRegionAvail().x)) + "###step";
  const bool clicked = ImGui::Selectable(label.c_str(), position == now, ImGuiSelectableFlags_SpanAllColumns);
  mark_last_item("history row", static_cast<int>(position));
  const char* meaning = position == now ? "Current state."
                        : undone        ? "Undone. Click to redo up to this step."
                                        : "Click to undo back to this step; later steps can be redone.";
  tooltip((name + ". " + meaning).c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(row.removed.c_str());
  tooltip("Area removed by this step.");
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(row.weight.c_str());
  tooltip("Memory for undoing this step without replay.");
  if (undone) ImGui::PopStyleColor();
  if (position == now) {
    ImGui::PopStyleColor();
    ImGui::SetItemDefaultFocus();
  }
  ImGui::PopID();
  return clicked && position != now;
}

void draw_window(const Document& document, Settings& settings) {
  if (!begin_properties("window")) return;
  property("Memory");
  constexpr const char* kMeaning =
      "Memory limit for undo without replay. Older steps are replayed, which takes longer.";
  whole_slider({"Memory", "##window", kMeaning, true}, settings.history_megabytes, Settings::kMinHistory,
               Settings::kMaxHistory, grouped(static_cast<size_t>(settings.history_megabytes)) + " MB",
               {Quantity::kPlain, 1, " MB"});
  property("Memory Used");
  ImGui::TextUnformatted(
      text_of("%.1f MB", static_cast<double>(document.history().bytes()) / (1 << 20)).c_str());
  tooltip("Memory used by the steps above.");
  end_properties();
}

// Steps of a group share a row, and another if the current position is between them.
void HistoryPanel::list_rows(const StepGroups& groups, const UndoStack& history, FileUnit unit) {
  rows_.clear();
  for (size_t position = 0; position <= history.size(); ++position) {
    if (groups.has_row(position) || position == history.position())
      rows_.push_back(row_at(history, groups, position, unit));
  }
}

void HistoryPanel::draw_list(WorldChanges& changes, const Document& document, FileUnit unit) {
  constexpr ImGuiTableFlags kList =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
  const UndoStack& history = document.history();
  list_rows(changes.groups(), history, unit);
  const float height = height_of_rows(std::min(rows_.size(), kMaxRows));
  if (!ImGui::BeginTable("steps", 3, kList, {0, height})) return;
  ImGui::TableSetupColumn("Step", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("Removed", ImGuiTableColumnFlags_WidthFixed, widest(rows_, &Row::removed));
  ImGui::TableSetupColumn("Memory", ImGuiTableColumnFlags_WidthFixed, widest(rows_, &Row::weight));
  draw_rows_in_sight(rows_.size(), [&](size_t i) {
    const size_t position = rows_[i].position;
    const std::string name =
        position > 0 ? step_or_group(history, changes.groups(), position, true, unit) : "Original file";
    if (draw_row(history.position(), rows_[i], name))
      changes.enqueue("Travel",
                      [&changes, position] { changes.travel_to(position, "Jumping to a history step"); });
  });
  if (shown_ != history.position()) {
    shown_ = history.position();
    const auto row = std::lower_bound(rows_.begin(), rows_.end(), history.position(),
                                      [](const Row& r, size_t position) { return r.position < position; });
    scroll_to_row(static_cast<size_t>(row - rows_.begin()), height);
  }
  ImGui::EndTable();
}

void HistoryPanel::draw(Workspace& workspace) {
  draw_list(workspace.changes, workspace.session.document, workspace.view.frame.unit);
  draw_window(workspace.session.document, workspace.settings);
}

class HistoryFeature : public Feature {
 public:
  explicit HistoryFeature(Workspace& workspace)
      : workspace_(workspace), megabytes_(workspace.settings.history_megabytes) {}

  std::vector<PanelPart> panel_parts() override {
    return {{"history", [this] { panel_.draw(workspace_); }}};
  }
  std::vector<UserAction> actions() override {
    return {{.id = "edit.undo",
             .name = "Undo",
             .shortcut = "Ctrl+Z",
             .tip = "Reverts the last stroke or command.",
             .run = [this] { request_step(true); },
             .disabled_reason = [this] { return can_step(true) ? nullptr : "Nothing to undo"; },
             .menu_name = [this] { return "Undo" + step_name(true); }},
            {.id = "edit.redo",
             .name = "Redo",
             .shortcut = "Ctrl+Shift+Z",
             .also = {GLFW_KEY_Y, GLFW_MOD_CONTROL},
             .tip = "Repeats the last undone step.",
             .run = [this] { request_step(false); },
             .disabled_reason = [this] { return can_step(false) ? nullptr : "Nothing to redo"; },
             .menu_name = [this] { return "Redo" + step_name(false); }}};
  }

  void update(double) override {
    const Settings& settings = workspace_.settings;
    if (std::exchange(megabytes_, settings.history_megabytes) != settings.history_megabytes)
      workspace_.session.document.set_window(settings.history_bytes());
  }
  void write_session_log(nlohmann::ordered_json& report) const override {
    report["undo_depth"] = history().position();
  }

 private:
  const UndoStack& history() const { return workspace_.session.document.history(); }
  bool can_step(bool back) const {
    return back ? history().position() > 0 : history().position() < history().size();
  }
  // Returns " " and the short name of the step that would be undone or repeated; empty if there is none.
  std::string step_name(bool back) const {
    if (!can_step(back)) return "";
    const std::string words = step_or_group(history(), workspace_.changes.groups(), history().position(),
                                            back, workspace_.view.frame.unit);
    return " " + words.substr(0, words.find_first_of(",:"));
  }
  void request_step(bool back) {
    workspace_.changes.enqueue(back ? "Undo" : "Redo",
                               [this, back] { workspace_.changes.step_through_history(back); });
  }

  Workspace& workspace_;
  int megabytes_;  // limit of the undo data
  HistoryPanel panel_;
};

}  // namespace

std::unique_ptr<Feature> history_feature(Workspace& workspace) {
  return std::make_unique<HistoryFeature>(workspace);
}

}  // namespace kerf
