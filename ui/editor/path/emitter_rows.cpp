#include "ui/editor/path/emitter_rows.h"

#include <imgui.h>

#include <array>

#include "ui/editor/shared/shortcut_text.h"
#include "ui/window/landmarks.h"
#include "ui/window/property.h"
#include "ui/window/row_button.h"

namespace kerf {

void EmitterRows::draw_pace(Emitter& emitter) {
  constexpr std::array kKinds{"Without a break", "In shots"};
  property("Fires");
  if (ImGui::BeginCombo("##fires", kKinds.at(emitter.in_shots ? 1 : 0))) {
    for (int i = 0; i < 2; ++i) {
      if (ImGui::Selectable(kKinds.at(static_cast<size_t>(i)), emitter.in_shots == (i == 1)))
        emitter.in_shots = i == 1;
      mark_last_item("emitter fires", i);
    }
    ImGui::EndCombo();
  } else {
    mark_last_item("emitter fires");
    tooltip(
        "Without a break: what the emitter is moved over is one stroke. In shots: at a steady pace, each "
        "shot a stroke of its own that undo takes back. A shot that meets nothing is none.");
  }
  if (!emitter.in_shots) return;
  double pace = emitter.pace.per_second();
  if (fields_.number("Pace", pace, "%.3g shots/s",
                     "How many shots are fired a second, from 0.1 to 60. A shot waits until the last one is "
                     "cut."))
    emitter.pace.set(pace);
}

void EmitterRows::draw(Emitter& emitter, const ViewState& view, const std::function<void()>& place) {
  if (!emitter.placed()) {
    const std::string meaning = with_shortcut(
        view, "A laser that stands in the scene. It is moved and aimed by handles.", "Place the emitter");
    if (row_button("Place an emitter", 1, nullptr, meaning.c_str())) place();
    return;
  }
  const std::string meaning = with_shortcut(view, "Switches the emitter on or off.", "Fire the emitter");
  if (row_button(emitter.firing ? "Switch off###fire" : "Fire###fire", 2, nullptr, meaning.c_str()))
    emitter.firing = !emitter.firing;
  mark_last_item("fire");
  ImGui::SameLine();
  const bool removed = row_button("Take away", 2, nullptr, "Takes the emitter out of the scene.");
  if (!begin_properties("emitter")) return;
  draw_pace(emitter);
  Vec3 at = emitter.at(), target = emitter.target();
  if (fields_.vector("Stands at", at, "%.5g", "X, Y and Z of the emitter, in the unit of the file."))
    emitter.stand_at(at);
  if (fields_.vector("Aims at", target, "%.5g", "X, Y and Z of what it aims at, in the unit of the file."))
    emitter.aim_at(target);
  end_properties();
  if (removed) emitter.remove();
}

}  // namespace kerf
