#include "ui/window/frame_combos.h"

#include <imgui.h>

#include "ui/window/landmarks.h"
#include "ui/window/property.h"

namespace kerf {

bool unit_combo(FileUnit& unit) {
  int chosen = static_cast<int>(unit);
  const bool changed = ImGui::Combo("##unit", &chosen, "mm\0cm\0m\0in\0");
  mark_last_item("unit");
  tooltip("What one unit of the file is. It changes the lengths in labels, never positions.");
  if (changed) unit = static_cast<FileUnit>(chosen);
  return changed;
}

bool up_axis_combo(UpAxis& up) {
  int chosen = static_cast<int>(up);
  const bool changed = ImGui::Combo("##up", &chosen, "+Y\0+Z\0");
  mark_last_item("up axis");
  tooltip("The axis of the file that points upwards. It turns the picture, never positions.");
  if (changed) up = static_cast<UpAxis>(chosen);
  return changed;
}

}  // namespace kerf
