#include "ui/editor/path/emitter_feature.h"

#include <imgui.h>

#include <array>
#include <nlohmann/json.hpp>

#include "core/base/assert.h"
#include "core/cut/cuttable.h"
#include "core/document/text/json_value.h"
#include "ui/editor/path/emitter.h"
#include "ui/editor/path/emitter_entry.h"
#include "ui/editor/shared/files/document_head.h"
#include "ui/editor/shared/panels/panel_rows.h"
#include "ui/editor/shared/panels/shortcut_text.h"
#include "ui/editor/shared/surface_point.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/number_fields.h"
#include "ui/window/property.h"
#include "ui/window/row_button.h"

namespace kerf {

namespace {

constexpr double kEmitterAway = 0.35;  // diagonals of the world

class EmitterFeature : public Feature {
 public:
  explicit EmitterFeature(Workspace& on) : on_(on) {}

  std::vector<Panel> panels() override {
    return {{"Laser", Tab::kCut, 120, true, [this] { draw_rows(); }}};
  }
  std::vector<ActionGroup> actions() override { return {{410, "Path", emitter_actions()}}; }
  std::vector<Gesture> gestures() const override {
    return {{80, "Left drag on the emitter", "Move it, or aim it by the ring where it aims"}};
  }

  std::unique_ptr<Interaction> claim(const Press& press) override;
  bool stop() override { return std::exchange(emitter_.firing, false); }
  void advance(double) override {
    if (on_.held == nullptr) keep();
    if (!on_.changes.is_pending()) follow_switch(on_.clock->seconds());
  }
  void forget() override {
    emitter_ = emitter_of_entry(head_entry(on_.work.scene, kEmitterKey));
    kept_ = emitter_entry(emitter_);
  }
  bool moving() const override { return emitter_.firing && emitter_.in_shots; }

  void draw_marks(ImDrawList& list) override;
  void mark(Landmarks& landmarks) const override {
    mark_handles(emitter_handles(emitter_, FirstPicture(on_.view)), landmarks);
  }
  void report(nlohmann::ordered_json& report) const override;

 private:
  std::vector<UserAction> emitter_actions();
  void keep();
  void drag(double now);
  void draw_rows();
  void draw_pace();
  void place();
  void follow_switch(double now);
  void begin_fire(double now);
  void fire_shots(double now);

