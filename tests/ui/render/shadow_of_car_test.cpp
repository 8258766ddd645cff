#include <gtest/gtest.h>

#include "core/document/scene.h"
#include "tests/support/checkout.h"
#include "tests/ui/render/shadow_oracle.h"
#include "tests/ui/render/shadow_scenes.h"

namespace kerf {
namespace {

using test::lamp_at, test::sun_from;

constexpr int kCarWidth = 200, kCarHeight = 150;
constexpr double kMaxLeftOut = 0.25;  // the car is full of thin parts

// A beam that moves from one pose to another.
struct Sweep {
  Pose from, to;
};
Vec3 unit(double x, double y, double z) { return glm::normalize(Vec3(x, y, z)); }

// The car faces +Z, stands on y = 0 and is 1.8 m wide and 4.2 m long.
struct CarCut {
  const char* name;
  std::vector<Sweep> sweeps;
};
const std::vector<CarCut>& car_cuts() {
  static const Vec3 down(0, -1, 0), left(-1, 0, 0);
  static const std::vector<CarCut> cuts{
      {"along its middle", {{{{0.03, 3, -2.6}, down}, {{0.07, 3, 2.6}, down}}}},
      {"across the doors",
       {{{{-1.4, 3, 0.42}, unit(0.06, -1, 0.02)}, {{1.4, 3, 0.3}, unit(-0.02, -1, -0.02)}}}},
      {"through both sides", {{{{3, 0.7, -0.6}, left}, {{3, 0.8, 0.9}, left}}}},
      {"askew", {{{{-1.9, 2.8, 1.7}, unit(0.5, -1, -0.2)}, {{1.2, 2.9, -1.9}, unit(0.1, -1, 0.25)}}}},
      {"its roof and bonnet off",
       {{{{3, 1.18, -1.9}, left}, {{3, 1.16, 1.2}, left}}, {{{-1.3, 3, 1.2}, down}, {{1.3, 3, 1.25}, down}}}},
  };
  return cuts;
}

test::Stage cut_car(const CarCut& cut) {
  auto scene = read_scene(test::checkout() / "assets/meshes/car.obj");
  if (!scene) throw std::runtime_error(scene.error().message);
  scene->world.add(make_body("floor", test::build(test::floor_at(-0.01, 9))));
  test::Stage stage(std::move(scene->world));
  for (const Sweep& s : cut.sweeps) stage.cut(s.from, s.to, 0.02);
  return stage;
}

CameraView eye_at(const Vec3& eye, const Vec3& target, double near) {
  CameraView view = test::shadow_view(eye, target, near);
  view.aspect = static_cast<double>(kCarWidth) / kCarHeight;
  return view;
}

struct Eye {
  const char* where;
  CameraView view;
};
std::vector<Eye> eyes() {
  return {{"outside", eye_at({4.1, 2.0, 5.2}, {0, 0.55, 0.05}, 0.5)},
          {"inside the car", eye_at({0.05, 1.0, -0.35}, {0.5, 0.6, 0.9}, 0.15)},
          {"in its shadow", eye_at({0.45, 0.12, 0.2}, {2.6, 0.15, 2.2}, 0.03)},
          {"with its near plane through a door", eye_at({1.35, 0.9, 0.5}, {0, 0.55, 0.1}, 0.6)}};
}

TEST(ShadowOfCar, is_correct_for_any_cut_eye_and_light) {
  size_t pixels = 0, shadowed = 0;
  for (const CarCut& cut : car_cuts()) {
    test::Stage stage = cut_car(cut);
    for (const Light& light : {sun_from({-0.42, 1.0, 0.62}), lamp_at({1.3, 2.6, 1.9})}) {
      for (const Eye& eye : eyes()) {
        const test::ShadowVerdict v =
            test::ShadowTrial(stage, light, eye.view, kCarWidth, kCarHeight).robust();
        SCOPED_TRACE(std::string("cut ") + cut.name + ", eye " + eye.where + ": " + v.summary());
        EXPECT_GT(v.hit, 15'000u);
        EXPECT_GE(static_cast<double>(v.same_face), 0.995 * static_cast<double>(v.hit));
        EXPECT_LE(static_cast<double>(v.left_out), kMaxLeftOut * static_cast<double>(v.hit));
        EXPECT_EQ(v.wrong, 0u);
        EXPECT_EQ(v.miscounted, 0u);
        pixels += v.hit;
        shadowed += v.in_shadow;
      }
    }
  }
  EXPECT_GT(shadowed, pixels / 10);
}

}  // namespace
}  // namespace kerf
