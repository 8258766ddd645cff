#include <gtest/gtest.h>

#include <cmath>

#include "core/game/angle.h"
#include "core/game/match/rules.h"
#include "core/game/vehicle/vehicle_file.h"
#include "tests/support/checkout.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

// The text with one part replaced, which must be there.
std::string with(std::string text, const std::string& part, const std::string& other) {
  const size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return at == std::string::npos ? text : text.replace(at, part.size(), other);
}

struct Wrong {
  const char *part, *other, *said;
};

TEST(VehicleFile, names_the_first_thing_that_is_wrong) {
  const std::string good = R"({"mesh": "car.obj",
    "wheels": [{"part": "wheel", "mount": "axle", "hub": [0, 0.3, 1], "radius": 0.3}],
    "turret": {"part": "turret", "mount": "body", "pivot": [0, 1, 0], "yaw": [-90, 90],
               "barrel": {"part": "barrel", "pivot": [0, 1, 0], "muzzle": [0, 1, 1]}},
    "vital": [{"kind": "engine", "part": "engine"}]})";
  test::TemporaryFolder folder;
  const auto file = folder / "car.json";
  test::write_text(file, good);
  const auto vehicle = read_vehicle(file);
  ASSERT_TRUE(vehicle) << vehicle.error().message;
  EXPECT_NEAR(vehicle->turret.yaw.high, kPi / 2, 1e-12);
  for (const Wrong& w :
       {Wrong{"\"mesh\": \"car.obj\",", "", "needs \"mesh\""},
        Wrong{"0.3, 1]", "0.3]", "/wheels/0/hub: must be three numbers"},
        Wrong{"\"radius\": 0.3", "\"radius\": -1", "/wheels/0/radius: must be from"},
        Wrong{"[-90, 90]", "[90, -90]", "/turret/yaw: must be two angles"},
        Wrong{"\"muzzle\": [0, 1, 1]", "\"muzzle\": [0, 1, 0]", "/turret/barrel/muzzle: must be"},
        Wrong{"\"kind\": \"engine\"", "\"kind\": \"radio\"", "/vital/0/kind: must be \"engine\""},
        Wrong{"}]})", "}]", "this is not JSON"}}) {
    test::write_text(
        file, std::string(w.part) == "}]})" ? good.substr(0, good.size() - 1) : with(good, w.part, w.other));
    const auto bad = read_vehicle(file);
    ASSERT_FALSE(bad) << w.said;
    EXPECT_EQ(bad.error().code, ErrorCode::kBadInput);
    EXPECT_NE(bad.error().message.find(w.said), std::string::npos) << bad.error().message;
    EXPECT_EQ(bad.error().message.find('\n'), std::string::npos);
  }
}

TEST(VehicleFile, a_part_that_the_mesh_does_not_have_is_named) {
  auto vehicle = read_vehicle(test::checkout() / "assets/vehicles/hatchback.json");
  ASSERT_TRUE(vehicle);
  vehicle->wheels[1].part = "balloon";
  const auto model = load_vehicle(*vehicle);
  ASSERT_FALSE(model);
  EXPECT_NE(model.error().message.find("\"balloon\""), std::string::npos) << model.error().message;
}

TEST(RulesFile, names_the_first_thing_that_is_wrong) {
  const std::string good = R"({"arena": "yard.json", "player": "car.json", "waves": [["car.json"]],
    "laser": {"range": 60, "radius": [0.008, 0.03]}, "difficulties": {"easy": {"aim_error": 6}},
    "times": {"match": 300}, "score": {"kill": 5}})";
  test::TemporaryFolder folder;
  const auto file = folder / "rules.json";
  test::write_text(file, good);
  const auto rules = read_rules(file);
  ASSERT_TRUE(rules) << rules.error().message;
  EXPECT_EQ(rules->times.match, 300);
  EXPECT_NEAR(rules->skills[0].aim_error, radians_of(6), 1e-12);
  for (const Wrong& w : {Wrong{"[[\"car.json\"]]", "[[]]", "/waves/0: must name 1 to"},
                         Wrong{"\"arena\": \"yard.json\",", "", "needs \"arena\""},
                         Wrong{"[0.008, 0.03]", "[0, 0.03]", "/laser/radius: must be from"},
                         Wrong{"\"aim_error\": 6", "\"aim_error\": \"low\"", "/difficulties/easy/aim_error"},
                         Wrong{"\"match\": 300", "\"match\": 0", "/times/match: must be from"}}) {
    test::write_text(file, with(good, w.part, w.other));
    const auto bad = read_rules(file);
    ASSERT_FALSE(bad) << w.said;
    EXPECT_NE(bad.error().message.find(w.said), std::string::npos) << bad.error().message;
  }
}

TEST(ArenaFile, starts_must_be_inside) {
  test::TemporaryFolder folder;
  const auto file = folder / "arena.json";
  test::write_text(file, R"({"size": [50, 50], "starts": {"player": {"position": [0, 0, 26]},
    "enemies": [{"position": [0, 0, 1]}]}})");
  const auto arena = read_arena(file);
  ASSERT_FALSE(arena);
  EXPECT_NE(arena.error().message.find("/starts: a start is outside"), std::string::npos)
      << arena.error().message;
}

TEST(Angles, agree_with_the_library) {
  for (double x = -20; x < 20; x += 0.037) {
    EXPECT_NEAR(sin_cos(x).sin, std::sin(x), 1e-13);
    EXPECT_NEAR(sin_cos(x).cos, std::cos(x), 1e-13);
    const double y = x * x - 40;
    EXPECT_NEAR(arc_tangent(y, x), std::atan2(y, x), 1e-13);
    EXPECT_NEAR(heading_of(direction_of(wrapped(x), 0.3)), wrapped(x), 1e-12);
  }
  EXPECT_EQ(arc_tangent(0, 0), 0);
}

}  // namespace
}  // namespace kerf
