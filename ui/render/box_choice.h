#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace kerf {

// A box of the tree as it is drawn: corners in the body's float frame; 1 where the beam was in it, opacity.
struct BoxLine {
  glm::vec3 low, high;
  glm::vec2 style;
};

// Of the boxes that may be in the picture, those that are seen largest, at most so many, the largest first;
// those where the beam was count for larger than they are, for they are what one looks for. A tree has far
// more boxes than a picture can show; from near, the small ones matter, from afar the large ones. O(n) and a
// sort of what is left.
std::vector<BoxLine> choose_boxes(std::span<const BoxLine> boxes, const glm::mat4& clip_from_body,
                                  size_t most);

}  // namespace kerf
