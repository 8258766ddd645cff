#include "core/base/json.h"
#include "ui/editor/path/emitter.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "ui/editor/shared/document_session.h"
#include "ui/editor/shared/feature.h"
#include "ui/window/layout.h"
#include "ui/window/window.h"

namespace kerf {
namespace {

TEST(EmitterEntry, restores_the_emitter_switched_off) {
  Emitter emitter;
  emitter.place({1, 2, 3}, {0.1, 0, -0.2});
  emitter.in_shots = true;
  emitter.pace.set(7);
  emitter.firing = true;
  const Emitter read = emitter_of_entry(nlohmann::json::parse(emitter_entry(emitter).dump()));
  ASSERT_TRUE(read.placed());
  EXPECT_EQ(read.at(), emitter.at());
  EXPECT_EQ(read.target(), emitter.target());
  EXPECT_TRUE(read.in_shots);
  EXPECT_EQ(read.pace.per_second(), 7);
  EXPECT_FALSE(read.firing);
}

TEST(EmitterEntry, is_null_without_an_emitter_and_ignored_if_invalid) {
  EXPECT_TRUE(emitter_entry(Emitter()).is_null());
  EXPECT_FALSE(emitter_of_entry(nullptr).placed());
  EXPECT_FALSE(emitter_of_entry({{"at", {0, 0, 0}}, {"target", {0, 0, 0}}}).placed());
  EXPECT_FALSE(emitter_of_entry({{"at", "there"}, {"target", {0, 0, 1}}}).placed());
}

TEST(EmitterEntry, keeps_its_radius_when_the_emitter_moves) {
  struct Clock final : WindowClock {
    double seconds() const override { return 0; }
  } clock;
  Workspace workspace;
  workspace.screen.clock = &clock;
  workspace.view.layout = lay_out({1000, 700}, 16, 26, 26);
  workspace.view.camera.look({0, 0, 5}, {0, 0, 0});
  workspace.view.camera.finish();
  World world;
  world.add(make_body("sphere", test::build(test::sphere(8, 12, 1))));
  workspace.session.document = Document(std::move(world));
  const nlohmann::json before{{"at", {0, 0, 5}}, {"target", {0, 0, 1}}, {"radius", 0.25}};
  set_head_entry(workspace.session.scene, kEmitterKey, before);
  const auto feature = emitter_feature(workspace);
  feature->on_document_opened();
  for (const UserAction& action : feature->actions()) {
    if (action.id == "emitter.place") action.run();
  }
  feature->update(0);
  const nlohmann::json after = head_entry(workspace.session.scene, kEmitterKey);
  EXPECT_NE(after["at"], before["at"]);
  EXPECT_EQ(radius_of_entry(after), 0.25);
}

}  // namespace
}  // namespace kerf
