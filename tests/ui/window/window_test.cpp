#include "ui/window/window.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(InputEvents, of_one_frame_have_increasing_times_within_it) {
  std::vector<InputEvent> events(4);
  spread_times(events, 2, 3);
  EXPECT_EQ(events[0].seconds, 2.25);
  EXPECT_EQ(events[1].seconds, 2.5);
  EXPECT_EQ(events[2].seconds, 2.75);
  EXPECT_EQ(events[3].seconds, 3);
}

TEST(InputEvents, are_empty_without_input) { spread_times({}, 2, 3); }

}  // namespace
}  // namespace kerf
