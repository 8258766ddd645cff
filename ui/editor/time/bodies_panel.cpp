#include "ui/editor/time/bodies_panel.h"

#include <imgui.h>

#include "ui/editor/shared/length_field.h"
#include "ui/editor/shared/shortcut_text.h"
#include "ui/editor/shared/switch_row.h"
#include "ui/render/view/drawn_ground.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"
#include "ui/window/row_button.h"

namespace kerf {

namespace {

void draw_time(Workspace& on, PlayState& play) {
  const char* why_not = on.why_time_stands_still();
  const auto told = [&](const char* meaning, const char* action) {
    return with_shortcut(on.view, meaning, action);
  };
  if (row_button(play.playing ? "Pause###play" : "Play###play", 2, play.playing ? nullptr : why_not,
                 told("Pieces that came off fall, or everything stands still again.", "Play").c_str()))
    play.play_or_pause();
  mark_last_item("bodies play");
  ImGui::SameLine();
  if (row_button("One tick", 2, why_not, told("Lets 1/120 s pass.", "One tick").c_str())) play.ask_for_tick();
  mark_last_item("bodies tick");
}

void draw_speed(PlayState& play) {
  property("Speed");
  if (ImGui::BeginCombo("##speed", play.speed().name)) {
    for (size_t i = PlayState::kSpeeds.size(); i-- > 0;) {
      if (ImGui::Selectable(PlayState::kSpeeds.at(i).name, i == play.speed_index)) play.speed_index = i;
    }
    ImGui::EndCombo();
  } else {
    tooltip("How fast time passes, against real time. It passes more slowly where a tick takes longer.");
  }
}

void draw_pin(Workspace& on) {
  const bool pinned = chosen_are_pinned(on.world(), on.view);
  if (row_button(pinned ? "Unpin the chosen###pin" : "Pin the chosen###pin", 1, why_no_pin(on.view),
                 with_shortcut(on.view, "What is pinned stays where it is while other pieces move.",
                               "Pin the chosen")
                     .c_str()))
    ask_to_pin(on, !pinned);
  mark_last_item("bodies pin");
}

void draw_figures(const TickFigures& figures) {
  if (figures.bodies == 0) return;
  ImGui::TextDisabled("%s bodies, %s awake, %s contacts", grouped(figures.bodies).c_str(),
                      grouped(figures.awake).c_str(), grouped(figures.contacts).c_str());
  tooltip("What the last tick in which bodies moved found.");
}

}  // namespace

void BodiesPanel::draw_surroundings(Workspace& on) {
  const World& world = on.work.document.world();
  const FileFrame& frame = on.view.frame;
  Surroundings around = world.surroundings();
  const double metres = metres_per_unit(frame.unit);
  bool gravity = around.gravity != Vec3(0);
  property("Gravity");
  if (ImGui::Checkbox("##gravity", &gravity)) on.changes.ask(with_gravity(world, frame, gravity));
  mark_last_item("gravity on");
  tooltip("Without gravity pieces float apart.");
  if (!around.ground) around = usual_surroundings(world, frame);
  around.metre = 1 / metres;
  double value = metres * glm::length(around.gravity);
  const Vec3 down = from_y_up({0, -1, 0}, frame.up);
  if (gravity &&
      fields_.number("Its value", value, "%.3g m/s\xc2\xb2", "9.81 on the earth, 1.62 on the moon.") &&
      value > 0) {
    around.gravity = value / metres * down;
    on.changes.ask(SetSurroundings{around});
  }
  double height = around.ground.value_or(0);
  const LengthUnit unit = label_unit(0.1 * world.loaded_bounds().diagonal(), frame.unit);
  if (gravity &&
      length_field(fields_, "Ground", height, unit, "The height of the ground on which pieces rest.")) {
    around.ground = height;
    on.changes.ask(SetSurroundings{around});
  }
}

void BodiesPanel::draw(Workspace& on, PlayState& play) {
  draw_time(on, play);
  if (begin_properties("bodies")) {
    draw_speed(play);
    draw_surroundings(on);
    end_properties();
  }
  draw_pin(on);
  for (const SwitchId id : {SwitchId::kContacts, SwitchId::kColliders, SwitchId::kCentres, SwitchId::kJoints})
    draw_switch(on.view, id);
  draw_figures(on.work.document.execution().physics().figures());
}

}  // namespace kerf
