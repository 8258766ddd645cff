#include "ui/render/bodies/face_labels.h"

#include <algorithm>
#include <string>
#include <tuple>

namespace kerf {

namespace {

constexpr int kCell = 2;         // pixels of the grid of taken places
constexpr float kMargin = 3;     // pixels between numbers
constexpr float kWithin = 0.6f;  // of a number's box that its face must hold

float cross(const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; }

bool contains(const std::array<glm::vec2, 3>& t, const glm::vec2& p) {
  const float area = cross(t[1] - t[0], t[2] - t[0]);
  for (size_t i = 0; i < 3; ++i) {
    if (cross(t[(i + 1) % 3] - t[i], p - t[i]) * area < 0) return false;
  }
  return area != 0;
}

bool holds(const LabelCandidate& face, const glm::vec2& size) {
  const glm::vec2 middle = face.middle(), half = size * (0.5f * kWithin);
  for (int i = 0; i < 4; ++i) {
    const glm::vec2 corner(i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y);
    if (!contains(face.corners, middle + corner)) return false;
  }
  return true;
}

// Which places of the picture have a number.
class TakenPlaces {
 public:
  explicit TakenPlaces(glm::ivec2 picture)
      : size_(picture / kCell + 1), taken_(static_cast<size_t>(size_.x) * static_cast<size_t>(size_.y)) {}

  // Takes the box if nothing of it is taken.
  bool take(const glm::vec2& low, const glm::vec2& high) {
    const glm::ivec2 from = glm::clamp(glm::ivec2(low) / kCell, glm::ivec2(0), size_ - 1);
    const glm::ivec2 to = glm::clamp(glm::ivec2(high) / kCell, glm::ivec2(0), size_ - 1);
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) {
        if (taken_[place(x, y)]) return false;
      }
    }
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) taken_[place(x, y)] = true;
    }
    return true;
  }

 private:
  size_t place(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(size_.x) + static_cast<size_t>(x);
  }
  glm::ivec2 size_;
  std::vector<bool> taken_;
};

}  // namespace

std::vector<FaceLabel> place_labels(std::vector<LabelCandidate> candidates, glm::ivec2 picture,
                                    const DigitShape& digit,
                                    const std::function<bool(const LabelCandidate&)>& seen) {
  const auto size_of = [&](const LabelCandidate& c) {
    return glm::vec2(static_cast<float>(std::to_string(c.face.index).size()) * digit.width, digit.height);
  };
  std::erase_if(candidates, [&](const LabelCandidate& c) { return !holds(c, size_of(c)); });
  std::sort(candidates.begin(), candidates.end(), [](const LabelCandidate& a, const LabelCandidate& b) {
    return std::tie(a.depth, a.body, a.face) < std::tie(b.depth, b.body, b.face);
  });
  std::vector<FaceLabel> labels;
  TakenPlaces places(picture);
  for (const LabelCandidate& c : candidates) {
    const glm::vec2 size = size_of(c), low = glm::floor(c.middle() - 0.5f * size), high = low + size;
    if (low.x < 0 || low.y < 0 || high.x >= static_cast<float>(picture.x) ||
        high.y >= static_cast<float>(picture.y)) {
      continue;
    }
    if (!seen(c) || !places.take(low - kMargin, high + kMargin)) continue;
    labels.push_back({c.face.index, c.removed, low, size});
  }
  return labels;
}

}  // namespace kerf
