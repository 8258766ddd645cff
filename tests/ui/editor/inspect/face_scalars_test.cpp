#include "ui/editor/inspect/scalar_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

// A square of four by four cells of 0.25 m, two faces each, in y = 0.
Body sheet() { return make_body("sheet", test::build(test::grid(4, 1))); }

LoadedShading shading_of(const Body& body) {
  const FloatFrame frame = FloatFrame::around(body.loaded.min, body.loaded.max);
  return {frame, std::make_shared<const BaseFaces>(body.mesh, frame)};
}

double middle_x(const Body& body, FaceId f) {
  const Triangle t = body.mesh.triangle(f);
  return (t[0].x + t[1].x + t[2].x) / 3;
}

TEST(FaceScalars, measure_edges_and_angles_of_each_face) {
  const Body body = sheet();
  for (const float edge : face_scalars(body, FaceQuantity::kLongestEdge, nullptr))
    EXPECT_NEAR(edge, 0.25 * std::sqrt(2.0), 1e-6);
  for (const float angle : face_scalars(body, FaceQuantity::kMinAngle, nullptr)) EXPECT_NEAR(angle, 45, 1e-3);
}

TEST(FaceScalars, a_dead_face_has_no_value) {
  Body body = sheet();
  body.mesh.remove_face(FaceId(3));
  for (const FaceQuantity q :
       {FaceQuantity::kLevel, FaceQuantity::kLongestEdge, FaceQuantity::kTemperature}) {
    const FaceScalars values = face_scalars(body, q, nullptr);
    EXPECT_EQ(values.at(3), kNoScalar);
    EXPECT_EQ(std::count(values.begin(), values.end(), kNoScalar), 1);
  }
}

TEST(FaceScalars, a_heated_face_has_its_temperature_and_others_the_ambient) {
  Body body = sheet();
  body.heat.set_energy(body.mesh, FaceId(5), 500);
  const FaceScalars values = face_scalars(body, FaceQuantity::kTemperature, nullptr);
  EXPECT_GT(values.at(5), kAmbient + 1);
  EXPECT_FLOAT_EQ(values.at(6), kAmbient);
}

TEST(FaceScalars, an_uncut_sheet_has_a_border_but_no_rim) {
  const Body body = sheet();
  const LoadedShading loaded = shading_of(body);
  const FaceScalars values = face_scalars(body, FaceQuantity::kRimDistance, &loaded);
  EXPECT_TRUE(std::all_of(values.begin(), values.end(), [](float v) { return v == kNoScalar; }));
}

// The column of cells at the left is taken away: the rim is a line along z.
TEST(FaceScalars, the_rim_distance_is_that_of_the_nearest_corner_in_metres) {
  Body body = sheet();
  const LoadedShading loaded = shading_of(body);
  const double left = body.loaded.min.x, rim = left + 0.25 * (body.loaded.max.x - left);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (middle_x(body, FaceId(f)) < rim) body.mesh.remove_face(FaceId(f));
  }
  const FaceScalars values = face_scalars(body, FaceQuantity::kRimDistance, &loaded);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    double nearest = 1;
    for (const Vec3& p : body.mesh.triangle(FaceId(f))) nearest = std::min(nearest, p.x - rim);
    if (nearest > 0.3) continue;
    EXPECT_NEAR(values[f], nearest, 1e-6) << f;
  }
}

TEST(FaceScalars, labels_use_the_units_of_the_file) {
  EXPECT_EQ(quantity_text(FaceQuantity::kLongestEdge, 2.75, FileUnit::kMillimetre), "2.75 mm");
  EXPECT_EQ(quantity_text(FaceQuantity::kLevel, 3, FileUnit::kMetre), "3");
  EXPECT_EQ(quantity_text(FaceQuantity::kTemperature, 410.2, FileUnit::kMetre), "410 K");
}

}  // namespace
}  // namespace kerf
