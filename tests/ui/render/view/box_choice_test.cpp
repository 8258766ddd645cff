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

TEST(ChooseBoxes, takes_those_that_are_seen_largest) {
  const std::vector boxes{box_at({0, 0, -20}, 1), box_at({0, 0, -5}, 1), box_at({0, 0, -10}, 1)};
  EXPECT_EQ(depths(select_boxes(boxes, kView, 2)), (std::vector<float>{5, 10}));
}

TEST(ChooseBoxes, leaves_out_what_is_beside_or_behind_the_eye) {
  const std::vector boxes{box_at({0, 0, 5}, 1), box_at({30, 0, -5}, 1), box_at({0, -30, -5}, 1),
                          box_at({0, 0, -5}, 1)};
  EXPECT_EQ(depths(select_boxes(boxes, kView, 9)), (std::vector<float>{5}));
}

TEST(ChooseBoxes, keeps_the_one_that_the_eye_is_in) {
  const std::vector boxes{box_at({0, 0, 0}, 50)};
  EXPECT_EQ(select_boxes(boxes, kView, 9).size(), 1u);
}

TEST(ChooseBoxes, prefers_where_the_beam_was) {
  const std::vector boxes{box_at({0, 0, -5}, 1), box_at({0, 0, -10}, 1, true)};
  EXPECT_EQ(depths(select_boxes(boxes, kView, 1)), (std::vector<float>{10}));
}

}  // namespace
}  // namespace kerf
