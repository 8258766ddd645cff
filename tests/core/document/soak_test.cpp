#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/document/document.h"
#include "core/document/stroke_path.h"
#include "core/edit/separation.h"
#include "core/physics/contact/rigid_body.h"
#include "core/world/body_creation.h"
#include "core/world/world.h"
#include "tests/support/checkout.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// KERF_SOAK sets another number of strokes: a hundred take some minutes.
size_t strokes_of_the_soak() {
  const char* number = std::getenv("KERF_SOAK");
  return number ? std::strtoul(number, nullptr, 10) : 20;
}

constexpr Ticks kTicksBetween = 6;

World car_on_the_ground() {
  auto body = load_body("car", checkout() / "assets/meshes/car.obj", nullptr);
  EXPECT_TRUE(body);
  World world;
  body->sheet.thickness = 0.0008;
  world.add(std::move(*body));
  world.set_environment({.gravity = {0, -9.81, 0}, .ground = world.bounds().min.y});
  return world;
}

// From one place beside or above the car to another, both towards somewhere in it; bodies move meanwhile.
void draw_at_random(Document& document, Random& random) {
  CutSettings settings;
  settings.laser.radius = random.uniform(0.004, 0.02);
  settings.laser.range = {0, 20};
  settings.resolution.target_edge = random.uniform(1, 3) * settings.laser.radius;
  settings.resolution.rim = random.below(4) == 0 ? Rim::kSmooth : Rim::kFaces;
  const auto pose = [&](const Vec3& origin) {
    const Vec3 to(random.uniform(-0.8, 0.8), random.uniform(0, 1), random.uniform(-1.8, 1.8));
    return Pose{origin, glm::normalize(to - origin)};
  };
  Vec3 out = random_direction(random);
  out.y = std::abs(out.y);
  const Vec3 from = 5.0 * out;
  document.apply(BeginStroke{settings, pose(from)});
  for (size_t moves = 1 + random.below(2); moves > 0; --moves) {
    document.apply(MoveBeam{pose(from)});
    document.apply(AdvanceTime{1 + random.below(kTicksBetween), true});
  }
  document.apply(EndStroke{});
  document.apply(AdvanceTime{1 + random.below(2 * kTicksBetween), true});
}

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void expect_sound_body(const Body& body, double ground) {
  EXPECT_EQ(find_fault(body.mesh, true), "");
  EXPECT_EQ(body.tree.leaf_count(), body.mesh.live_faces());
  if (body.mesh.live_faces() == 0) return;
  const glm::dquat& q = body.placement.orientation;
  EXPECT_NEAR(glm::dot(q, q), 1, 1e-9);
  ASSERT_TRUE(is_finite(body.placement.position) && is_finite(body.motion.velocity) &&
              is_finite(body.motion.spin));
  const Vec3 centre = body.placement.to_world(rigid_frame(body).centre);
  EXPECT_LT(glm::length(body.motion.velocity_at(centre, body.placement)), 20);
  double lowest = 0, farthest = 0;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = body.placement.to_world(t[k]);
      lowest = std::min(lowest, p.y - ground);
      farthest = std::max(farthest, glm::length(p));
    }
  }
  EXPECT_GT(lowest, -0.03);
  EXPECT_LT(farthest, 50);
}

double area_of(const World& world) {
  double area = 0;
  for (const BodyId id : world.ids()) {
    const Records<Piece>& pieces = world.body(id).pieces;
    for (uint32_t p = 0; p < pieces.size(); ++p) area += pieces[p].area;
  }
  return area;
}

// The smallest bodies above a thousand are deleted. Returns their area (m^2).
double clear_away(Document& document) {
  constexpr size_t kMost = 1000;
  std::vector<std::pair<double, PieceId>> pieces;
  for (const BodyId id : document.world().ids()) {
    const Records<Piece>& all = document.world().body(id).pieces;
    for (uint32_t p = 0; p < all.size(); ++p) {
      if (all[p].faces > 0) pieces.push_back({all[p].area, {id, p}});
    }
  }
  std::sort(pieces.begin(), pieces.end());
  double area = 0;
  for (size_t i = 0; i + kMost < pieces.size(); ++i) {
    area += pieces[i].first;
    EXPECT_TRUE(document.apply(DeletePiece{pieces[i].second}).ok());
  }
  return area;
}

TEST(Soak, random_strokes_on_a_collapsing_car_leave_a_valid_world) {
  constexpr uint64_t kSeed = 11;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  Document document(car_on_the_ground());
  const uint64_t start = state_hash(document.world());
  const double area = area_of(document.world()), ground = *document.world().environment().ground;
  double deleted = 0;
  document.apply(Play{});
  for (size_t i = 0; i < strokes_of_the_soak(); ++i) {
    SCOPED_TRACE("stroke " + std::to_string(i));
    draw_at_random(document, random);
    ASSERT_TRUE(run_all(document).ok());
    deleted += clear_away(document);
    for (const BodyId id : document.world().ids()) expect_sound_body(document.world().body(id), ground);
    EXPECT_NEAR(area_of(document.world()) + document.history().totals().removed_area + deleted, area,
                1e-6 * area);
    if (HasFailure()) return;
  }
  EXPECT_GT(document.world().ids().size(), 20u);
  const uint64_t end = state_hash(document.world());
  ASSERT_TRUE(document.travel(0).ok());
  EXPECT_EQ(state_hash(document.world()), start);
  ASSERT_TRUE(document.travel(document.history().size()).ok());
  EXPECT_EQ(state_hash(document.world()), end);
}

}  // namespace
}  // namespace kerf::test
