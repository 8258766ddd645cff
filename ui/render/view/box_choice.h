#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace kerf {

// A box of the tree to be drawn: its corners in the body's float frame, and in `style` 1 if the beam has hit
// it, and its opacity.
struct BoxLine {
  glm::vec3 low, high;
  glm::vec2 style;
};

// Chooses at most `most` of the boxes that may be visible, those that appear largest, in descending order of
// size. Boxes that the beam has hit count as larger than they are, because the user looks for them. A tree
// has far more boxes than a picture can show; small ones matter from near and large ones from afar. O(n),
// plus sorting of the visible boxes.
std::vector<BoxLine> choose_boxes(std::span<const BoxLine> boxes, const glm::mat4& clip_from_body,
                                  size_t most);

}  // namespace kerf
