#include "ui/render/view/box_choice.h"

#include <algorithm>
#include <cstdint>

namespace kerf {

namespace {

constexpr float kHitCounts = 5;  // times as large as it is

struct Seen {
  float size = 0;  // of its diagonal, over its distance
  uint32_t box = 0;
};

// Row of the matrix that gives a coordinate; its first three numbers are as long as one unit of the body is
// there.
glm::vec4 row(const glm::mat4& m, int i) { return {m[0][i], m[1][i], m[2][i], m[3][i]}; }

}  // namespace

std::vector<BoxLine> choose_boxes(std::span<const BoxLine> boxes, const glm::mat4& clip_from_body,
                                  size_t most) {
  const glm::vec4 x = row(clip_from_body, 0), y = row(clip_from_body, 1), w = row(clip_from_body, 3);
  const float unit_x = glm::length(glm::vec3(x)), unit_y = glm::length(glm::vec3(y)),
              unit_w = glm::length(glm::vec3(w));
  std::vector<Seen> seen;
  seen.reserve(boxes.size());
  for (uint32_t i = 0; i < boxes.size(); ++i) {
    const glm::vec4 middle(0.5f * (boxes[i].low + boxes[i].high), 1);
    const float half = 0.5f * glm::length(boxes[i].high - boxes[i].low);
    const float nearest = glm::dot(w, middle) + half * unit_w;
    if (nearest <= 0 || std::abs(glm::dot(x, middle)) - half * unit_x > nearest ||
        std::abs(glm::dot(y, middle)) - half * unit_y > nearest)
      continue;
    const float counts = boxes[i].style.x > 0 ? kHitCounts : 1;
    seen.push_back({counts * half / std::max(nearest - half * unit_w, half * unit_w), i});
  }
  const auto larger = [](const Seen& a, const Seen& b) {
    return a.size != b.size ? a.size > b.size : a.box < b.box;
  };
  const auto end = seen.begin() + static_cast<std::ptrdiff_t>(std::min(most, seen.size()));
  std::partial_sort(seen.begin(), end, seen.end(), larger);
  std::vector<BoxLine> chosen;
  for (auto s = seen.begin(); s != end; ++s) chosen.push_back(boxes[s->box]);
  return chosen;
}

}  // namespace kerf
