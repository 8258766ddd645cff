#include "ui/editor/path/emitter.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "core/cut/cut_step.h"
#include "core/document/stroke_path.h"
#include "core/document/text/json.h"
#include "ui/editor/shared/document_session.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

void FirePace::set(double per_second) { per_second_ = std::clamp(per_second, kSlowest, kFastest); }

bool FirePace::is_due(double now) const { return !last_ || (now - *last_) * per_second_ >= 1; }

void FirePace::take(double now) {
  KERF_ASSERT(is_due(now));
  last_ = last_ ? *last_ + std::floor((now - *last_) * per_second_) / per_second_ : now;
}

namespace {

using Part = EmitterHandle::Part;

constexpr double kHandleEms = 4;
constexpr double kFreeShare = 0.22;      // of an arrow: its start belongs to the body handle
constexpr float kBody = 7, kTarget = 7;  // radii in screen coordinates
constexpr ImU32 kShade = IM_COL32(10, 12, 16, 150);

Vec3 axis_of(Part part) {
  Vec3 axis(0);
  axis[static_cast<int>(part)] = 1;
  return axis;
}

void draw_body(Vec2 at, bool pointed_at, bool firing, ImDrawList& list) {
  const float radius = pointed_at ? kBody + 1.5f : kBody;
  list.AddCircleFilled(to_im(at), radius + 2, kShade);
  list.AddCircleFilled(to_im(at), radius, IM_COL32(0x1b, 0x1f, 0x26, 255));
  list.AddCircle(to_im(at), radius, firing ? colours::accent() : colours::kPictureText, 0, 2);
  if (firing) list.AddCircleFilled(to_im(at), 3.5f, colours::accent());
}

void draw_target(Vec2 at, bool pointed_at, ImDrawList& list) {
  const float radius = pointed_at ? kTarget + 1.5f : kTarget;
  list.AddCircle(to_im(at), radius, kShade, 0, 4);
  list.AddCircle(to_im(at), radius, colours::kPictureText, 0, 1.6f);
  list.AddCircleFilled(to_im(at), 1.8f, colours::kPictureText);
}

constexpr const char* kAtKey = "at";
constexpr const char* kTargetKey = "target";
constexpr const char* kInShotsKey = "in_shots";
constexpr const char* kPaceKey = "pace";

constexpr double kEmitterAway = 0.35;  // diagonals of the world
constexpr const char* kNoEnergy =
    "Shots last no time and emit no energy in the thermal model: select Continuous, or the geometric model.";

class EmitterFeature : public Feature {
 public:
  explicit EmitterFeature(Workspace& workspace) : workspace_(workspace) {}

  std::vector<PanelPart> panel_parts() override {
    return {{"laser.emitter", [this] { draw_rows(); }}};
  }
  std::vector<UserAction> actions() override { return emitter_actions(); }
  std::vector<Gesture> gestures() const override {
    return {{"move_emitter", "Left drag on the emitter", "Move it; drag the ring at its target to aim it"}};
  }

  std::unique_ptr<Interaction> begin_interaction(const Press&) override {
    const auto handle =
        handle_under(emitter_handles(emitter_, PrimaryViewport(workspace_.view)), workspace_.input.pointer);
    if (!handle || workspace_.view.in_second) return nullptr;
    end_exploded_view(workspace_.world(), workspace_.view);
    emitter_.take(handle->part, workspace_.input.pointer);
    return std::make_unique<PlainDrag>("Moving the emitter",
                                       [this](const InputEvent& event) { drag(event.seconds); });
  }
  bool cancel() override { return std::exchange(emitter_.firing, false); }
  void update(double) override {
    if (workspace_.input.held == nullptr) keep();
    if (std::exchange(workspace_.links.stops_emitter, false)) emitter_.firing = false;
    if (!workspace_.changes.is_pending()) follow_switch(workspace_.screen.clock->seconds());
  }
  void on_document_opened() override {
    emitter_ = emitter_of_entry(head_entry(workspace_.session.scene, kEmitterKey));
    kept_ = emitter_entry(emitter_);
  }
  bool needs_redraw() const override { return emitter_.firing && emitter_.in_shots; }

