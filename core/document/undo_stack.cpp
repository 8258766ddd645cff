#include "core/document/undo_stack.h"

#include <algorithm>
#include <iterator>

#include "core/base/assert.h"

namespace kerf {

using Kind = HistoryStep::Kind;

void UndoStack::append(HistoryStep step) {
  drop_undone();
  steps_.push_back(std::make_unique<HistoryStep>(std::move(step)));
  ++position_;
}

UndoStack::Steps UndoStack::take_undone() {
  const auto first = steps_.begin() + static_cast<std::ptrdiff_t>(position_);
  Steps undone(std::make_move_iterator(first), std::make_move_iterator(steps_.end()));
  drop_undone();
  return undone;
}

void UndoStack::put_undone(Steps steps) {
  drop_undone();
  std::move(steps.begin(), steps.end(), std::back_inserter(steps_));
}

void UndoStack::forget_behind(size_t step) {
  for (size_t i = step + 1; i < steps_.size(); ++i) steps_[i]->forget();
}

bool UndoStack::cuts(size_t i) const {
  return step(i).kind() == Kind::kStroke || step(i).kind() == Kind::kRecut;
}

size_t UndoStack::base_of(size_t i) const {
  while (step(i).kind() == Kind::kRecut) --i;
  return i;
}

std::optional<size_t> UndoStack::last_cut() const {
  for (size_t i = position_; i-- > 0;) {
    if (cuts(i)) return i;
  }
  return std::nullopt;
}

const CutSettings& UndoStack::settings_of(size_t i) const {
  KERF_ASSERT(cuts(i));
  const Command& first = step(i).commands().front();
  if (step(i).kind() == Kind::kRecut) return std::get<Recut>(first).settings;
  return std::get<BeginStroke>(first).settings;
}

std::vector<Command> UndoStack::commands_of(size_t i) const {
  const size_t base = base_of(i);
  std::vector<Command> all = step(base).commands();
  if (i > base) std::get<BeginStroke>(all.front()).settings = settings_of(i);
  for (size_t again = base + 1; again <= i; ++again) {
    const std::vector<Command>& its = step(again).commands();
    all.insert(all.end(), its.begin() + 1, its.end());
  }
  return all;
}

bool UndoStack::is_cut_again(size_t i) const {
  return i + 1 < position_ && step(i + 1).kind() == Kind::kRecut;
}

UndoStack::Totals UndoStack::totals() const {
  Totals all;
  for (size_t i = 0; i < position_; ++i) {
    all.strokes += step(i).kind() == Kind::kStroke;
    if (is_cut_again(i)) continue;
    all.removed_faces += step(i).totals().removed_faces;
    all.removed_area += step(i).totals().removed_area;
    all.removed_mass += step(i).totals().removed_mass;
  }
  return all;
}

bool UndoStack::holds_images(size_t first, size_t end) const {
  for (size_t i = first; i < end; ++i) {
    if (step(i).images() == HistoryStep::Images::kDiscarded) return false;
  }
  return true;
}

void UndoStack::set_window(size_t bytes) {
  window_ = bytes;
  trim();
}

size_t UndoStack::bytes() const {
  size_t bytes = 0;
  for (const auto& step : steps_) bytes += step->totals().bytes;
  return bytes;
}

void UndoStack::trim() {
  size_t held = bytes();
  for (size_t i = 0; i < steps_.size() && held > window_; ++i) {
    held -= steps_[i]->totals().bytes;
    steps_[i]->drop_before_images();
  }
  trim_cut_faces();
}

void UndoStack::trim_cut_faces() {
  size_t kept = 0;
  for (size_t i = steps_.size(); i-- > 0;) {
    if (kept > kMaxCutFaces) steps_[i]->drop_cut_faces();
    kept += steps_[i]->totals().cut_faces_kept;
  }
}

CutFaces last_cut_faces(const UndoStack& history) {
  const std::optional<size_t> last = history.last_cut();
  CutFaces faces;
  if (!last) return faces;
  for (const auto& [cut_in, cut] : history.step(*last).cut_faces()) {
    BodyId id = cut_in;
    for (size_t i = *last + 1; i < history.position(); ++i) id = id_after(history.step(i).body_changes(), id);
    faces[id] = cut;
  }
  return faces;
}

}  // namespace kerf
