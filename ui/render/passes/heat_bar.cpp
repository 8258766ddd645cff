#include "ui/render/passes/heat_bar.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "ui/render/passes/heat_ramps.h"

namespace kerf {

namespace {

constexpr double kLabelEvery = 250;  // K
constexpr double kApart = 120;       // K, between a label and that of an end

void fill(int x, int y, int width, int height, const glm::vec3& colour) {
  glScissor(x, y, width, height);
  glClearColor(colour.r, colour.g, colour.b, 0);
  glClear(GL_COLOR_BUFFER_BIT);
}

// Both ends, and round numbers between them.
std::vector<double> labelled(double end) {
  std::vector<double> at{kAmbient, end};
  for (double t = kLabelEvery; t < end - kApart; t += kLabelEvery) {
    if (t > kAmbient + kApart) at.push_back(t);
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
  glEnable(GL_SCISSOR_TEST);
  fill(x - zoom, y - zoom, wide + 2 * zoom, tall + 2 * zoom, glm::vec3(0.043f, 0.051f, 0.063f));
  for (int row = 0; row < tall; ++row) fill(x, y + row, wide, 1, heat_colour((row + 0.5) / tall));
  std::vector<FaceLabel> labels;
  for (const double t : labelled(end)) {
    const double share = (t - kAmbient) / (end - kAmbient);
    const int at = y + static_cast<int>(std::lround(share * (tall - 1)));
    fill(x + wide + zoom, at, 3 * zoom, zoom, glm::vec3(0.6f, 0.65f, 0.71f));
    labels.push_back({static_cast<uint32_t>(std::lround(t)),
                      false,
                      glm::vec2(x + wide + 7 * zoom, std::max(y, at - 3 * zoom)),
                      {}});
  }
  glDisable(GL_SCISSOR_TEST);
  numbers.draw_labels(labels, zoom);
}

}  // namespace kerf
