#include "ui/editor/material/laser_heat_rows.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(Forecast, is_told_with_the_speed_of_the_path_and_without_one) {
  LaserControls laser;
  laser.radius = 0.0001;
  const Sheet sheet;
  EXPECT_NE(forecast_text(laser, sheet, 0, FileUnit::kMetre).find("2000 W cuts this sheet of 1 mm at up to"),
            std::string::npos);
  const std::string with_speed = forecast_text(laser, sheet, 0.02, FileUnit::kMetre);
  EXPECT_NE(with_speed.find("2000 W at 20 mm/s cuts"), std::string::npos) << with_speed;
  EXPECT_NE(with_speed.find("this sheet has 1 mm"), std::string::npos) << with_speed;
}

TEST(Forecast, says_where_the_power_does_not_do_at_any_speed) {
  LaserControls laser;
  laser.radius = 0.01;
  laser.power = 1;
  EXPECT_NE(forecast_text(laser, Sheet(), 0, FileUnit::kMetre).find("does not cut"), std::string::npos);
}

TEST(DepthOfTheStroke, is_told_in_per_cent_where_the_beam_met_something) {
  StepStatistics statistics;
  EXPECT_EQ(depth_text(statistics), "");
  statistics.met_s = 2;
  statistics.depth_s = 2;
  EXPECT_EQ(depth_text(statistics), "The last stroke got 100 % of the way through");
  statistics.depth_s = 0.75;
  EXPECT_EQ(depth_text(statistics), "The last stroke got 38 % of the way through");
}

}  // namespace
}  // namespace kerf
