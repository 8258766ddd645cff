#include "ui/editor/laser/stroke_recut.h"

#include <imgui.h>
#include <utility>

namespace kerf {

namespace {

// Returns true if all strokes from .. to - 1 have the same beam radius.
bool share_radius(const UndoStack& history, size_t from, size_t to) {
  const double radius = history.settings_of(from).laser.radius;
  for (size_t i = from + 1; i < to; ++i) {
    if (history.settings_of(i).laser.radius != radius) return false;
  }
  return true;
}

}  // namespace

const char* StrokeRecut::disabled_reason() const {
  const Document& document = workspace_.session.document;
  const auto last_cut = document.history().last_cut();
  if (!last_cut) return "No cut yet.";
  if (document.queue().in_stroke()) return "Finish or cancel the current cut first.";
  const StepGroups::Group* of = group();
  if (of == nullptr && *last_cut + 1 != document.history().position()) return "Undo later changes first.";
  const bool is_kept = of == nullptr || document.history().holds_images(of->from, of->to);
  return is_kept && can_recut(document) ? nullptr : "The undo data of the last cut were discarded.";
}

// Replaces a request that is still queued, and includes its radius.
void StrokeRecut::request(bool radius) {
  const auto queued = queued_.lock();
  const auto with_radius = std::make_shared<const bool>(radius || (queued && *queued));
  workspace_.changes.enqueue("Recut", [this, with_radius] { recut(*with_radius); });
  queued_ = with_radius;
}

void StrokeRecut::request_live(bool radius) {
  if (!workspace_.settings.live_recut || disabled_reason() != nullptr) return;
  if (group() == nullptr) return request(radius);
  waits_ = true;
  waits_with_radius_ = waits_with_radius_ || radius;
}

void StrokeRecut::update() {
  if (!waits_ || ImGui::IsAnyItemActive()) return;
  waits_ = false;
  request(std::exchange(waits_with_radius_, false));
}

// Returns the group that the history ends with if it consists of strokes, otherwise null.
const StepGroups::Group* StrokeRecut::group() const {
  const UndoStack& history = workspace_.session.document.history();
  const StepGroups::Group* group = workspace_.changes.groups().at(history.position(), true);
  if (group == nullptr) return nullptr;
  for (size_t i = group->from; i < group->to; ++i) {
    if (history.step(i).kind() != HistoryStep::Kind::kStroke) return nullptr;
  }
  return group;
}

// Undoes the last stroke and queues it again; its other settings stay. Consecutive recuts share one history
// entry.
void StrokeRecut::recut(bool radius) {
  if (disabled_reason() != nullptr) return;
  if (const StepGroups::Group* of = group()) return recut_group(*of, radius);
  const UndoStack& history = workspace_.session.document.history();
  CutSettings settings = history.last_settings();
  set_resolution(settings, radius);
  std::vector<Command> commands;
  const HistoryStep& last = history.last();
  const bool again = last.kind() == HistoryStep::Kind::kRecut;
  if (again) commands.emplace_back(Undo{});
  commands.emplace_back(Recut{settings});
  // Queue the time again that had passed after the undone recut.
  if (again) commands.insert(commands.end(), last.commands().begin() + 1, last.commands().end());
  workspace_.changes.change("Recut", true, apply_all(std::move(commands)));
  ++workspace_.services.statistics.recuts;
}

// Undoes the strokes of a group and queues them again as a group that replaces it. Uses the current radius
// only if the strokes share one.
void StrokeRecut::recut_group(const StepGroups::Group& group, bool radius) {
  const UndoStack& history = workspace_.session.document.history();
  const size_t from = group.from, to = group.to;
  const std::string name = group.name;
  radius = radius && share_radius(history, from, to);
  std::vector<Command> commands(to - from, Undo{});
  for (size_t i = from; i < to; ++i) {
    std::vector<Command> stroke = history.commands_of(i);
    set_resolution(std::get<BeginStroke>(stroke.front()).settings, radius);
    commands.insert(commands.end(), stroke.begin(), stroke.end());
  }
  workspace_.changes.change("Recut", true, apply_all(std::move(commands)));
  workspace_.changes.groups().add(from, workspace_.session.document, name);
  ++workspace_.services.statistics.recuts;
}

void StrokeRecut::set_resolution(CutSettings& settings, bool radius) const {
  if (radius) settings.laser.radius = workspace_.laser.radius;
  settings.resolution = workspace_.laser.resolution.of(settings.laser.radius);
}

}  // namespace kerf
