#include "ui/render/view/piece_palette.h"

#include <algorithm>
#include <limits>

#include "ui/render/view/oklab.h"

namespace kerf {

namespace {

constexpr double kFirstHue = 120, kLastHue = 350, kHueStep = 10;  // degrees: from green over blue to pink

// What colours are chosen from, and how far each of them is from what is there.
struct Candidate {
  glm::dvec3 lab;
  double apart = std::numeric_limits<double>::infinity();
};

std::vector<Candidate> all_candidates() {
  std::vector<Candidate> all;
  for (double hue = kFirstHue; hue <= kLastHue; hue += kHueStep) {
    for (const double lightness : {0.42, 0.52, 0.62}) {
      for (const double chroma : {0.05, 0.10}) all.push_back({oklab_of(lightness, chroma, hue)});
    }
  }
  return all;
}

void keep_away(std::vector<Candidate>& all, const glm::dvec3& lab) {
  for (Candidate& c : all) c.apart = std::min(c.apart, glm::distance(c.lab, lab));
}

}  // namespace

std::vector<glm::dvec3> piece_palette(std::span<const glm::dvec3> paints, size_t count) {
  std::vector<Candidate> all = all_candidates();
  for (const glm::dvec3& paint : paints) keep_away(all, oklab_from_linear(paint));
  std::vector<glm::dvec3> palette;
  while (palette.size() < count) {
    const glm::dvec3 lab = std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
                             return a.apart < b.apart;
                           })->lab;
    palette.push_back(linear_from_oklab(lab));
    keep_away(all, lab);
  }
  return palette;
}

}  // namespace kerf
