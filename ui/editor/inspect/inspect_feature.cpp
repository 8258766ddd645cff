#include "ui/editor/inspect/inspect_feature.h"

#include "ui/editor/inspect/face_readout.h"
#include "ui/editor/inspect/heat_probe.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/render/bodies/pick.h"

namespace kerf {

namespace {

constexpr const char* kInspectTool = "Inspect and measure";

class InspectFeature : public Feature {
 public:
  explicit InspectFeature(Workspace& on) : on_(on) {}

  std::vector<ActionGroup> actions() override {
    UserAction action = tool_action(on_, kInspectTool, "M",
                                    "Tells what there is to know about the face under the pointer; two "
                                    "clicks measure the distance between two "
                                    "points.");
    action.run = [this, take = action.run] {
      take();
      measured_.clear();
    };
    return {{302, "Tool", {action}}};
  }

  std::unique_ptr<Interaction> claim(const Press& press) override {
    return inspects() && !press.control ? std::make_unique<Click>(*this) : nullptr;
  }
  bool let_go() override {
    if (measured_.empty()) return false;
    measured_.clear();
    return true;
  }
  const char* hint() const override {
    return inspects() ? "Inspect: click two points to measure their distance" : nullptr;
  }

  void advance(double) override {
    if (!inspects()) measured_.clear();
  }
  void follow_queue(double) override {
    if (on_.changes.is_pending()) return;
    const auto clicked = measured_.empty() ? std::nullopt : std::optional(measured_.back());
    probe_.follow(on_.world(), on_.view, clicked, inspects());
  }
  void forget() override { measured_.clear(); }

  void draw_marks(ImDrawList& list) override {
    if (inspects()) draw_measure(on_.view, measured_, list);
    if (inspects()) draw_face_readout(on_, list);
    draw_heat_probe(probe_, on_.view.layout.first);
  }

 private:
  class Click : public Interaction {
   public:
    explicit Click(InspectFeature& feature) : feature_(feature) {}
    void release(const InputEvent&) override { feature_.measure(); }

   private:
    InspectFeature& feature_;
  };

  bool inspects() const { return on_.tool == kInspectTool; }
  void measure();

  Workspace& on_;
  std::vector<Vec3> measured_;  // m, the points that were clicked: at most two
  HeatProbe probe_;
};

// The third click begins another distance.
void InspectFeature::measure() {
  if (on_.view.in_second) return on_.message.say("Distances are measured in the left half.", true);
  const Vec2 p = on_.view.in_picture(on_.pointer);
  const Pose ray = on_.view.seen().ray(p.x, p.y);
  const std::optional<Pick> seen = pick(on_.world(), on_.view.look, ray);
  if (!seen) return on_.message.say("There is no surface under the pointer.", true);
  if (measured_.size() == 2) measured_.clear();
  measured_.push_back(ray.origin + ray.direction * seen->length);
  if (measured_.size() < 2)
    return on_.message.say("Click a second point to measure its distance from this one.");
  const Vec3 way = measured_[1] - measured_[0];
  const auto text = [&](double length) { return length_label(length, on_.view.frame.unit); };
  on_.message.say("Distance " + text(glm::length(way)) + "; along X " + text(std::abs(way.x)) + ", along Y " +
                  text(std::abs(way.y)) + ", along Z " + text(std::abs(way.z)));
}

}  // namespace

std::unique_ptr<Feature> inspect_feature(Workspace& on) { return std::make_unique<InspectFeature>(on); }

}  // namespace kerf
