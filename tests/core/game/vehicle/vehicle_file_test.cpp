#include "core/game/vehicle/vehicle_model.h"

#include <gtest/gtest.h>

#include "core/base/deterministic_math.h"
#include "tests/support/changed_text.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

TEST(VehicleFile, names_the_first_error) {
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
  for (const test::Wrong& w :
       {test::Wrong{"\"mesh\": \"car.obj\",", "", "needs \"mesh\""},
        test::Wrong{"0.3, 1]", "0.3]", "/wheels/0/hub: must be three numbers"},
        test::Wrong{"\"radius\": 0.3", "\"radius\": -1", "/wheels/0/radius: must be from"},
        test::Wrong{"[-90, 90]", "[90, -90]", "/turret/yaw: must be two angles"},
        test::Wrong{"\"muzzle\": [0, 1, 1]", "\"muzzle\": [0, 1, 0]", "/turret/barrel/muzzle: must differ"},
        test::Wrong{"\"kind\": \"engine\"", "\"kind\": \"radio\"", "/vital/0/kind: must be \"engine\""},
        test::Wrong{"[{\"kind\": \"engine\", \"part\": \"engine\"}]", "[]",
                    "/vital: must contain at least one part"},
        test::Wrong{"}]})", "}]", "this is not JSON"}}) {
    test::write_text(file, std::string(w.part) == "}]})" ? good.substr(0, good.size() - 1)
                                                         : test::with(good, w.part, w.other));
    const auto bad = read_vehicle(file);
    ASSERT_FALSE(bad) << w.expected;
    EXPECT_EQ(bad.error().code, ErrorCode::kBadInput);
    EXPECT_NE(bad.error().message.find(w.expected), std::string::npos) << bad.error().message;
    EXPECT_EQ(bad.error().message.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace kerf
