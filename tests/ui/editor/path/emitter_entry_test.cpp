#include "core/base/json.h"
#include "ui/editor/path/emitter.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

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

// An emitter at (0, 0, 5) that aims at a sphere of radius 1.
struct EmitterBench {
  EmitterBench() {
    workspace.screen.clock = &clock;
    workspace.view.layout = lay_out({1000, 700}, 16, 26, 26);
    workspace.view.camera.look({0, 0, 5}, {0, 0, 0});
    workspace.view.camera.finish();
    World world;
    world.add(make_body("sphere", test::build(test::sphere(8, 12, 1))));
    workspace.session.document = Document(std::move(world));
  }
  void open(const nlohmann::json& entry) {
    set_head_entry(workspace.session.scene, kEmitterKey, entry);
    feature->on_document_opened();
  }
  void run(const std::string& id) {
    for (const UserAction& action : feature->actions()) {
      if (action.id == id) action.run();
    }
    feature->update(0);
  }

  struct Clock final : WindowClock {
    double seconds() const override { return 0; }
  } clock;
  Workspace workspace;
  std::unique_ptr<Feature> feature = emitter_feature(workspace);
};

TEST(EmitterEntry, keeps_its_radius_when_the_emitter_moves) {
  EmitterBench bench;
  const nlohmann::json before{{"at", {0, 0, 5}}, {"target", {0, 0, 1}}, {"radius", 0.25}};
  bench.open(before);
  bench.run("emitter.place");
  const nlohmann::json after = head_entry(bench.workspace.session.scene, kEmitterKey);
  EXPECT_NE(after["at"], before["at"]);
  EXPECT_EQ(radius_of_entry(after), 0.25);
}

TEST(EmitterFeature, aims_at_pieces_in_their_true_places) {
  EmitterBench bench;
  bench.workspace.view.spread = 1;
  bench.run("emitter.place");
  EXPECT_EQ(bench.workspace.view.spread, 0);
  Landmarks landmarks(std::nullopt);
  bench.feature->add_landmarks(landmarks);
  const auto target = landmarks.find("emitter target");
  ASSERT_TRUE(target.has_value());
  bench.workspace.view.spread = 1;
  const InputEvent press{InputEvent::Kind::kPress, target->at, 0};
  bench.workspace.input.pointer = target->at;
  EXPECT_NE(bench.feature->begin_interaction({press}), nullptr);
  EXPECT_EQ(bench.workspace.view.spread, 0);
}

TEST(EmitterFeature, fires_shots_unless_they_would_emit_no_energy) {
  for (const Model model : {Model::kGeometric, Model::kThermal}) {
    EmitterBench bench;
    bench.workspace.laser.model = model;
    bench.open({{"at", {0, 0, 5}}, {"target", {0, 0, 1}}, {"in_shots", true}});
    bench.run("emitter.fire");
    const bool is_thermal = model == Model::kThermal;
    EXPECT_EQ(bench.workspace.session.document.history().size(), is_thermal ? 0u : 1u);
    EXPECT_EQ(bench.workspace.message.is_error, is_thermal) << bench.workspace.message.text;
    nlohmann::ordered_json report;
    bench.feature->write_session_log(report);
    EXPECT_EQ(report["emitter"]["firing"].get<bool>(), !is_thermal);
  }
}

}  // namespace
}  // namespace kerf
