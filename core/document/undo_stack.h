#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/assert.h"
#include "core/document/history_step.h"

namespace kerf {

// The history of a document. Steps before the position are done; the step at the position and later ones are
// undone. The window limits the memory of the before-images; the oldest are discarded first.
class UndoStack {
 public:
  using Steps = std::vector<std::unique_ptr<HistoryStep>>;
  // Sums over the strokes before the position: their number, the faces they removed, and the area [m^2] and
  // mass [kg] of these.
  struct Totals {
    size_t strokes = 0, removed_faces = 0;
    double removed_area = 0, removed_mass = 0;
  };

  size_t position() const { return position_; }
  size_t size() const { return steps_.size(); }
  // Precondition: position <= size().
  void set_position(size_t position) {
    KERF_ASSERT(position <= size());
    position_ = position;
  }
  // Precondition: i < size().
  HistoryStep& step(size_t i) {
    KERF_ASSERT(i < size());
    return *steps_[i];
  }
  const HistoryStep& step(size_t i) const {
    KERF_ASSERT(i < size());
    return *steps_[i];
  }
  // Precondition: position() > 0.
  HistoryStep& last() {
    KERF_ASSERT(position_ > 0);
    return *steps_[position_ - 1];
  }
  const HistoryStep& last() const {
    KERF_ASSERT(position_ > 0);
    return *steps_[position_ - 1];
  }

  // Adds a step at the position and drops the steps that were undone.
  void append(HistoryStep step);
  void drop_undone() { steps_.resize(position_); }
  // Remove and return the undone steps, and replace the undone steps by others.
  Steps take_undone();
  void put_undone(Steps steps);
  // Drops the records of the steps after this one, so that they can be redone only by executing their
  // commands.
  void forget_behind(size_t step);

  // Returns true if a step is a stroke or a recut.
  bool cuts(size_t step) const;
  // Returns the stroke itself or, for a recut, the stroke that it cuts again.
  size_t base_of(size_t step) const;
  // Returns true if a step is a stroke or a recut that a later recut replaced.
  bool is_cut_again(size_t step) const;
  // The last stroke or recut before the position.
  std::optional<size_t> last_cut() const;
  // The settings of last_cut(). Precondition: last_cut().
  const CutSettings& last_settings() const {
    const std::optional<size_t> last = last_cut();
    KERF_ASSERT(last.has_value());
    return settings_of(*last);
  }
  // The cut settings of a step. Precondition: cuts(step).
  const CutSettings& settings_of(size_t step) const;
  // Returns the commands that reproduce the effect of a step. For a recut, these are the commands of the
  // stroke with the settings of the recut, followed by the time that passed after the stroke and after each
  // recut.
  std::vector<Command> commands_of(size_t step) const;
  // O(position()).
  Totals totals() const;

  // Returns true if no before-images of the steps first .. end - 1 were discarded.
  bool holds_images(size_t first, size_t end) const;

  // Memory limit of the before-images [bytes]; 0 records none.
  size_t window() const { return window_; }
  void set_window(size_t bytes);
  size_t bytes() const;
  // Discards the oldest before-images until they fit the window, and the cut faces of the oldest steps
  // until at most kMaxCutFaces are kept in addition to those of the latest step.
  static constexpr size_t kMaxCutFaces = 500'000;
  void trim();

 private:
  void trim_cut_faces();

  Steps steps_;
  size_t position_ = 0;
  size_t window_ = size_t{1} << 30;
};

// Returns the faces removed by the last stroke before the position (see HistoryStep::cut_faces), by the ids
// that the bodies have at the position; includes bodies that a later step removed. Empty without a stroke.
CutFaces last_cut_faces(const UndoStack& history);

}  // namespace kerf
