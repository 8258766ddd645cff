#include "ui/render/passes/surface_overlays.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

LabelCandidate face(uint32_t number, glm::vec2 at, float size, float depth) {
  return {FaceId(number),
          FaceId(number),
          1,
          false,
          {at + glm::vec2(-size, -size), at + glm::vec2(size, -size), at + glm::vec2(0, 2 * size)},
          depth};
}
const auto kAllSeen = [](const LabelCandidate&) { return true; };

TEST(FaceLabels, the_nearer_of_two_overlapping_faces_is_labelled) {
  const auto labels =
      place_labels({face(1, {50, 50}, 30, 9), face(2, {52, 50}, 30, 3)}, {100, 100}, {}, kAllSeen);
  ASSERT_EQ(labels.size(), 1u);
  EXPECT_EQ(labels[0].number, 2u);
}

TEST(FaceLabels, a_face_too_small_for_its_number_has_none) {
  EXPECT_TRUE(place_labels({face(12345, {50, 50}, 8, 1)}, {100, 100}, {}, kAllSeen).empty());
  EXPECT_EQ(place_labels({face(7, {50, 50}, 8, 1)}, {100, 100}, {}, kAllSeen).size(), 1u);
}

TEST(FaceLabels, hidden_faces_take_no_space) {
  const auto second_only = [](const LabelCandidate& c) { return c.face.index == 2; };
  const auto labels =
      place_labels({face(1, {50, 50}, 30, 1), face(2, {50, 50}, 30, 2)}, {100, 100}, {}, second_only);
  ASSERT_EQ(labels.size(), 1u);
  EXPECT_EQ(labels[0].number, 2u);
}

TEST(FaceLabels, never_overlap_and_stay_inside_the_viewport) {
  std::vector<LabelCandidate> many;
  for (uint32_t i = 0; i < 2000; ++i) {
    many.push_back(face(i, {static_cast<float>(i * 37 % 211), static_cast<float>(i * 53 % 157)}, 25,
                        static_cast<float>(i % 13)));
  }
  const auto labels = place_labels(many, {200, 150}, {}, kAllSeen);
  EXPECT_GT(labels.size(), 20u);
  for (size_t i = 0; i < labels.size(); ++i) {
    const glm::vec2 a = labels[i].at, b = a + labels[i].size;
    EXPECT_TRUE(a.x >= 0 && a.y >= 0 && b.x <= 200 && b.y <= 150);
    for (size_t j = 0; j < i; ++j) {
      const glm::vec2 c = labels[j].at, d = c + labels[j].size;
      EXPECT_TRUE(b.x <= c.x || d.x <= a.x || b.y <= c.y || d.y <= a.y);
    }
  }
}

}  // namespace
}  // namespace kerf
