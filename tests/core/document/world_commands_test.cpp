#include <gtest/gtest.h>

#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/world/world.h"
#include "tests/support/energy.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf {
namespace {

TEST(EnvironmentText, in_millimetres_round_trips) {
  const Command metres = SetEnvironment{{.gravity = {0, -9.81, 0}, .ground = 0}};
  const Command millimetres = SetEnvironment{{.gravity = {0, -9810, 0}, .ground = 5, .metre = 1000}};
  for (const Command& command : {metres, millimetres}) {
    const auto text = command_text(command, {});
    ASSERT_TRUE(text.ok());
    const nlohmann::json json = nlohmann::json::parse(*text);
    const auto read = parse_command(JsonValue(json, "test"), {}, std::nullopt);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(std::get<SetEnvironment>(*read).around, std::get<SetEnvironment>(command).around);
  }
  const nlohmann::json wrong = {{"do", "environment"}, {"gravity", {0, -1, 0}}, {"metre", 0}};
  EXPECT_FALSE(parse_command(JsonValue(wrong, "test"), {}, std::nullopt).ok());
}

TEST(DeletePiece, keeps_the_balance_of_energy) {
  World world = test::world_of(test::brick({1, 2, 3}));
  Body& body = test::only_body(world);
  const BodyId id = world.ids().front();
  body.heat.set_energy(body.mesh, FaceId(0), 3);
  body.ejected = 2;
  Document document(std::move(world));
  ASSERT_TRUE(document.apply(DeletePiece{{id, 0}}).ok());
  EXPECT_EQ(ejected_energy(document.world()), 5);
  ASSERT_TRUE(document.apply(Undo{}).ok());
  EXPECT_EQ(ejected_energy(document.world()), 2);
}

TEST(DuplicatePiece, keeps_the_balance_of_energy) {
  World world = test::world_of(test::brick({1, 2, 3}));
  Body& body = test::only_body(world);
  const BodyId id = world.ids().front();
  body.heat.set_energy(body.mesh, FaceId(0), 3);
  world.edit_energy().emitted = world.edit_energy().absorbed = 3;
  Document document(std::move(world));
  ASSERT_TRUE(document.apply(DuplicatePiece{{id, 0}, {{5, 0, 0}, {1, 0, 0, 0}}}).ok());
  EXPECT_EQ(document.world().energy().absorbed, 6);
  test::expect_closed_ledger(document.world(), 1e-12);
  ASSERT_TRUE(document.apply(DeletePiece{{document.world().ids().back(), 0}}).ok());
  EXPECT_LE(ejected_energy(document.world()), document.world().energy().absorbed);
  test::expect_closed_ledger(document.world(), 1e-12);
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(document.apply(Undo{}).ok());
  EXPECT_EQ(document.world().energy().absorbed, 3);
}

}  // namespace
}  // namespace kerf
