#include "ui/window/widgets.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/support/runs.h"

namespace kerf {
namespace {

TEST(Slider, text_is_centred_unless_the_grab_is_there) {
  EXPECT_EQ(room_beside_grab(0, 100, 0, 10, 20).at, 40);
  EXPECT_EQ(room_beside_grab(0, 100, 90, 100, 20).at, 40);
  EXPECT_EQ(room_beside_grab(0, 100, 45, 55, 20).at, 55);
  EXPECT_EQ(room_beside_grab(0, 100, 50, 60, 20).at, 30);
}

TEST(Slider, text_never_overlaps_the_grab) {
  Random random(3);
  for (uint64_t i = 0; i < runs(4'000); ++i) {
    const auto grab = static_cast<float>(random.uniform(0, 90));
    const auto wanted = static_cast<float>(random.uniform(1, 120));
    const SliderRoom room = room_beside_grab(0, 100, grab, grab + 10, wanted);
    const float width = std::min(wanted, room.width);
    EXPECT_GE(room.width, std::min(wanted, 44.9f));
    EXPECT_GE(room.at, 0);
    EXPECT_LE(room.at + width, 100.001f);
    EXPECT_TRUE(room.at + width <= grab + 0.001f || room.at >= grab + 9.999f) << grab << " " << wanted;
  }
}

}  // namespace
}  // namespace kerf