  void draw_overlay(ImDrawList& list) override {
    const Area& first = workspace_.view.layout.first;
    list.PushClipRect(to_im(first.at), to_im(first.at + first.size), true);
    draw_emitter(emitter_, PrimaryViewport(workspace_.view), workspace_.input.pointer_in_viewport(), list);
    list.PopClipRect();
    if (!emitter_.firing) return;
    workspace_.services.badges.draw(workspace_.view, Badges::Sign::kMode,
                                    with_shortcut(workspace_.view, "The emitter is firing.", "emitter.fire"),
                                    "emitter badge");
  }
  void add_landmarks(Landmarks& landmarks) const override {
    mark_handles(emitter_handles(emitter_, PrimaryViewport(workspace_.view)), landmarks);
  }
  void write_session_log(nlohmann::ordered_json& report) const override {
    report["emitter"] = {{"placed", emitter_.placed()},
                         {"at", vector_json(emitter_.at())},
                         {"target", vector_json(emitter_.target())},
                         {"firing", emitter_.firing},
                         {"in_shots", emitter_.in_shots},
                         {"pace", emitter_.pace.per_second()}};
  }

 private:
  std::vector<UserAction> emitter_actions() {
    const auto no_emitter_reason = [this] { return emitter_.placed() ? nullptr : "Place an emitter first."; };
    return {
        make_action("emitter.place", "Place Emitter", "Shift+U",
                    "Places a laser in the scene, aimed at the centre of the viewport.", [this] { place(); }),
        make_action(
            "emitter.fire", "Fire Emitter", "U",
            "Switches the emitter on or off. The Laser panel sets whether it is continuous or pulsed.",
            [this] { emitter_.firing = !emitter_.firing; },
            {.disabled_reason = no_emitter_reason, .checked = [this] { return emitter_.firing; }}),
        make_action("emitter.remove", "Remove Emitter", "", "Removes the emitter from the scene.",
                    [this] { emitter_.remove(); }, {.disabled_reason = no_emitter_reason}),
    };
  }
  // Keeps members of the entry that the emitter does not have, such as the radius that the game writes.
  void keep() {
    nlohmann::json entry = emitter_entry(emitter_);
    if (entry == kept_) return;
    nlohmann::json whole = head_entry(workspace_.session.scene, kEmitterKey);
    if (whole.is_object() && entry.is_object()) {
      whole.update(entry);
    } else {
      whole = entry;
    }
    set_head_entry(workspace_.session.scene, kEmitterKey, whole);
    kept_ = std::move(entry);
  }
  // Moves or aims the emitter. If it fires, its beam follows each move of the pointer.
  void drag(double now) {
    emitter_.drag(PrimaryViewport(workspace_.view), workspace_.input.pointer,
                  point_under_pointer(workspace_));
    if (emitter_.drawing) workspace_.beam.carry_to(workspace_.session.document, emitter_.pose(), now);
  }
  // Draws buttons that place, switch and remove the emitter, and its pace, position and target.
  void draw_rows() {
    if (!emitter_.placed()) {
      const std::string meaning = with_shortcut(
          workspace_.view, "Places a laser in the scene; move and aim it by its handles.", "emitter.place");
      if (row_button("Place Emitter", 1, nullptr, meaning.c_str())) place();
      return;
    }
    const std::string meaning =
        with_shortcut(workspace_.view, "Switches the emitter on or off.", "emitter.fire");
    if (row_button(emitter_.firing ? "Stop###fire" : "Fire###fire", 2, nullptr, meaning.c_str()))
      emitter_.firing = !emitter_.firing;
    mark_last_item("fire");
    ImGui::SameLine();
    const bool removed = row_button("Remove", 2, nullptr, "Removes the emitter from the scene.");
    if (!begin_properties("emitter")) return;
    draw_pace();
    Vec3 at = emitter_.at(), target = emitter_.target();
    const NumberUnit unit = file_unit(workspace_.view.frame.unit);
    const double size = workspace_.world().loaded_bounds().diagonal();
    if (fields_.vector("Position", at, "%.5g", "Position of the emitter, in the unit of the file.", unit,
                       size)) {
      if (at == emitter_.target())
        report_refused_entry("Position stays the same: it must differ from the target");
      emitter_.move_to(at);
    }
    if (fields_.vector("Target", target, "%.5g", "Target of the emitter, in the unit of the file.", unit,
                       size)) {
      if (target == emitter_.at())
        report_refused_entry("Target stays the same: it must differ from the position");
      emitter_.aim_at(target);
    }
    end_properties();
    if (removed) emitter_.remove();
  }
  void draw_pace() {
    constexpr std::array kKinds{"Continuous", "Pulsed"};
    int kind = emitter_.in_shots ? 1 : 0;
    marked_choice_row(
        "Mode", "##fires", kind, kKinds, "emitter fires",
        "Continuous: one stroke follows the motion of the emitter. Pulsed: each shot at a steady "
        "rate is a stroke.");
    emitter_.in_shots = kind == 1;
    if (!emitter_.in_shots) return;
    double pace = emitter_.pace.per_second();
    if (fields_.number("Shot Rate", pace, "%.3g shots/s",
                       "Shots per second, 0.1 to 60. A shot waits until the previous one is cut.", {},
                       {FirePace::kSlowest, FirePace::kFastest}))
      emitter_.pace.set(pace);
  }
  void place() {
    end_exploded_view(workspace_.world(), workspace_.view);
    const double diagonal = workspace_.world().bounds().diagonal();
    const CameraView view = workspace_.view.seen_first();
    const auto surface = surface_point(workspace_.world(), workspace_.view.look, view.ray(0, 0));
    place_in_view(emitter_, view, surface ? surface->at : workspace_.view.camera.pivot(),
                  diagonal > 0 ? kEmitterAway * diagonal : 1);
  }
  // Begins, continues or ends the stroke of the emitter as switched, or fires the due shot. A stroke that
  // another command ended in the document switches the emitter off.
  void follow_switch(double now) {
    LaserTool& beam = workspace_.beam;
    const bool in_stroke = workspace_.session.document.queue().in_stroke();
    if (emitter_.drawing && beam.has_begun() && !in_stroke) cancel_stroke(workspace_);
    const bool ended_elsewhere =
        (emitter_.drawing && !beam.cutting()) || (workspace_.input.held && workspace_.input.held->cuts());
    if (ended_elsewhere) emitter_.firing = emitter_.drawing = false;
    if (workspace_.opening.loader.busy()) emitter_.firing = false;
    if (emitter_.in_shots && !emitter_.drawing) return fire_shots(now);
    const bool on = emitter_.firing && !emitter_.in_shots;
    if (on && !emitter_.drawing) {
      begin_fire(now);
    } else if (on) {
      beam.carry_to(workspace_.session.document, emitter_.pose(), now);
    } else if (emitter_.drawing) {
      cancel_stroke(workspace_);
    }
    emitter_.drawing = on;
  }
  void begin_fire(double now) {
    cancel_stroke(workspace_);
    end_exploded_view(workspace_.world(), workspace_.view);
    KERF_ASSERT(emitter_.placed());
    workspace_.beam.fire(workspace_.session.document, emitter_.pose(), emitter_.distance(),
                         workspace_.laser.settings(workspace_.world().bounds().diagonal()), now);
    workspace_.links.cut_once = true;
  }
  // A shot waits until the last one is cut. A shot that hits nothing would be an empty history entry.
  void fire_shots(double now) {
    const Document& document = workspace_.session.document;
    if (!emitter_.firing) return emitter_.pace.begin();
    if (workspace_.laser.model == Model::kThermal) {
      emitter_.firing = false;
      return workspace_.message.error(kNoEnergy);
    }
    if (workspace_.beam.cutting() || document.waiting() > 0 || !emitter_.pace.is_due(now)) return;
    emitter_.pace.take(now);
    const Laser laser = workspace_.laser.settings(workspace_.world().bounds().diagonal()).laser;
    if (!hits_anything(workspace_.world(), laser, emitter_.pose())) return;
    begin_fire(now);
    workspace_.beam.release(workspace_.session.document);
  }

