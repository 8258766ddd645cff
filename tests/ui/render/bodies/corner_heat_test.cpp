#include "ui/render/bodies/face_buffer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/packing.hpp>
#include <map>

#include "core/base/random.h"
#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

double kelvin(uint16_t mark) { return mark == 0 ? kAmbient : mark * kHeatUnit; }

// Gives the face this temperature (K), below the transition.
void heat_to(Body& body, FaceId f, double temperature) {
  const Substance& s = body.sheet.substance;
  const double mass = triangle_area(body.mesh.triangle(f)) * body.sheet.thickness * s.density;
  body.heat.set_energy(body.mesh, f, mass * enthalpy_at(s, temperature));
  body.heat.record_hottest(body.mesh, f, temperature);
}

TEST(CornerHeat, is_empty_for_a_body_that_was_never_hot) {
  const Body body = make_body("grid", test::build(test::grid(8, 1)));
  CornerHeat heat;
  std::vector<FaceId> affected;
  heat.update(body, 1, {}, affected);
  EXPECT_FALSE(heat.any());
  EXPECT_TRUE(affected.empty());
}

Vec3 centroid(const Triangle& t) { return (t[0] + t[1] + t[2]) / 3.0; }

// The highest temperature that is drawn at a point of a face, given by its barycentric coordinates.
double drawn_hottest(const Mesh& mesh, const CornerHeat& heat, FaceId f, const Vec3& weights) {
  const Triangle t = mesh.triangle(f);
  const Vec3 p = weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2];
  double sum = 0, straight = 0, noted = 0;
  for (int i = 0; i < 3; ++i) {
    const CornerTemperature corner = heat.of(mesh, f)[static_cast<size_t>(i)].hottest;
    Vec3 gradient;
    for (int k = 0; k < 3; ++k)
      gradient[k] = kHeatGradientUnit * glm::unpackHalf1x16(corner.gradient[static_cast<size_t>(k)]);
    straight += weights[i] * kelvin(corner.at);
    if (corner.at == 0) continue;
    noted += weights[i];
    sum += weights[i] * (kelvin(corner.at) + glm::dot(gradient, p - t[static_cast<size_t>(i)]));
  }
  return noted > 0 ? std::max(kAmbient, std::min(sum / noted, straight)) : kAmbient;
}

TEST(CornerHeat, reproduces_a_linear_field_on_faces_of_different_sizes) {
  Random random(6);
  Body body = make_body("grid", test::build(test::grid(6, 1)));
  std::vector<Mesh::FaceSplit> splits;
  for (int i = 0; i < 60; ++i) {
    const FaceId f(static_cast<uint32_t>(random.below(body.mesh.face_slots())));
    body.mesh.split_edge(f, body.mesh.corners(f)[0], body.mesh.corners(f)[1], splits);
  }
  const auto linear = [](const Vec3& p) { return 900 + 500 * p.x - 300 * p.z; };
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f)
    heat_to(body, FaceId(f), linear(centroid(body.mesh.triangle(FaceId(f)))));
  CornerHeat heat;
  std::vector<FaceId> affected;
  heat.update(body, 1, {}, affected);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const Vec3 middle = centroid(body.mesh.triangle(FaceId(f)));
    if (std::max(std::abs(middle.x), std::abs(middle.z)) > 0.3) continue;  // corners have few faces there
    EXPECT_NEAR(drawn_hottest(body.mesh, heat, FaceId(f), Vec3(1 / 3.0)), linear(middle), 8) << f;
  }
}

