#pragma once

#include <imgui.h>

namespace kerf {

enum class Icon {
  kLaser,  // a plate with a slit, and the beam that cuts it
  kEye,
  kMove,  // two crossed double arrows
  kThermometer,
  kMesh,  // a triangle, divided into smaller ones
  kPointer,
  kCallipers,  // a distance between two points
  kRuler,
  kPath,     // a curve through points
  kEmitter,  // a fixed lamp with its beam
  kSection,  // a plane through a box
  kRotate,
  kKnife,  // a blade over the line that it cuts
};

// Draws an icon of line art with a radius around its middle, in screen coordinates.
void draw_icon(Icon icon, ImDrawList& list, ImVec2 middle, float radius, ImU32 colour);

}  // namespace kerf
