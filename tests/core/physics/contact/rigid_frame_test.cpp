#include "core/physics/contact/rigid_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/edit/body_edit.h"
#include "core/world/body_mass.h"
#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"
#include "tests/support/strokes.h"

namespace kerf {
namespace {

// Closed forms of thin shells of surface density s: a plate a x b, a tube of radius r and length l.
TEST(RigidFrame, has_the_analytic_mass_and_inertia) {
  World world;
  const BodyId plate = test::add(world, test::rectangle(0.6, 0.4, 3), {5, 6, 7});
  RigidFrame frame = rigid_frame(world.body(plate));
  const double m = 0.6 * 0.4 * 0.001 * 7850;
  EXPECT_NEAR(frame.mass, m, 1e-12);
  std::array<double, 3> inertia{frame.inertia.x, frame.inertia.y, frame.inertia.z};
  std::sort(inertia.begin(), inertia.end());
  EXPECT_NEAR(inertia[0], m * 0.16 / 12, 1e-12);
  EXPECT_NEAR(inertia[1], m * 0.36 / 12, 1e-12);
  EXPECT_NEAR(inertia[2], m * 0.52 / 12, 1e-12);
}

TEST(RigidFrame, placement_round_trips) {
  World world;
  const Soup soup = test::moved(test::rectangle(0.6, 0.4, 3), {3, -2, 8}, 1);
  const BodyId id = test::add(world, soup, {5, 6, 7}, glm::normalize(glm::dquat(1, 2, -1, 0.5)));
  const Body& body = world.body(id);
  const RigidFrame frame = rigid_frame(body);
  const Placement back = frame.body_at(frame.in_world(body.placement));
  EXPECT_LT(glm::length(back.position - body.placement.position), 1e-13);
  EXPECT_LT(glm::length(frame.in_world(body.placement).position - body.placement.to_world({3, -2, 8})),
            1e-12);
}

TEST(RigidFrame, of_a_body_without_faces_has_no_mass) {
  Body body = make_body("plate", test::build(test::rectangle(1, 1, 3)));
  BodyEdit(body).remove(body.faces_of(0));
  body.pieces.edit(0).area = 1e-16;  // as rounding may leave it
  EXPECT_EQ(rigid_frame(body).mass, 0);
}

TEST(RigidFrame, of_a_body_beyond_the_range_of_its_inertia_has_no_mass) {
  for (const double size : {1e80, 1e-85}) {
    Soup box = test::brick({1, 2, 3});
    for (Vec3& p : box.positions) p *= size;
    const Body body = make_body("box", test::build(box));
    EXPECT_EQ(rigid_frame(body).mass, 0) << size;
  }
}

// A plate that remains of a body of kilometres.
TEST(RigidFrame, of_a_tiny_remnant_has_the_inertia_of_its_bounds) {
  for (const double far : {1e3, 1e4, 1e5}) {
    SCOPED_TRACE(far);
    Body body = make_body("speck", test::build(test::rectangle(1e-5, 2e-5, 2)));
    body.loaded.max += Vec3(far, 0.7 * far, 0.4 * far);
    update_mass_properties(body);
    const RigidFrame frame = rigid_frame(body);
    const double m = 2e-10 * 0.001 * 7850;
    EXPECT_NEAR(frame.mass, m, 1e-3 * m);
    std::array<double, 3> inertia{frame.inertia.x, frame.inertia.y, frame.inertia.z};
    std::sort(inertia.begin(), inertia.end());
    for (size_t i = 0; i < 3; ++i) {
      const double expected = frame.mass / 12 * std::array{1e-10, 4e-10, 5e-10}[i];
      EXPECT_NEAR(inertia[i], expected, 1e-6 * expected);
    }
  }
}

TEST(RigidFrame, of_a_solid_body_has_solid_mass_properties) {
  World world = test::world_of(test::brick({1, 2, 3}));
  Body& body = test::only_body(world);
  const double as_sheet = rigid_frame(body).mass;
  body.solid = true;
  EXPECT_EQ(rigid_frame(body).mass, as_sheet) << "before it is weighed";
  update_mass_properties(body);
  const RigidFrame frame = rigid_frame(body);
  const double mass = 6 * body.sheet.density;
  EXPECT_NEAR(frame.mass, mass, 1e-9);
  EXPECT_NEAR(glm::distance(frame.centre, Vec3(0.5, 1, 1.5)), 0, 1e-14);
  std::array<double, 3> inertia{frame.inertia.x, frame.inertia.y, frame.inertia.z};
  std::sort(inertia.begin(), inertia.end());
  EXPECT_NEAR(inertia[0], mass / 12 * 5, 1e-9);
  EXPECT_NEAR(inertia[1], mass / 12 * 10, 1e-9);
  EXPECT_NEAR(inertia[2], mass / 12 * 13, 1e-9);
}

// Oblique boxes with the inertia of parts of millimetres to a hundred metres.
TEST(RigidFrame, has_the_principal_inertia_at_every_size) {
  const glm::dquat turn = glm::normalize(glm::dquat(1, 0.7, -0.4, 0.3));
  for (const double size : {1e-3, 1.0, 100.0}) {
    SCOPED_TRACE(size);
    Soup box = test::brick({1, 2, 3});
    for (Vec3& p : box.positions) p = turn * (size * p);
    Body body = make_body("box", test::build(box));
    body.solid = true;
    update_mass_properties(body);
    const RigidFrame frame = rigid_frame(body);
    const double unit = 6 * body.sheet.density * std::pow(size, 5) / 12;
    std::array<double, 3> inertia{frame.inertia.x, frame.inertia.y, frame.inertia.z};
    std::sort(inertia.begin(), inertia.end());
    for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(inertia[i] / unit, (std::array{5.0, 10.0, 13.0}[i]), 1e-8);
  }
}

// A solid box of which a sheet, with a label of its own, is a part.
TEST(RigidFrame, combines_a_closed_solid_and_an_open_sheet) {
  World world = test::world_of(test::both(test::brick({1, 1, 1}), test::moved(test::plate(2), {5, 0, 0}, 1)));
  Body& body = test::only_body(world);
  body.solid = true;
  body.pieces.push_back({});
  for (uint32_t f = 12; f < 14; ++f) body.mesh.edit_data(FaceId(f)).piece = 1;
  body.pieces.edit(0).faces = 12;
  body.pieces.edit(1).faces = 2;
  update_mass_properties(body);
  const double box = body.sheet.density, sheet = 4 * body.sheet.density * body.sheet.thickness;
  const RigidFrame frame = rigid_frame(body);
  EXPECT_NEAR(frame.mass, box + sheet, 1e-9);
  EXPECT_NEAR(frame.centre.x, (0.5 * box + 5 * sheet) / (box + sheet), 1e-12);
}

}  // namespace
}  // namespace kerf