// Faces keep their highest temperatures from 500 K on; the line at which they end is drawn where the
// temperature falls to that, and not where the faces begin that kept none.
TEST(CornerHeat, ends_along_a_straight_line_on_any_faces) {
  constexpr int kCells = 12, kSamples = 40;
  constexpr double kCell = 1.0 / kCells, kTintedFrom = 500;
  Random random(8);
  Body body = make_body("grid", test::build(test::grid(kCells, 1)));
  for (uint32_t v = 0; v < body.mesh.vertex_slots(); ++v) {
    const Vec3 p = body.mesh.position(VertexId(v));
    body.mesh.move_vertex(VertexId(v),
                          p + 0.25 * kCell * Vec3(random.uniform(-1, 1), 0, random.uniform(-1, 1)));
  }
  const auto falling = [](const Vec3& p) { return kTintedFrom - 800 * (p.x + 0.3 * p.z); };
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const double there = falling(centroid(body.mesh.triangle(FaceId(f))));
    if (there > kTintedFrom) body.heat.record_hottest(body.mesh, FaceId(f), there);
  }
  CornerHeat heat;
  std::vector<FaceId> affected;
  heat.update(body, 1, {}, affected);
  double wrong = 0;  // m^2, on the wrong side of the line
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const Triangle t = body.mesh.triangle(FaceId(f));
    for (int i = 0; i < kSamples; ++i) {
      Vec3 weights(random.unit(), random.unit(), random.unit());
      weights /= weights.x + weights.y + weights.z;
      const Vec3 p = weights.x * t[0] + weights.y * t[1] + weights.z * t[2];
      if (std::abs(p.z) > 0.35) continue;  // corners have few faces at the border
      const bool drawn = drawn_hottest(body.mesh, heat, FaceId(f), weights) > kTintedFrom;
      if (drawn != (falling(p) > kTintedFrom)) wrong += triangle_area(t) / kSamples;
    }
  }
  EXPECT_LT(wrong / 0.7, 0.2 * kCell) << "beside 0.7 m of the line, in the mean";
}

// A strip along x whose edge z = 0 is a hot rim; beside it, faces reach far away from it.
Body hot_strip_beside_long_faces(double width, double reach, int cells) {
  Soup soup;
  const std::array<double, 6> rows{0, 0.25 * width, 0.5 * width, 0.75 * width, width, reach};
  for (const double z : rows) {
    for (int i = 0; i <= cells; ++i) soup.positions.push_back({0.25 * width * i, 0, z});
  }
  const auto columns = static_cast<uint32_t>(cells + 1);
  for (uint32_t row = 0; row + 1 < rows.size(); ++row) {
    for (uint32_t i = 0; i + 1 < columns; ++i) {
      const uint32_t a = row * columns + i, b = a + columns;
      soup.triangles.push_back({a, a + 1, b});
      soup.triangles.push_back({b, a + 1, b + 1});
    }
  }
  soup.faces_in_file = soup.triangles_in_file = soup.triangles.size();
  Body body = make_body("strip", test::build(soup));
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const double z = centroid(body.mesh.triangle(FaceId(f))).z;
    if (z < 1.2 * width) heat_to(body, FaceId(f), 293 + 1500 * (1 - z / (1.2 * width)));
  }
  return body;
}

TEST(CornerHeat, of_a_large_face_at_a_hot_region_ends_like_that_of_small_faces) {
  constexpr double kWidth = 1, kReach = 40;
  const Body body = hot_strip_beside_long_faces(kWidth, kReach, 40);
  CornerHeat heat;
  std::vector<FaceId> affected;
  heat.update(body, 1, {}, affected);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const Triangle t = body.mesh.triangle(FaceId(f));
    for (int i = 0; i <= 60; ++i) {
      for (int k = 0; i + k <= 60; ++k) {
        const Vec3 weights(i / 60.0, k / 60.0, (60 - i - k) / 60.0);
        const Vec3 p = weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2];
        if (p.x < kWidth || p.x > 9 * kWidth) continue;
        const double drawn = drawn_hottest(body.mesh, heat, FaceId(f), weights);
        if (p.z > 2 * kWidth) {
          ASSERT_LT(drawn, 440) << f << " at " << p.z;
        }
        if (p.z < 0.5 * kWidth) {
          ASSERT_NEAR(drawn, 293 + 1500 * (1 - p.z / (1.2 * kWidth)), 60) << f;
        }
      }
    }
  }
}

