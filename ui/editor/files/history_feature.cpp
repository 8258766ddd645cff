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

// The steps of the history, to jump to by a click, and their memory limit.
class HistoryPanel {
 public:
  void draw(Workspace& workspace);

 private:
  void draw_list(WorldChanges& changes, const Document& document, FileUnit unit);
  void list_rows(const StepGroups& groups, const UndoStack& history);

  std::vector<size_t> rows_;  // positions of the history
  size_t shown_ = 0;          // the position that the list was scrolled to
};

constexpr size_t kMaxRows = 10;

// Formats the memory of the before-images, by which a step is undone at once.
std::string weight_text(const HistoryStep& step) {
  if (step.images() == HistoryStep::Images::kNone) return "pending";
  if (step.images() == HistoryStep::Images::kDiscarded) return "by replay";
  const double kilobytes = static_cast<double>(step.totals().bytes) / 1024;
  return kilobytes < 1000 ? text_of("%.0f kB", kilobytes) : text_of("%.1f MB", kilobytes / 1024);
}

std::string removed_text(const HistoryStep& step, FileUnit unit) {
  return step.totals().removed_area > 0 ? area_label(step.totals().removed_area, unit) : "";
}

template <typename Text>
float widest(const UndoStack& history, const Text& text) {
  float width = 1;
  for (size_t i = 0; i < history.size(); ++i)
    width = std::max(width, ImGui::CalcTextSize(text(history.step(i)).c_str()).x);
  return width;
}

struct Row {
  std::string name;
  std::string removed = {};  // the area that the step removed
  std::string weight = {};
};

bool draw_row(size_t now, size_t position, const Row& row) {
  ImGui::PushID(static_cast<int>(position));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const bool undone = position > now;
  if (position == now) ImGui::PushStyleColor(ImGuiCol_Text, colours::accent());
  if (undone) ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  const std::string label = fitted_label(row.name, ImGui::GetContentRegionAvail().x);
  const bool clicked = ImGui::Selectable(label.c_str(), position == now, ImGuiSelectableFlags_SpanAllColumns);
  mark_last_item("history row", static_cast<int>(position));
  const char* meaning = position == now ? "Current state."
                        : undone        ? "Undone. Click to redo up to this step."
                                        : "Click to undo back to this step; later steps can be redone.";
  tooltip((row.name + ". " + meaning).c_str());
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

// Draws the row of a position of the history. Returns true if it was clicked.
bool draw_step(const UndoStack& history, size_t position, FileUnit unit) {
  if (position == 0) return draw_row(history.position(), 0, {"Original file"});
  const HistoryStep& step = history.step(position - 1);
  return draw_row(history.position(), position,
                  {step_words(history, position - 1, unit), removed_text(step, unit), weight_text(step)});
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

// Steps of some groups share a row, unless the current position is between them.
void HistoryPanel::list_rows(const StepGroups& groups, const UndoStack& history) {
  rows_.clear();
  for (size_t position = 0; position <= history.size(); ++position) {
    if (groups.has_row(position) || position == history.position()) rows_.push_back(position);
  }
}

void HistoryPanel::draw_list(WorldChanges& changes, const Document& document, FileUnit unit) {
  constexpr ImGuiTableFlags kList =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
  const UndoStack& history = document.history();
  list_rows(changes.groups(), history);
  const float height = height_of_rows(std::min(rows_.size(), kMaxRows));
  if (!ImGui::BeginTable("steps", 3, kList, {0, height})) return;
  ImGui::TableSetupColumn("Step", ImGuiTableColumnFlags_WidthStretch);
  const auto removed = [unit](const HistoryStep& step) { return removed_text(step, unit); };
  ImGui::TableSetupColumn("Removed", ImGuiTableColumnFlags_WidthFixed, widest(history, removed));
  ImGui::TableSetupColumn("Weight", ImGuiTableColumnFlags_WidthFixed, widest(history, weight_text));
  draw_rows_in_sight(rows_.size(), [&](size_t row) {
    const size_t position = rows_[row];
    if (draw_step(history, position, unit))
      changes.enqueue("Travel", [&changes, position] { changes.travel_to(position); });
  });
  if (shown_ != history.position()) {
    shown_ = history.position();
    const auto row = std::lower_bound(rows_.begin(), rows_.end(), history.position());
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
    const std::string words =
        step_words(history(), history().position() - (back ? 1 : 0), workspace_.view.frame.unit);
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
