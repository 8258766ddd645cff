#include "ui/editor/files/tour.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(Tour, advances_when_each_step_is_done_and_ends_after_the_last) {
  TourMoment now;
  now.edge = 1;
  Tour tour;
  tour.begin(first_five_minutes(ViewState()), now);
  const std::vector<std::function<void()>> deeds{
      [&] { now.position = 1, now.cuts = true; },
      [&] { now.position = 0; },
      [&] { now.position = 1; },
      [&] { now.eye.x += 1; },
      [&] { now.plays = true, now.clock += 10 * kTicksPerSecond; },
      [&] { now.plays = false; },
      [&] { now.shows_edges = true; },
      [&] { now.edge = 0.5; },
      [&] { now.shows_boxes = true; },
      [&] { now.saved = true; },
  };
  ASSERT_EQ(deeds.size(), tour.count());
  for (size_t i = 0; i < deeds.size(); ++i) {
    ASSERT_TRUE(tour.is_on());
    EXPECT_EQ(tour.at(), i);
    tour.follow(now);
    ASSERT_TRUE(tour.is_on() && tour.at() == i) << "nothing was done: " << tour.step().title;
    deeds[i]();
    tour.follow(now);
    if (i > 0) continue;
    EXPECT_EQ(tour.at(), 0u) << "the stroke is still being cut";
    now.cuts = false;
    tour.follow(now);
  }
  EXPECT_FALSE(tour.is_on());
}

TEST(Tour, can_be_skipped_and_stepped_back) {
  Tour tour;
  EXPECT_FALSE(tour.is_on());
  tour.begin(first_five_minutes(ViewState()), {});
  tour.skip({});
  EXPECT_EQ(tour.at(), 1u);
  tour.go_back({});
  tour.go_back({});
  EXPECT_EQ(tour.at(), 0u) << "nothing lies before the first step";
  for (size_t i = tour.count(); i > 0; --i) tour.skip({});
  EXPECT_FALSE(tour.is_on());
}

TEST(Tour, names_the_bound_keys) {
  ViewState view;
  view.shortcuts = {{"edit.undo", "Ctrl+Backspace"}};
  EXPECT_TRUE(first_five_minutes(view)[1].text.starts_with("Ctrl+Backspace "));
  EXPECT_TRUE(first_five_minutes(ViewState())[1].text.starts_with("\"Undo\" "));
}

TEST(Tour, fits_any_open_document) {
  for (const TourStep& step : first_five_minutes(ViewState()))
    EXPECT_EQ(step.text.find("car"), std::string::npos) << step.text;
}

}  // namespace
}  // namespace kerf
