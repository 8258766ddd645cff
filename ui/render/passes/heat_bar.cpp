#include "ui/render/passes/heat_bar.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "ui/gl/state.h"
#include "ui/render/passes/heat_ramps.h"

namespace kerf {

namespace {

constexpr double kLabelEvery = 250;  // K
constexpr double kLabelSpacing = 120;       // K, between a label and that of an end

// The temperatures (K) with labels: both ends of the scale, and round numbers between them.
std::vector<double> labelled(double end) {
  std::vector<double> at{kAmbient, end};
  for (double t = kLabelEvery; t < end - kLabelSpacing; t += kLabelEvery) {
    if (t > kAmbient + kLabelSpacing) at.push_back(t);
  }
  return at;
}

}  // namespace

double end_of_heat_scale(const World& world) {
  double end = 0;
  for (const BodyId id : world.ids()) end = std::max(end, world.body(id).sheet.substance.transition);
  return end > kAmbient ? end : Substance().transition;
}

void draw_heat_bar(double end, FaceNumbers& numbers, int height) {
  KERF_ASSERT(end > kAmbient);
  const int zoom = 1 + height / 700, wide = 14 * zoom, tall = std::min(200 * zoom, height / 2);
  const int x = 12 * zoom, y = 12 * zoom;
  gl::fill(x - zoom, y - zoom, wide + 2 * zoom, tall + 2 * zoom, {0.043f, 0.051f, 0.063f, 0});
  for (int row = 0; row < tall; ++row)
    gl::fill(x, y + row, wide, 1, glm::vec4(heat_colour((row + 0.5) / tall), 0));
  std::vector<FaceLabel> labels;
  for (const double t : labelled(end)) {
    const double share = (t - kAmbient) / (end - kAmbient);
    const int at = y + static_cast<int>(std::lround(share * (tall - 1)));
    gl::fill(x + wide + zoom, at, 3 * zoom, zoom, {0.6f, 0.65f, 0.71f, 0});
    labels.push_back({static_cast<uint32_t>(std::lround(t)),
                      false,
                      glm::vec2(x + wide + 7 * zoom, std::max(y, at - 3 * zoom)),
                      {}});
  }
  numbers.draw_labels(labels, zoom);
}

}  // namespace kerf