  Workspace& workspace_;
  Emitter emitter_;
  nlohmann::json kept_;  // entry stored in the head of the document
  NumberFields fields_;
};

}  // namespace

void Emitter::place(const Vec3& at, const Vec3& target) {
  KERF_ASSERT(at != target);
  placed_ = true;
  at_ = at;
  target_ = target;
}

Pose Emitter::pose() const { return {at_, beam_direction(target_ - at_)}; }

void Emitter::move_to(const Vec3& at) {
  if (at == target_) return;
  held_at_ += at - at_;
  at_ = at;
}

void Emitter::aim_at(const Vec3& target) {
  if (target != at_) target_ = target;
}

void Emitter::take(Part part, Vec2 pointer) {
  held_ = part;
  pressed_at_ = pointer;
  held_at_ = at_;
}

// Moving the emitter keeps its target.
void Emitter::drag(const PrimaryViewport& picture, Vec2 pointer, const std::optional<Vec3>& surface) {
  if (held_ == Part::kTarget) return aim_at(surface ? *surface : picture.at_depth_of(target_, pointer));
  Vec3 to = held_at_;
  if (held_ == Part::kBody) {
    to += picture.at_depth_of(held_at_, pointer) - picture.at_depth_of(held_at_, pressed_at_);
  } else {
    const Vec3 axis = axis_of(held_);
    to += axis * dragged_along(picture.ray(pressed_at_), picture.ray(pointer), held_at_, axis);
  }
  if (to != target_) at_ = to;
}

