#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/document/history_step.h"

namespace kerf {

// The timeline of a document: its steps up to where it is, and behind those the ones that were undone.
// Before-images are held as far as a window of memory allows; the oldest go first.
class History {
 public:
  size_t position() const { return position_; }
  size_t size() const { return steps_.size(); }
  // Precondition: i < size().
  HistoryStep& step(size_t i) { return *steps_[i]; }
  const HistoryStep& step(size_t i) const { return *steps_[i]; }
  // The step before the position. Precondition: position() > 0.
  HistoryStep& last() { return *steps_[position_ - 1]; }
  const HistoryStep& last() const { return *steps_[position_ - 1]; }

  // A new step at the position; those that were undone are gone.
  void append(HistoryStep step);
  void drop_undone() { steps_.resize(position_); }
  void back() { --position_; }
  void forth() { ++position_; }
  // Steps behind this one can only be done again by their commands.
  void forget_behind(size_t step);

  // Whether a step is a stroke, or one cut again.
  bool cuts(size_t step) const;
  // The stroke that a step is, or cuts again.
  size_t base_of(size_t step) const;
  // The last stroke, or the last time that it was cut again, before the position.
  std::optional<size_t> last_cut() const;
  // The settings of a step that cuts.
  const CutSettings& settings_of(size_t step) const;
  // The commands that do from scratch what the world shows of a step: of a stroke that was cut again, its own
  // with the settings of the recut, and behind them the time that passed after it and after each recut.
  std::vector<Command> commands_of(size_t step) const;
  // Of all strokes before the position: how many they are, the faces that they removed, and their area (m^2).
  size_t strokes() const;
  size_t removed_faces() const;
  double removed_area() const;

  // Whether steps first .. end - 1 can be taken back by their before-images.
  bool holds_images(size_t first, size_t end) const;
  // Whether any of the steps first .. end - 1 has changed the world.
  bool any_begun(size_t first, size_t end) const;

  // Bytes of before-images that are held at most; 0: none are made.
  size_t window() const { return window_; }
  void set_window(size_t bytes);
  size_t bytes() const;
  // Lets images go, the oldest first, until the window holds them.
  void trim();

 private:
  bool is_cut_again(size_t step) const;

  std::vector<std::unique_ptr<HistoryStep>> steps_;
  size_t position_ = 0;
  size_t window_ = size_t{1} << 30;
};

}  // namespace kerf
