#include "ui/editor/laser/material_rows.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(Forecast, is_shown_with_and_without_a_path_speed) {
  LaserControls laser;
  laser.radius = 0.0001;
  const SheetHit sheet;
  EXPECT_NE(forecast_text(laser, sheet, 0, FileUnit::kMetre).find("2000 W cuts this sheet of 1 mm at up to"),
            std::string::npos);
  const std::string with_speed = forecast_text(laser, sheet, 0.02, FileUnit::kMetre);
  EXPECT_NE(with_speed.find("2000 W at 20 mm/s cuts"), std::string::npos) << with_speed;
  EXPECT_NE(with_speed.find("this sheet is 1 mm"), std::string::npos) << with_speed;
  laser.power = LaserControls::kMaxPower;
  EXPECT_TRUE(forecast_text(laser, sheet, 0, FileUnit::kMetre).starts_with("20000 W cuts"));
}

TEST(Forecast, reports_insufficient_power_at_any_speed) {
  LaserControls laser;
  laser.radius = 0.01;
  laser.power = 1;
  EXPECT_NE(forecast_text(laser, SheetHit(), 0, FileUnit::kMetre).find("too little to cut"),
            std::string::npos);
}

TEST(Forecast, notes_that_units_of_the_file_count_as_metres) {
  LaserControls laser;
  laser.radius = 0.0001;
  for (const double speed : {0.0, 0.02}) {
    const std::string metres = forecast_text(laser, SheetHit(), speed, FileUnit::kMetre),
                      other = forecast_text(laser, SheetHit(), speed, FileUnit::kMillimetre);
    EXPECT_EQ(metres.find("as a metre"), std::string::npos) << metres;
    EXPECT_NE(other.find("treats the unit of this file as a metre"), std::string::npos) << other;
  }
}

TEST(Forecast, is_slower_for_an_oblique_sheet) {
  LaserControls laser;
  laser.radius = 0.0001;
  SheetHit met;
  const double upright = cutting_speed(met.balance(laser.beam()), met.sheet.thickness);
  met.slant = 3;
  const std::string slanted = forecast_text(laser, met, 0, FileUnit::kMetre);
  EXPECT_NE(slanted.find("this sheet of 1 mm (3 mm along the beam) at up to"), std::string::npos) << slanted;
  EXPECT_NEAR(cutting_speed(met.balance(laser.beam()), met.sheet.thickness), upright / 3, 1e-9);
}

TEST(PointerSpeed, reports_whether_it_is_slow_enough) {
  LaserControls laser;
  laser.radius = 0.0001;
  PointerAim aim;
  EXPECT_EQ(pointer_text(laser, aim, FileUnit::kMetre), "");
  aim.speed = 0.02;
  EXPECT_EQ(pointer_text(laser, aim, FileUnit::kMetre),
            "The pointer moves at 20 mm/s, slow enough to cut through");
  aim.speed = 2;
  EXPECT_EQ(pointer_text(laser, aim, FileUnit::kMetre),
            "The pointer moves at 2 m/s, too fast to cut through");
}

TEST(StrokeRemedies, lists_the_sufficient_speed_power_and_radius) {
  StrokeWatch::Crossing crossing;
  crossing.settings.laser.radius = 1e-4;
  crossing.settings.laser.power = 2000;
  crossing.met.sheet.thickness = 0.002;
  crossing.share = 0;
  crossing.speed = 0.135;
  EXPECT_EQ(remedy_text(crossing, FileUnit::kMetre),
            "It would have cut through at 89.8 mm/s instead of 135 mm/s, with 2.5 kW instead of 2 kW, or "
            "with a radius "
            "of 66.5 \xC2\xB5m instead of 100 \xC2\xB5m");
  crossing.speed = 0.05;
  EXPECT_EQ(remedy_text(crossing, FileUnit::kMetre), "");
  crossing.speed = 0.135;
  crossing.share = 1;
  EXPECT_EQ(remedy_text(crossing, FileUnit::kMetre), "");
}

TEST(StrokeRemedies, include_no_power_if_the_sheet_absorbs_nothing) {
  StrokeWatch::Crossing crossing;
  crossing.settings.laser.radius = 1e-4;
  crossing.met.sheet.substance.absorptivity_fibre = 0;
  crossing.share = 0;
  crossing.speed = 0.135;
  EXPECT_EQ(remedy_text(crossing, FileUnit::kMetre), "The sheet does not absorb this beam");
}

TEST(StrokeDepth, is_shown_in_percent_if_the_beam_hit_something) {
  StepStatistics statistics;
  EXPECT_EQ(depth_text(statistics), "");
  statistics.met_s = 2;
  statistics.depth_s = 2;
  EXPECT_EQ(depth_text(statistics), "Last cut reached 100 % depth");
  statistics.depth_s = 0.75;
  EXPECT_EQ(depth_text(statistics), "Last cut reached 38 % depth");
}

}  // namespace
}  // namespace kerf