TEST(CornerHeat, is_equal_from_both_sides_of_an_edge) {
  Random random(9);
  Body body = make_body("grid", test::build(test::grid(8, 1)));
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) heat_to(body, FaceId(f), random.uniform(293, 1700));
  CornerHeat heat;
  std::vector<FaceId> affected;
  heat.update(body, 1, {}, affected);
  std::map<uint32_t, HeatMark> marks;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    for (size_t i = 0; i < 3; ++i) {
      const auto [at, is_new] =
          marks.try_emplace(body.mesh.corners(FaceId(f))[i].index, heat.of(body.mesh, FaceId(f))[i]);
      EXPECT_EQ(at->second, heat.of(body.mesh, FaceId(f))[i]);
    }
  }
}

TEST(CornerHeat, keeps_the_tint_of_cooled_faces_until_undo) {
  Body body = make_body("grid", test::build(test::grid(8, 1)));
  const FaceId hot(40);
  heat_to(body, hot, 1200);
  CornerHeat heat;
  std::vector<FaceId> affected;
  heat.update(body, 1, {}, affected);
  body.heat.set_energy(body.mesh, hot, 0);
  heat.update(body, 1, {}, affected);
  EXPECT_EQ(heat.of(body.mesh, hot)[0].now, CornerTemperature());
  EXPECT_GT(heat.of(body.mesh, hot)[0].hottest.at, 0);
  body.mesh.columns().set(body.heat.hottest, hot, 0.0f);
  heat.update(body, 1, {}, affected);
  EXPECT_EQ(heat.of(body.mesh, hot)[0], HeatMark());
}

// Changes a body at random, and appends the corners of faces that came, went or changed.
void change(Body& body, Random& random, std::vector<VertexId>& changed) {
  const FaceId f(static_cast<uint32_t>(random.below(body.mesh.face_slots())));
  if (!body.mesh.is_live(f)) return;
  const auto note = [&](FaceId face) {
    const auto corners = body.mesh.corners(face);
    changed.insert(changed.end(), corners.begin(), corners.end());
  };
  const VertexId v = body.mesh.corners(f)[0];
  std::vector<Mesh::FaceSplit> splits;
  Mesh::Star star;
  switch (random.below(12)) {
    case 0:
    case 1:
      note(f);
      return body.mesh.remove_face(f);
    case 2:
      body.mesh.split_edge(f, v, body.mesh.corners(f)[1], splits);
      for (const Mesh::FaceSplit& split : splits) {
        note(split.kept);
        note(split.added);
      }
      return;
    case 3:
      body.mesh.star(v, star);
      for (const FaceId at : star.faces) note(at);
      return body.mesh.move_vertex(v, body.mesh.position(v) + Vec3(random.uniform(-0.01, 0.01), 0, 0));
    case 4:
      body.sheet.thickness = random.uniform(0.001, 0.003);
      return;
    case 5:
    case 6:
      return body.heat.set_energy(body.mesh, f, 0);
    default:
      return heat_to(body, f, random.uniform(300, 1700));
  }
}

// What follows from change to change must be what a look at the whole body finds.
TEST(CornerHeat, incremental_updates_match_a_rebuild) {
  Random random(11);
  Body body = make_body("grid", test::build(test::grid(12, 1)));
  for (uint32_t f = 0; f < 30; ++f) body.walls.set(body.mesh, FaceId(f), FaceId(40));
  CornerHeat followed;
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(round);
    std::vector<VertexId> changed;
    for (size_t i = random.below(6); i > 0; --i) change(body, random, changed);
    std::vector<FaceId> affected;
    followed.update(body, 1, changed, affected);
    CornerHeat rebuilt;
    rebuilt.update(body, 1, {}, affected);
    EXPECT_EQ(followed.warmest(), rebuilt.warmest());
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f))) continue;
      ASSERT_EQ(followed.of(body.mesh, FaceId(f)), rebuilt.of(body.mesh, FaceId(f))) << f;
    }
  }
}

}  // namespace
}  // namespace kerf
