#include "tests/support/jointed.h"

#include <gtest/gtest.h>

#include "core/edit/detach.h"
#include "core/joints/joined_parts.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {

Soup assembled(std::span<const NamedSheet> sheets) {
  Soup all;
  for (const NamedSheet& sheet : sheets) {
    const auto first = static_cast<uint32_t>(all.positions.size());
    const auto first_triangle = static_cast<uint32_t>(all.triangles.size());
    for (const Vec3& p : sheet.soup.positions)
      all.positions.push_back(sheet.orientation * p + sheet.position);
    for (const auto& [a, b, c] : sheet.soup.triangles)
      all.triangles.push_back({first + a, first + b, first + c});
    all.parts.push_back({sheet.name, first_triangle, static_cast<uint32_t>(all.triangles.size())});
  }
  all.faces_in_file = all.triangles_in_file = all.triangles.size();
  return all;
}

World jointed_world(std::span<const NamedSheet> sheets, std::span<const JointDescription> joints) {
  World world;
  const BodyId id = world.add(make_body("assembly", build(assembled(sheets))));
  Joints all;
  for (const JointDescription& joint : joints) {
    auto made = make_joint(joint, id, world.body(id));
    EXPECT_TRUE(made.ok()) << made.error().message;
    all.all.push_back(std::move(*made));
  }
  world.set_joints(std::move(all));
  return world;
}

std::vector<BodyId> part_bodies(World& world) {
  Delta delta;
  separate_by_joints(world, JointMode::kArticulated, delta);
  for (const BodyId id : world.ids()) {
    for (uint32_t label = 1; label < world.body(id).pieces.size(); ++label) {
      if (world.body(id).pieces[label].faces > 0 && !is_only_piece(world, {id, label}))
        detach(world, {id, label}, 1, delta);
    }
  }
  return world.ids();
}

void cut_car(Document& document) {
  CutSettings settings;
  settings.laser.radius = 0.01;
  settings.laser.range = {0, 10};
  document.apply(BeginStroke{settings, {{-2, 1.25, 5}, {0, 0, -1}}});
  document.apply(MoveBeam{{{2, 1.25, 5}, {0, 0, -1}}});
  document.apply(Play{});
  document.apply(AdvanceTime{1, true});
  while (document.waiting() > 0) ASSERT_TRUE(document.step(64).ok());
}

}  // namespace kerf::test
