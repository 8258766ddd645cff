#include "core/document/history/history.h"

#include <iterator>

#include "core/base/assert.h"

namespace kerf {

using Kind = HistoryStep::Kind;

void History::append(HistoryStep step) {
  drop_undone();
  steps_.push_back(std::make_unique<HistoryStep>(std::move(step)));
  ++position_;
}

std::vector<std::unique_ptr<HistoryStep>> History::take_undone() {
  const auto first = steps_.begin() + static_cast<std::ptrdiff_t>(position_);
  std::vector<std::unique_ptr<HistoryStep>> undone(std::make_move_iterator(first),
                                                   std::make_move_iterator(steps_.end()));
  drop_undone();
  return undone;
}

void History::put_undone(std::vector<std::unique_ptr<HistoryStep>> steps) {
  drop_undone();
  std::move(steps.begin(), steps.end(), std::back_inserter(steps_));
}

void History::forget_behind(size_t step) {
  for (size_t i = step + 1; i < steps_.size(); ++i) steps_[i]->forget();
}

bool History::cuts(size_t i) const {
  return step(i).kind() == Kind::kStroke || step(i).kind() == Kind::kRecut;
}

size_t History::base_of(size_t i) const {
  while (step(i).kind() == Kind::kRecut) --i;
  return i;
}

std::optional<size_t> History::last_cut() const {
  for (size_t i = position_; i-- > 0;) {
    if (cuts(i)) return i;
  }
  return std::nullopt;
}

const CutSettings& History::settings_of(size_t i) const {
  KERF_ASSERT(cuts(i));
  const Command& first = step(i).commands().front();
  if (step(i).kind() == Kind::kRecut) return std::get<Recut>(first).settings;
  return std::get<BeginStroke>(first).settings;
}

std::vector<Command> History::commands_of(size_t i) const {
  const size_t base = base_of(i);
  std::vector<Command> all = step(base).commands();
  if (i > base) std::get<BeginStroke>(all.front()).settings = settings_of(i);
  for (size_t again = base + 1; again <= i; ++again) {
    const std::vector<Command>& its = step(again).commands();
    all.insert(all.end(), its.begin() + 1, its.end());
  }
  return all;
}

size_t History::strokes() const {
  size_t strokes = 0;
  for (size_t i = 0; i < position_; ++i) strokes += step(i).kind() == Kind::kStroke;
  return strokes;
}

bool History::is_cut_again(size_t i) const { return i + 1 < position_ && step(i + 1).kind() == Kind::kRecut; }

size_t History::removed_faces() const {
  size_t faces = 0;
  for (size_t i = 0; i < position_; ++i) faces += is_cut_again(i) ? 0 : step(i).removed_faces();
  return faces;
}

double History::removed_area() const {
  double area = 0;
  for (size_t i = 0; i < position_; ++i) area += is_cut_again(i) ? 0 : step(i).removed_area();
  return area;
}

double History::removed_mass() const {
  double mass = 0;
  for (size_t i = 0; i < position_; ++i) mass += is_cut_again(i) ? 0 : step(i).removed_mass();
  return mass;
}

bool History::holds_images(size_t first, size_t end) const {
  for (size_t i = first; i < end; ++i) {
    if (step(i).images() == HistoryStep::Images::kLetGo) return false;
  }
  return true;
}

bool History::any_begun(size_t first, size_t end) const {
  for (size_t i = first; i < end; ++i) {
    if (!step(i).waiting()) return true;
  }
  return false;
}

size_t History::slots_before(size_t first, size_t end) const {
  for (size_t i = first; i < end; ++i) {
    if (const auto slots = step(i).slots_before()) return *slots;
  }
  return 0;
}

void History::set_window(size_t bytes) {
  window_ = bytes;
  trim();
}

size_t History::bytes() const {
  size_t bytes = 0;
  for (const auto& step : steps_) bytes += step->bytes();
  return bytes;
}

void History::trim() {
  size_t held = bytes();
  for (size_t i = 0; i < steps_.size() && held > window_; ++i) {
    held -= steps_[i]->bytes();
    steps_[i]->let_go();
  }
  trim_cut_faces();
}

void History::trim_cut_faces() {
  size_t kept = 0;
  for (size_t i = steps_.size(); i-- > 0;) {
    if (kept > kMostCutFaces) steps_[i]->let_go_cut_faces();
    kept += steps_[i]->cut_faces_kept();
  }
}

CutFaces History::last_cut_faces() const {
  const std::optional<size_t> last = last_cut();
  CutFaces faces;
  if (!last) return faces;
  for (const auto& [cut_in, cut] : step(*last).cut_faces()) {
    BodyId id = cut_in;
    for (size_t i = *last + 1; i < position_; ++i) id = step(i).id_after_step(id);
    faces[id] = cut;
  }
  return faces;
}

}  // namespace kerf
