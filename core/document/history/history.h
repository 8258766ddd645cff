#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/document/history/history_step.h"

namespace kerf {

// The timeline of a document: the steps before its position are done, those from the position on were undone.
// The before-images of steps are kept within a limit of memory, the window; the oldest are discarded first.
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

  // Adds a step at the position and drops the steps that were undone.
  void append(HistoryStep step);
  void drop_undone() { steps_.resize(position_); }
  // Takes the undone steps out, and puts such steps in place of those that are undone.
  std::vector<std::unique_ptr<HistoryStep>> take_undone();
  void put_undone(std::vector<std::unique_ptr<HistoryStep>> steps);
  void back() { --position_; }
  void forth() { ++position_; }
  // Forgets what the steps after this one did, so that they can only be redone by executing their commands.
  void forget_behind(size_t step);

  // Whether a step is a stroke or a recut of one.
  bool cuts(size_t step) const;
  // The stroke itself, or for a recut the stroke that it cuts again.
  size_t base_of(size_t step) const;
  // Whether a step is a stroke or a recut whose effect a later recut took back.
  bool is_cut_again(size_t step) const;
  // The last step before the position that is a stroke or a recut.
  std::optional<size_t> last_cut() const;
  // The settings of the last stroke before the position, with which it was cut last, and its commands so far.
  // Precondition: last_cut().
  const CutSettings& last_settings() const { return settings_of(*last_cut()); }
  const std::vector<Command>& last_stroke() const { return step(base_of(*last_cut())).commands(); }
  // The settings with which a step cuts. Precondition: cuts(step).
  const CutSettings& settings_of(size_t step) const;
  // The commands that reproduce the effect of a step. For a recut these are the commands of the stroke with
  // the settings of the recut, followed by the time that passed after the stroke and after each recut.
  std::vector<Command> commands_of(size_t step) const;
  // Sums over the strokes before the position: their number, the faces they removed, and the area (m^2) and
  // the mass (kg) of these.
  size_t strokes() const;
  size_t removed_faces() const;
  double removed_area() const;
  double removed_mass() const;

  // The faces that the last stroke before the position removed (see HistoryStep::cut_faces), by the ids that
  // the bodies have at the position; a body that a later step removed is listed, too. Empty without a stroke.
  CutFaces last_cut_faces() const;

  // Whether the before-images of all steps first .. end - 1 are kept.
  bool holds_images(size_t first, size_t end) const;
  // Whether any of the steps first .. end - 1 has been begun, i.e. may have changed the world.
  bool any_begun(size_t first, size_t end) const;

  // The slots of bodies that the world had before the first of the steps first .. end - 1 of which images are
  // held; 0 without one.
  size_t slots_before(size_t first, size_t end) const;

  // The limit for the before-images, in bytes; with 0 none are recorded.
  size_t window() const { return window_; }
  void set_window(size_t bytes);
  size_t bytes() const;
  // Discards before-images, the oldest first, until they are within the window; and the faces that the oldest
  // steps cut, until at most kMostCutFaces are kept besides those of the latest step.
  static constexpr size_t kMostCutFaces = 500'000;
  void trim();

 private:
  void trim_cut_faces();

  std::vector<std::unique_ptr<HistoryStep>> steps_;
  size_t position_ = 0;
  size_t window_ = size_t{1} << 30;
};

}  // namespace kerf
