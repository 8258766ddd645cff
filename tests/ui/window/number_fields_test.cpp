#include "ui/window/number_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kerf {
namespace {

class NumberEntries : public testing::Test {
 protected:
  NumberEntries() { report_entries_to(&message); }
  ~NumberEntries() override { report_entries_to(nullptr); }

  Message message;
  const NumberEntry radius{"Radius", RealFormat("%.3g "), length_unit("mm"), {0.25, 25}};
};

TEST_F(NumberEntries, take_units_and_arithmetic_without_a_word) {
  EXPECT_DOUBLE_EQ(*radius.entered("1/4 in", 1), 6.35);
  EXPECT_EQ(*radius.entered("2.5 mm", 1), 2.5);
  EXPECT_EQ(*radius.entered("2*3", 1), 6);
  EXPECT_TRUE(message.log.empty());
}

TEST_F(NumberEntries, say_what_they_refuse_and_what_stays) {
  EXPECT_FALSE(radius.entered("abc-5", 1.5).has_value());
  EXPECT_EQ(message.text, "Radius stays 1.5 mm: \"abc\" is not a number");
  EXPECT_TRUE(message.is_error);
  EXPECT_FALSE(radius.entered("1e999", 1.5).has_value());
  EXPECT_EQ(message.text, "Radius stays 1.5 mm: \"1e999\" is too large");
}

TEST_F(NumberEntries, say_that_they_limit_a_value_and_the_change_that_follows_does_not_clear_it) {
  EXPECT_EQ(*radius.entered("1 m", 1), 25);
  EXPECT_EQ(message.text, "Radius is limited to 25 mm, the maximum value");
  message.clear();
  EXPECT_EQ(message.text, "Radius is limited to 25 mm, the maximum value");
  message.clear();
  EXPECT_EQ(message.text, "");
  EXPECT_EQ(*radius.entered("-3", 1), 0.25);
  EXPECT_EQ(message.text, "Radius is limited to 0.25 mm, the minimum value");
}

TEST_F(NumberEntries, refuse_what_has_to_be_positive) {
  const NumberEntry speed{"Speed", RealFormat("%.4g "), length_unit("mm", "/s"), kPositive};
  EXPECT_FALSE(speed.entered("0", 3).has_value());
  EXPECT_EQ(message.text, "Speed stays 3 mm/s: it must be more than 0");
  EXPECT_EQ(*speed.entered("3 m/s", 3), 3000);
}

TEST_F(NumberEntries, read_the_unit_of_their_format) {
  const NumberEntry pace{"Pace", RealFormat("%.3g shots/s")};
  EXPECT_EQ(*pace.entered("4 shots/s", 1), 4);
  const NumberEntry share{"Volume", RealFormat("%.0f %%")};
  EXPECT_EQ(*share.entered("45 %", 1), 45);
  const NumberEntry power{"Power", RealFormat("%.4g W"), kWatts};
  EXPECT_EQ(*power.entered("1.5 kW", 1), 1500);
}

}  // namespace
}  // namespace kerf