void place_in_view(Emitter& emitter, const CameraView& view, const Vec3& target, double distance) {
  KERF_ASSERT(distance > 0);
  const Vec3 towards = glm::normalize(0.4 * view.right + 0.7 * view.up - 0.6 * view.forward);
  emitter.place(target + towards * distance, target);
}

std::vector<EmitterHandle> emitter_handles(const Emitter& emitter, const PrimaryViewport& picture) {
  std::vector<EmitterHandle> handles;
  if (!emitter.placed()) return handles;
  handles.push_back({{picture, "emitter target", {emitter.target()}}, Part::kTarget});
  if (!picture.place_of(emitter.at())) return handles;
  constexpr std::array kArrows{"emitter X", "emitter Y", "emitter Z"};
  for (const Part part : {Part::kX, Part::kY, Part::kZ}) {
    handles.push_back({{picture, kArrows.at(static_cast<size_t>(part)),
                        gizmo_arrow(picture, emitter.at(), axis_of(part), kHandleEms), 1},
                       part});
    handles.back().free_share = kFreeShare;
  }
  handles.push_back({{picture, "emitter body", {emitter.at()}}, Part::kBody});
  return handles;
}

void draw_emitter(const Emitter& emitter, const PrimaryViewport& picture, Vec2 pointer, ImDrawList& list) {
  const std::vector<EmitterHandle> handles = emitter_handles(emitter, picture);
  const auto under = handle_under(handles, pointer);
  const auto at = picture.place_of(emitter.at()), target = picture.place_of(emitter.target());
  if (emitter.placed() && at && target && !emitter.drawing) {
    list.AddLine(to_im(*at), to_im(*target), kShade, 3.4f);
    list.AddLine(to_im(*at), to_im(*target), colours::kPictureSecondary, 1.2f);
  }
  for (const EmitterHandle& handle : handles) {
    const bool pointed_at = under && under->part == handle.part;
    if (handle.part == Part::kTarget) {
      if (target) draw_target(*target, pointed_at, list);
    } else if (handle.part == Part::kBody) {
      draw_body(*at, pointed_at, emitter.firing, list);
    } else {
      draw_handle(handle, picture.em(),
                  pointed_at ? colours::kPictureText : colours::kAxes.at(static_cast<size_t>(handle.part)),
                  list);
    }
  }
}

nlohmann::json emitter_entry(const Emitter& emitter) {
  if (!emitter.placed()) return nullptr;
  return {{kAtKey, vector_json(emitter.at())},
          {kTargetKey, vector_json(emitter.target())},
          {kInShotsKey, emitter.in_shots},
          {kPaceKey, emitter.pace.per_second()}};
}

Emitter emitter_of_entry(const nlohmann::json& entry) {
  Emitter emitter;
  const JsonValue value(entry, "emitter");
  if (!value.has(kAtKey) || !value.has(kTargetKey)) return emitter;
  const Result<Vec3> at = value[kAtKey].vector(), target = value[kTargetKey].vector();
  if (!at || !target || *at == *target) return emitter;
  emitter.place(*at, *target);
  if (value.has(kInShotsKey)) (void)assign(value[kInShotsKey].flag(), emitter.in_shots);
  double pace = emitter.pace.per_second();
  if (value.has(kPaceKey)) (void)assign(value[kPaceKey].number(), pace);
  emitter.pace.set(pace);
  return emitter;
}

std::unique_ptr<Feature> emitter_feature(Workspace& workspace) {
  return std::make_unique<EmitterFeature>(workspace);
}

}  // namespace kerf
