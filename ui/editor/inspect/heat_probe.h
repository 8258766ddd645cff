#pragma once

#include <optional>
#include <vector>

#include "ui/editor/shared/picture/view_state.h"

namespace kerf {

// The temperature of a point over the time of the world: the one that was clicked last with the tool that
// inspects. The curve goes on while that tool or the temperature view is chosen, and begins anew at another
// click, or where time went back by undo.
class HeatProbe {
 public:
  struct Sample {
    double seconds = 0;  // since the world began
    double temperature = kAmbient;
  };

  // To be called once a frame, at a time at which the world does not change, with the point that was clicked
  // last. `inspects`: the tool is in hand.
  void follow(const World& world, const ViewState& view, const std::optional<Vec3>& clicked, bool inspects);

  const std::vector<Sample>& samples() const { return samples_; }
  const std::optional<Vec3>& at() const { return at_; }

  static constexpr size_t kMostSamples = 2000;

 private:
  void add(const Sample& sample);

  std::optional<Vec3> at_;
  Pose ray_;  // meets the point from in front of it
  std::vector<Sample> samples_;
};

// Draws the curve in the lower right corner of the picture, once it has two samples.
void draw_heat_probe(const HeatProbe& probe, const Area& picture);

}  // namespace kerf
