#include "core/mesh/files/mesh_format.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace kerf {
namespace {

constexpr FileFrame kGame = {FileUnit::kMetre, UpAxis::kY};
constexpr FileFrame kCad = {FileUnit::kMillimetre, UpAxis::kZ};

TEST(FileFrame, treats_a_3d_print_as_millimetres_with_z_up) {
  EXPECT_EQ(guess_frame(MeshFormat::kStl, {-7.5, -12, 0}, {7.5, 25, 9.5}), kCad);
  EXPECT_EQ(guess_frame(MeshFormat::kStl, {-22.9, -22.9, -28}, {22.9, 22.9, 13}), kCad);
}

TEST(FileFrame, treats_a_game_model_as_metres_with_y_up) {
  EXPECT_EQ(guess_frame(MeshFormat::kObj, {-1.4, 0.001, -2.43}, {1.4, 2.58, 2.44}), kGame);
  EXPECT_EQ(guess_frame(MeshFormat::kPly, {-0.095, 0.033, -0.062}, {0.061, 0.187, 0.059}), kGame);
}

TEST(FileFrame, infers_the_unit_of_a_car_from_its_length) {
  for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kPly, MeshFormat::kOff}) {
    EXPECT_EQ(guess_frame(format, {-0.9, -0.1, -2.2}, {0.9, 1.4, 2.3}).unit, FileUnit::kMetre);
    EXPECT_EQ(guess_frame(format, {-90, -10, -220}, {90, 140, 230}).unit, FileUnit::kCentimetre);
    EXPECT_EQ(guess_frame(format, {-900, -100, -2200}, {900, 1400, 2300}).unit, FileUnit::kMillimetre);
  }
}

TEST(FileFrame, treats_a_small_stl_as_metres) {
  EXPECT_EQ(guess_frame(MeshFormat::kStl, {-0.4, -0.3, -0.1}, {0.4, 0.3, 0.2}).unit, FileUnit::kMetre);
}

TEST(FileFrame, infers_the_up_axis_from_the_side_that_touches_the_ground) {
  for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kPly, MeshFormat::kStl, MeshFormat::kOff}) {
    EXPECT_EQ(guess_frame(format, {-1, 0, -1}, {1, 2, 1}).up, UpAxis::kY);
    EXPECT_EQ(guess_frame(format, {-1, -1, 0}, {1, 1, 2}).up, UpAxis::kZ);
  }
  EXPECT_EQ(guess_frame(MeshFormat::kStl, {0, 0, 0}, {1, 1, 1}).up, UpAxis::kZ) << "a corner at the origin";
  EXPECT_EQ(guess_frame(MeshFormat::kObj, {0, 0, 0}, {1, 1, 1}).up, UpAxis::kY) << "a corner at the origin";
  EXPECT_EQ(guess_frame(MeshFormat::kObj, {0, 1, 0}, {1, 2, 0}).up, UpAxis::kY) << "flat: it does not stand";
}

TEST(FileFrame, makes_a_guess_for_every_box) {
  constexpr uint64_t kSeed = 16;
  SCOPED_TRACE(kSeed);
  Random random(kSeed);
  for (int i = 0; i < 1000; ++i) {
    const auto format = static_cast<MeshFormat>(random.below(4));
    Vec3 min, max;
    double scale = 1e-30;
    for (uint64_t n = random.below(60); n > 0; --n) scale *= 10;
    for (int axis = 0; axis < 3; ++axis) {
      min[axis] = random.below(3) == 0 ? 0 : scale * random.uniform(-1, 1);
      max[axis] = min[axis] + (random.below(3) == 0 ? 0 : scale * random.unit());
    }
    const FileFrame guess = guess_frame(format, min, max);
    EXPECT_GT(metres_per_unit(guess.unit), 0);
    EXPECT_NE(guess.unit, FileUnit::kInch) << "nothing speaks for inches";
    EXPECT_FALSE(unit_symbol(guess.unit).empty());
  }
}

TEST(FileFrame, rotates_z_up_to_y_up_and_keeps_handedness) {
  EXPECT_EQ(to_y_up({0, 0, 1}, UpAxis::kZ), Vec3(0, 1, 0));
  EXPECT_EQ(to_y_up({1, 2, 3}, UpAxis::kY), Vec3(1, 2, 3));
  const Vec3 a(1, 2, 3), b(-4, 5, 0.5);
  EXPECT_EQ(glm::cross(to_y_up(a, UpAxis::kZ), to_y_up(b, UpAxis::kZ)),
            to_y_up(glm::cross(a, b), UpAxis::kZ));
}

TEST(FileFrame, conversion_to_y_up_and_back_is_exact_and_keeps_heights) {
  const Vec3 v(0.1, -2.7, 1e17);
  for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
    EXPECT_EQ(from_y_up(to_y_up(v, up), up), v);
    EXPECT_EQ(height_of(v, up), to_y_up(v, up).y);
  }
}

}  // namespace
}  // namespace kerf
