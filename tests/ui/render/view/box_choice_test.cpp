#include "ui/render/view/view_options.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace kerf {
namespace {

const glm::mat4 kView = glm::perspective(1.0f, 1.5f, 0.01f, 100.0f);

BoxLine box_at(glm::vec3 middle, float size, bool hit = false) {
  return {middle - 0.5f * size, middle + 0.5f * size, {hit ? 1 : 0, 1}};
}

std::vector<float> depths(const std::vector<BoxLine>& boxes) {
  std::vector<float> z;
  for (const BoxLine& b : boxes) z.push_back(-0.5f * (b.low.z + b.high.z));
  return z;
}

TEST(ChooseBoxes, selects_the_largest_on_screen) {
  const std::vector boxes{box_at({0, 0, -20}, 1), box_at({0, 0, -5}, 1), box_at({0, 0, -10}, 1)};
  EXPECT_EQ(depths(select_boxes(boxes, kView, 2)), (std::vector<float>{5, 10}));
}

TEST(ChooseBoxes, excludes_boxes_outside_the_view_and_behind_the_eye) {
  const std::vector boxes{box_at({0, 0, 5}, 1), box_at({30, 0, -5}, 1), box_at({0, -30, -5}, 1),
                          box_at({0, 0, -5}, 1)};
  EXPECT_EQ(depths(select_boxes(boxes, kView, 9)), (std::vector<float>{5}));
}

TEST(ChooseBoxes, includes_the_box_that_contains_the_eye) {
  const std::vector boxes{box_at({0, 0, 0}, 50)};
  EXPECT_EQ(select_boxes(boxes, kView, 9).size(), 1u);
}

TEST(ChooseBoxes, prefers_boxes_hit_by_the_beam) {
  const std::vector boxes{box_at({0, 0, -5}, 1), box_at({0, 0, -10}, 1, true)};
  EXPECT_EQ(depths(select_boxes(boxes, kView, 1)), (std::vector<float>{10}));
}

}  // namespace
}  // namespace kerf
