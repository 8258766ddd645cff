#include "ui/editor/time/time_feature.h"

#include <GLFW/glfw3.h>

#include <nlohmann/json.hpp>

#include "core/document/text/json_value.h"
#include "ui/editor/shared/click.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/selection.h"
#include "ui/editor/time/bodies_panel.h"
#include "ui/editor/time/body_actions.h"
#include "ui/editor/time/cooling.h"
#include "ui/editor/time/play_marks.h"
#include "ui/editor/time/pulling.h"
#include "ui/editor/time/time_flow.h"
#include "ui/render/bodies/body_marks.h"

namespace kerf {

namespace {

class TimeFeature : public Feature {
 public:
  explicit TimeFeature(Workspace& on) : on_(on) {}

  std::vector<Panel> panels() override {
    return {{"Bodies", 700, false, [this] { panel_.draw(on_, play_); }}};
  }
  std::vector<ActionGroup> actions() override { return {{520, "Bodies", body_actions(on_, play_)}}; }
  std::vector<Gesture> gestures() const override {
    return {{50, "Ctrl+left drag on a piece", "Pull it by a spring, while bodies move"}};
  }

  std::unique_ptr<Interaction> claim(const Press& press) override {
    if (!picks(on_, press) || !play_.playing) return nullptr;
    const auto spring = spring_at(on_.world(), on_.view, on_.pointer);
    return spring ? std::make_unique<Pull>(*this, *spring) : nullptr;
  }
  const char* hint() const override {
    return on_.tool == kPickTool && play_.playing ? "Pick: drag pulls a piece, a click chooses it" : nullptr;
  }

  void advance(double) override {
    if (dynamic_cast<const Pull*>(on_.held.get()) == nullptr) spring_.reset();
    on_.cools_unseen = cooling_.passes_unseen();
  }
  void follow_queue(double seconds) override;
  bool moving() const override { return cooling_.moving() || play_.playing || play_.one_tick; }
  void follow(const Delta& delta) override {
    if (spring_) spring_->piece = named_after(delta, spring_->piece);
  }

  void draw_marks(ImDrawList&) override {
    if (spring_) draw_spring(*spring_, on_.world(), on_.view);
    draw_play_badge(play_, on_.world(), on_.view);
  }
  void report(nlohmann::ordered_json& report) const override;

 private:
  // What was pressed while time passes is pulled by a drag, and chosen by a click.
  class Pull : public Interaction {
   public:
    Pull(TimeFeature& feature, const Spring& spring)
        : feature_(feature), pressed_at_(feature.on_.pointer), spring_(spring) {}

    void move(const InputEvent&) override;
    void release(const InputEvent& event) override {
      if (!pulls_) choose_under_pointer(feature_.on_, (event.mods & GLFW_MOD_SHIFT) != 0);
    }
    bool cancel() override { return pulls_; }
    const char* words() const override { return pulls_ ? "Pulling: release to let go" : nullptr; }

   private:
    TimeFeature& feature_;
    Vec2 pressed_at_;
    Spring spring_;
    bool pulls_ = false;
  };

  Workspace& on_;
  PlayState play_;
  std::optional<Spring> spring_;  // that a piece is pulled by
  TimeFlow flow_{on_, play_, spring_};
  Cooling cooling_{on_, play_};
  BodiesPanel panel_;
};

void TimeFeature::Pull::move(const InputEvent&) {
  if (!pulls_ && glm::length(feature_.on_.pointer - pressed_at_) > kClickReach) {
    pulls_ = true;
    feature_.spring_ = spring_;
  }
  if (feature_.spring_) stretch(*feature_.spring_, feature_.on_.view, feature_.on_.pointer);
}

void TimeFeature::follow_queue(double seconds) {
  flow_.advance(seconds);
  cooling_.advance(seconds);
  on_.cools = cooling_.flows();
  on_.figures.shown.time = play_.playing ? std::string("playing ") + play_.speed().name : "";
  // The picture is old wherever contacts may have changed.
  if (on_.changes.is_pending() || !on_.view.picture_old) return;
  on_.view.look.bodies =
      gather_body_marks(on_.world(), on_.work.document.execution().physics(), on_.view.look.show);
}

nlohmann::ordered_json heat_of(const World& world) {
  double hottest = kAmbient;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    body.mesh.columns().for_each_set(body.heat.energy, [&](FaceId f) {
      const Sheet& sheet = body.sheet;
      hottest = std::max(hottest, body.heat.temperature(body.mesh, f, sheet.substance, sheet.thickness));
    });
  }
  return {{"hottest", hottest}, {"emitted", world.energy().emitted}, {"absorbed", world.energy().absorbed}};
}

void TimeFeature::report(nlohmann::ordered_json& report) const {
  const World& world = on_.world();
  report["time"] = {
      {"ticks", world.clock()},
      {"playing", play_.playing},
      {"speed", play_.speed().of_real_time},
      {"gravity", vector_json(world.surroundings().gravity)},
      {"ground", world.surroundings().ground ? nlohmann::ordered_json(*world.surroundings().ground)
                                             : nlohmann::ordered_json(nullptr)}};
  report["heat"] = heat_of(world);
}

}  // namespace

std::unique_ptr<Feature> time_feature(Workspace& on) { return std::make_unique<TimeFeature>(on); }

}  // namespace kerf
