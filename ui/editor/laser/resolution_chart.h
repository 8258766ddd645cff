#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/document/document.h"
#include "ui/editor/laser/comparison_cut.h"
#include "ui/editor/shared/laser_controls.h"

namespace kerf {

// Returns the largest distance [m] of the rim that the last stroke left in a world from the boundary of the
// volume that its beam swept, at the ends and at three points of each of its sides; nullopt if there is no
// rim, as in solids, whose cuts are closed by walls. Sides farther away than `edge` [m] belong to earlier
// rims, because the stroke left no longer edges at its rim. Preconditions: edge > 0; `stroke` begins with
// BeginStroke. O(open sides * moves).
std::optional<double> rim_error(const World& world, const std::vector<Command>& stroke, double edge);

// The last stroke cut at five edge lengths, one after the other, with the faces that each created and the
// error of its rim.
class ResolutionChart {
 public:
  static constexpr std::array kFractions{1.0, 0.5, 0.25, 0.125, 0.0625};  // of the radius

  struct Sample {
    double fraction = 1;
    size_t faces = 0;             // created
    double seconds = 0;           // of cutting
    std::optional<double> error;  // m
  };

  // Starts over with the last stroke. Precondition: the document has one.
  void begin(const Document& document);
  bool busy() const { return next_ < kFractions.size(); }
  // Cuts for about `seconds`. Ends if the stroke is no longer the last one, or cannot be copied.
  void advance(Document& document, double seconds);
  void clear() { *this = ResolutionChart(); }

  // The finished samples, coarse to fine.
  const std::vector<Sample>& samples() const { return samples_; }

  // Draws the samples in the current panel: faces to the right, errors upwards, both logarithmic. Returns the
  // fraction that was clicked.
  std::optional<double> draw(double radius, FileUnit unit) const;

 private:
  TwinCut twin_;
  std::vector<Sample> samples_;
  size_t next_ = kFractions.size();
  size_t revision_ = 0;  // of the document
  double seconds_ = 0;   // of cutting, for the next sample
};

}  // namespace kerf
