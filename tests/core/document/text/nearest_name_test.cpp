#include "core/document/text/json.h"

#include <gtest/gtest.h>

#include <vector>

namespace kerf {
namespace {

TEST(NearestName, has_the_smallest_edit_distance) {
  const std::vector<std::string> names{"radius", "range", "power", "direction", "pulse_rate"};
  const std::pair<const char*, const char*> nearest[] = {
      {"raduis", "radius"}, {"Range", "range"},  {"POWER", "power"},          {"dir", "direction"},
      {"rnage", "range"},   {"powers", "power"}, {"pulserate", "pulse_rate"}, {"angle", "range"},
      {"", "range"},        {"radius", "radius"}};
  for (const auto& [name, expected] : nearest) EXPECT_EQ(nearest_name(name, names), expected) << name;
}

TEST(NearestName, is_the_first_of_equally_near_names) {
  const std::vector<std::string> names{"ab", "ac", "ad"};
  EXPECT_EQ(nearest_name("ae", names), "ab");
}

TEST(NearestName, is_empty_for_an_empty_list) {
  EXPECT_EQ(nearest_name("a", {}), "");
  EXPECT_EQ(nearest_name_hint("a", {}), "");
}

TEST(NearestName, handles_a_long_name_quickly) {
  const std::vector<std::string> names{"radius", std::string(10'000'000, 'a')};
  EXPECT_EQ(nearest_name(std::string(10'000'000, 'a'), names), names[1]);
}

}  // namespace
}  // namespace kerf
