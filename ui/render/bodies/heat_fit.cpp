#include "ui/render/bodies/heat_fit.h"

#include <algorithm>
#include <glm/glm.hpp>

#include "core/base/assert.h"

namespace kerf {

namespace {

// The share of the trace of the matrix that is added to its diagonal, so that rounding decides nothing in
// open directions.
constexpr double kOpenShare = 1e-4;
// How far the temperature of the vertex may lie beyond those of the faces, in the range of these.
constexpr double kMostBeyond = 0.5;

double weight_of(const FaceSample& sample) {
  const double size2 = sample.size * sample.size;
  return 1 / (size2 * size2);
}

struct Mean {
  double weight = 0;
  Vec3 offset{0};  // from the vertex
  std::array<double, 2> temperatures{};
};

Mean mean_of(const Vec3& vertex, std::span<const FaceSample> samples) {
  Mean mean;
  for (const FaceSample& sample : samples) {
    const double weight = weight_of(sample);
    mean.weight += weight;
    mean.offset += weight * (sample.centroid - vertex);
    for (size_t i = 0; i < 2; ++i) mean.temperatures[i] += weight * sample.temperatures[i];
  }
  mean.offset /= mean.weight;
  for (double& temperature : mean.temperatures) temperature /= mean.weight;
  return mean;
}

}  // namespace

std::array<LocalHeat, 2> fit_heat(const Vec3& vertex, std::span<const FaceSample> samples) {
  KERF_ASSERT(!samples.empty() && std::all_of(samples.begin(), samples.end(),
                                              [](const FaceSample& sample) { return sample.size > 0; }));
  const Mean mean = mean_of(vertex, samples);
  glm::dmat3 spread(0);
  std::array<Vec3, 2> moments{Vec3(0), Vec3(0)};
  std::array<double, 2> least = samples[0].temperatures, most = least;
  for (const FaceSample& sample : samples) {
    const Vec3 offset = sample.centroid - vertex - mean.offset;
    const Vec3 weighted = weight_of(sample) * offset;
    spread += glm::outerProduct(offset, weighted);
    for (size_t i = 0; i < 2; ++i) {
      moments[i] += weighted * (sample.temperatures[i] - mean.temperatures[i]);
      least[i] = std::min(least[i], sample.temperatures[i]);
      most[i] = std::max(most[i], sample.temperatures[i]);
    }
  }
  const double trace = spread[0][0] + spread[1][1] + spread[2][2];
  glm::dmat3 inverse(0);
  if (trace > 0) inverse = glm::inverse(spread / trace + glm::dmat3(kOpenShare)) / trace;
  std::array<LocalHeat, 2> fits;
  for (size_t i = 0; i < 2; ++i) {
    const Vec3 gradient = inverse * moments[i];
    const double beyond = kMostBeyond * (most[i] - least[i]);
    fits[i] = {std::clamp(mean.temperatures[i] - glm::dot(gradient, mean.offset), least[i] - beyond,
                          most[i] + beyond),
               gradient};
  }
  return fits;
}

}  // namespace kerf
