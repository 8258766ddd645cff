#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/document/document.h"
#include "core/tree/swept_cylinder.h"
#include "ui/editor/laser/comparison_cut.h"
#include "ui/editor/shared/laser_controls.h"

namespace kerf {

// Measures the largest distance of the rim that the last stroke left in a world from the boundary of the
// volume that its beam swept, at the ends and at three points of each side of the rim. Sides farther away
// than `edge` [m] belong to earlier rims, because the stroke left no longer edges at its rim. Copies what it
// needs of the world. In all O(open sides * moves).
class RimError {
 public:
  // Preconditions: edge > 0; `stroke` begins with BeginStroke.
  RimError(const World& world, const std::vector<Command>& stroke, double edge);

  bool done() const { return next_ == sides_.size(); }
  // Measures the next sides, about a millisecond of work. Precondition: !done().
  void advance();
  // Returns the error of the sides measured so far [m]; nullopt if there is no rim, as in solids, whose cuts
  // are closed by walls.
  std::optional<double> error() const { return error_; }

 private:
  struct Side {
    Vec3 from, to;    // in the frame of its body [m]
    uint32_t sweeps;  // index in sweeps_
  };

  double edge_;
  std::vector<std::vector<SweptCylinder>> sweeps_;  // by body
  std::vector<Side> sides_;
  size_t next_ = 0;
  std::optional<double> error_;
};

// The last stroke cut at five edge lengths with its own scheme and rim, one after the other, with the faces
// that each created and the error of its rim.
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
  // Cuts or measures for about `seconds` while busy. Clears the chart if the stroke is no longer the last one
  // or has another radius, scheme or rim, if it cannot be copied, or if it is recut before the chart is
  // complete. Called once per frame.
  void advance(Document& document, double seconds);
  void clear() { *this = ResolutionChart(); }

  // The finished samples, coarse to fine.
  const std::vector<Sample>& samples() const { return samples_; }

  // Sets the controls to the resolution of a sample.
  void show(double fraction, ResolutionControls& controls) const;

  // Draws the samples in the current panel: faces to the right, errors upwards, both logarithmic. A ring
  // marks the sample of the fraction `current`. Returns the fraction that was clicked.
  std::optional<double> draw(FileUnit unit, std::optional<double> current) const;

 private:
  // The properties of a stroke on which the samples depend; its edge length is not one of them.
  struct Stroke {
    size_t step = 0;    // of the history, without its recuts
    double radius = 0;  // m
    Pattern pattern = Pattern::kVolume;
    Scheme scheme = Scheme::kLongestEdge;
    Rim rim = Rim::kSmooth;
    std::vector<Pose> poses;
    bool is_same(const Stroke& other) const;
  };
  static Stroke last_stroke(const UndoStack& history);

  TwinCut twin_;
  std::vector<Sample> samples_;
  size_t next_ = kFractions.size();
  Stroke stroke_;
  size_t revision_ = 0;          // of the document when stroke_ was the last one
  double seconds_ = 0;           // of cutting, for the next sample
  std::optional<RimError> rim_;  // of the next sample, once it is cut
};

}  // namespace kerf
