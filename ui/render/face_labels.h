#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/ids.h"

namespace kerf {

// A face that could be numbered, as it is seen.
struct LabelCandidate {
  FaceId face;
  FaceId base;                         // the face as loaded that it lies in
  int body = 0;                        // a number of it, as the caller counts
  bool removed = false;                // it is no more
  std::array<glm::vec2, 3> corners{};  // pixels from the lower left of the picture
  float depth = 0;                     // any measure that grows away from the eye

  glm::vec2 middle() const { return (corners[0] + corners[1] + corners[2]) / 3.0f; }
};

// A number in the picture.
struct FaceLabel {
  uint32_t number = 0;
  bool removed = false;
  glm::vec2 at{0};    // its lower left corner, whole pixels
  glm::vec2 size{0};  // pixels
};

// The size of a number of so many digits: one digit's, pixels.
struct DigitShape {
  float width = 6, height = 10;
};

// Chooses the numbers that can be read: nearest first, each within the picture, on a face that holds it and
// of which `seen` says that it is what shows at its middle, none on another. O(n log n).
std::vector<FaceLabel> place_labels(std::vector<LabelCandidate> candidates, glm::ivec2 picture,
                                    const DigitShape& digit,
                                    const std::function<bool(const LabelCandidate&)>& seen);

}  // namespace kerf