  Workspace& on_;
  Emitter emitter_;
  nlohmann::json kept_;  // its entry in the head of the document
  NumberFields fields_;
};

std::unique_ptr<Interaction> EmitterFeature::claim(const Press&) {
  const auto handle = handle_under(emitter_handles(emitter_, FirstPicture(on_.view)), on_.pointer);
  if (!handle || on_.view.in_second) return nullptr;
  emitter_.take(handle->part, on_.pointer);
  return std::make_unique<PlainDrag>("Moving the emitter",
                                     [this](const InputEvent& event) { drag(event.seconds); });
}

void EmitterFeature::keep() {
  nlohmann::json entry = emitter_entry(emitter_);
  if (entry == kept_) return;
  set_head_entry(on_.work.scene, kEmitterKey, entry);
  kept_ = std::move(entry);
}

// Moves or aims the emitter. The beam of one that fires follows each move of the pointer, as that of the
// pointer itself does.
void EmitterFeature::drag(double now) {
  emitter_.drag(FirstPicture(on_.view), on_.pointer, point_under_pointer(on_));
  if (emitter_.drawing) on_.beam.carry_to(on_.work.document, emitter_.pose(), now);
}

std::vector<UserAction> EmitterFeature::emitter_actions() {
  const auto why_none = [this] {
    return emitter_.placed() ? nullptr : "There is no emitter: place one first.";
  };
  return {
      UserAction{.name = "Place the emitter",
                 .shortcut = "Shift+U",
                 .tip = "A laser that stands in the scene, aimed at the middle of the picture.",
                 .run = [this] { place(); }},
      UserAction{
          .name = "Fire the emitter",
          .shortcut = "U",
          .tip = "Switches it on or off. The Laser panel says whether it fires without a break or in shots.",
          .run = [this] { emitter_.firing = !emitter_.firing; },
          .checked = [this] { return emitter_.firing; },
          .why_not = why_none},
      UserAction{.name = "Take the emitter away",
                 .tip = "Takes it out of the scene.",
                 .run = [this] { emitter_.remove(); },
                 .why_not = why_none},
  };
}

// Buttons that place the emitter, switch it and take it away, its pace, and its place and aim as numbers.
void EmitterFeature::draw_rows() {
  if (!emitter_.placed()) {
    const std::string meaning = with_shortcut(
        on_.view, "A laser that stands in the scene. It is moved and aimed by handles.", "Place the emitter");
    if (row_button("Place an emitter", 1, nullptr, meaning.c_str())) place();
    return;
  }
  const std::string meaning = with_shortcut(on_.view, "Switches the emitter on or off.", "Fire the emitter");
  if (row_button(emitter_.firing ? "Switch off###fire" : "Fire###fire", 2, nullptr, meaning.c_str()))
    emitter_.firing = !emitter_.firing;
  mark_last_item("fire");
  ImGui::SameLine();
  const bool removed = row_button("Take away", 2, nullptr, "Takes the emitter out of the scene.");
  if (!begin_properties("emitter")) return;
  draw_pace();
  Vec3 at = emitter_.at(), target = emitter_.target();
  const NumberUnit unit = file_unit(on_.view.frame.unit);
  const double size = on_.world().loaded_bounds().diagonal();
  if (fields_.vector("Stands at", at, "%.5g", "X, Y and Z of the emitter, in the unit of the file.", unit,
                     size))
    emitter_.stand_at(at);
  if (fields_.vector("Aims at", target, "%.5g", "X, Y and Z of what it aims at, in the unit of the file.",
                     unit, size))
    emitter_.aim_at(target);
  end_properties();
  if (removed) emitter_.remove();
}

void EmitterFeature::draw_pace() {
  constexpr std::array kKinds{"Without a break", "In shots"};
  int kind = emitter_.in_shots ? 1 : 0;
  marked_choice_row(
      "Fires", "##fires", kind, kKinds, "emitter fires",
      "Without a break: what the emitter is moved over is one stroke. In shots: at a steady pace, each "
      "shot a stroke of its own that undo takes back. A shot that meets nothing is none.");
  emitter_.in_shots = kind == 1;
  if (!emitter_.in_shots) return;
  double pace = emitter_.pace.per_second();
  if (fields_.number("Pace", pace, "%.3g shots/s",
                     "How many shots are fired a second, from 0.1 to 60. A shot waits until the last one is "
                     "cut.",
                     {}, {FirePace::kSlowest, FirePace::kFastest}))
    emitter_.pace.set(pace);
}

// Where the view looks.
void EmitterFeature::place() {
  const double diagonal = on_.world().bounds().diagonal();
  const CameraView view = on_.view.seen_first();
  const auto surface = surface_point(on_.world(), on_.view.look, view.ray(0, 0));
  place_in_view(emitter_, view, surface ? surface->at : on_.view.camera.pivot(),
                diagonal > 0 ? kEmitterAway * diagonal : 1);
}

// Begins, continues or ends the stroke of the emitter, as it is switched, or fires the shot that is due.
void EmitterFeature::follow_switch(double now) {
  LaserTool& beam = on_.beam;
  const bool ended_elsewhere = (emitter_.drawing && !beam.cutting()) || (on_.held && on_.held->cuts());
  if (ended_elsewhere) emitter_.firing = emitter_.drawing = false;
  if (on_.opening.loader.busy()) emitter_.firing = false;
  if (emitter_.in_shots && !emitter_.drawing) return fire_shots(now);
  const bool on = emitter_.firing && !emitter_.in_shots;
  if (on && !emitter_.drawing) {
    begin_fire(now);
  } else if (on) {
    beam.carry_to(on_.work.document, emitter_.pose(), now);
  } else if (emitter_.drawing) {
    cancel_stroke(on_);
  }
  emitter_.drawing = on;
}

void EmitterFeature::begin_fire(double now) {
  cancel_stroke(on_);
  stand_together(on_);
  KERF_ASSERT(emitter_.placed());
  on_.beam.fire(on_.work.document, emitter_.pose(), emitter_.distance(),
                on_.laser.settings(on_.world().bounds().diagonal()), now);
  on_.cut_once = true;
}

// A shot waits until the last one is cut. One that meets nothing would be an empty step of the history.
void EmitterFeature::fire_shots(double now) {
  const Document& document = on_.work.document;
  if (!emitter_.firing) return emitter_.pace.begin();
  if (on_.beam.cutting() || document.waiting() > 0 || !emitter_.pace.is_due(now)) return;
  emitter_.pace.take(now);
  const Laser laser = on_.laser.settings(on_.world().bounds().diagonal()).laser;
  if (!meets_anything(on_.world(), laser, emitter_.pose())) return;
  begin_fire(now);
  on_.beam.release(on_.work.document);
}

void EmitterFeature::draw_marks(ImDrawList& list) {
  const Area& first = on_.view.layout.first;
  list.PushClipRect(to_im(first.at), to_im(first.at + first.size), true);
  draw_emitter(emitter_, FirstPicture(on_.view), on_.pointer_over_picture(), list);
  list.PopClipRect();
  if (!emitter_.firing) return;
  on_.badges.draw(on_.view, Badges::Sign::kMode,
                  with_shortcut(on_.view, "The emitter fires.", "Fire the emitter"), "emitter badge");
}

void EmitterFeature::report(nlohmann::ordered_json& report) const {
  report["emitter"] = {{"placed", emitter_.placed()},
                       {"at", vector_json(emitter_.at())},
                       {"target", vector_json(emitter_.target())},
                       {"firing", emitter_.firing},
                       {"in_shots", emitter_.in_shots},
                       {"pace", emitter_.pace.per_second()}};
}

}  // namespace

std::unique_ptr<Feature> emitter_feature(Workspace& on) { return std::make_unique<EmitterFeature>(on); }

}  // namespace kerf
