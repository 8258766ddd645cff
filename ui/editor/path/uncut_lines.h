#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/document/stroke_path.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shared/workspace.h"

struct ImDrawList;

namespace kerf {

// The parts of a stroke that the beam did not cut through: its axis still meets a face there.
struct UncutLine {
  size_t stroke = 0;
  double share = 0;                      // of the duration of the stroke, > 0 .. 1
  std::vector<std::vector<Vec3>> parts;  // points of the surfaces [m]
};

// Returns the strokes with segments along which the axis of the beam meets a face for more than kUncutShare
// of their way; those of a knife, of radius 0, leave nothing uncut. `range`: of the beam [m] for strokes
// without one of their own. One query of the trees per sample, of which a segment has 33.
std::vector<UncutLine> uncut_lines(std::span<const StrokePath> strokes, const Interval& range,
                                   const World& world);

// Marks the lines that the thermal beam left uncut in the last run of strokes, in amber, until the next
// stroke or another change of the world.
class UncutMarks {
 public:
  // Call before strokes are cut as a whole; those of the geometric model or of a knife leave nothing uncut.
  void begin(const Workspace& workspace, std::span<const StrokePath> strokes);
  // Call once per frame: finds the lines when the strokes were cut, and clears them when another stroke
  // begins.
  void update(const Workspace& workspace);
  // Call when the world changes other than by a stroke.
  void clear() { lines_.clear(); }

  size_t size() const { return lines_.size(); }
  // Draw the lines over the viewport, and their shares as rows of a panel.
  void draw(Workspace& workspace, ImDrawList& list) const;
  void draw_list() const;

 private:
  std::vector<StrokePath> strokes_;  // being cut
  size_t position_before_ = 0;       // of the history
  std::vector<UncutLine> lines_;
  size_t revision_ = 0;  // of the document when lines_ were found
};

}  // namespace kerf
