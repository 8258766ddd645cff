#include "ui/editor/path/emitter_rows.h"

#include <imgui.h>

#include "ui/window/landmarks.h"
#include "ui/window/property.h"
#include "ui/window/row_button.h"

namespace kerf {

void EmitterRows::draw(Emitter& emitter, const std::function<void()>& place) {
  if (!emitter.placed()) {
    if (row_button("Place an emitter", 1, nullptr,
                   "A laser that stands in the scene. It is moved and aimed by handles (Shift+U)."))
      place();
    return;
  }
  if (row_button(emitter.firing ? "Switch off###fire" : "Fire###fire", 2, nullptr,
                 "Switches the emitter on or off (U). While it is on, what it is moved over is one stroke."))
    emitter.firing = !emitter.firing;
  mark_last_item("fire");
  ImGui::SameLine();
  const bool removed = row_button("Take away", 2, nullptr, "Takes the emitter out of the scene.");
  if (!begin_properties("emitter")) return;
  Vec3 at = emitter.at(), target = emitter.target();
  if (fields_.vector("Stands at", at, "%.5g", "X, Y and Z of the emitter, in the unit of the file."))
    emitter.stand_at(at);
  if (fields_.vector("Aims at", target, "%.5g", "X, Y and Z of what it aims at, in the unit of the file."))
    emitter.aim_at(target);
  end_properties();
  if (removed) emitter.remove();
}

}  // namespace kerf
