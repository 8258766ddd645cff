#include "ui/editor/panels/view_panel.h"

#include <imgui.h>

#include "ui/window/property.h"

namespace kerf {

void draw_view_panel(EditorState& state) {
  ViewOptions& look = state.look;
  struct Switch {
    const char* label;
    const char* meaning;
    bool& on;
  };
  const std::array switches{
      Switch{"Level colouring",
             "Small faces glow: the smaller a face against the one it was split from, the hotter.",
             look.level_colours},
      Switch{"Wire (W)", "Edges of the faces.", look.show.wire},
      Switch{"Face numbers (I)",
             "The number of each face, and in red of those that are gone (figure 8 of the paper).",
             look.show.face_numbers},
      Switch{"Piece colours (P)", "Every piece that came off in a strong colour of its own.",
             look.show.pieces},
      Switch{"Normals (N)", "A short line out of the front of every face.", look.show.normals},
      Switch{"Shadows (D)", "Of everything on everything; how is said in the Light panel.",
             look.show.shadows},
      Switch{
          "Silhouette (E)",
          "The edges that bound the shadow of a light (figure 11 of the paper): pale where one side lies on "
          "them, blue where two do, violet where more.",
          look.show.silhouette},
      Switch{
          "Shadow volumes (V)",
          "What the silhouette is extruded to (figure 12): blue where it is seen from outside, orange from "
          "within.",
          look.show.shadow_volumes},
      Switch{"Shadow counts (C)",
             "How many surfaces keep the light away, by the strip at the lower left; 9: or more.",
             look.show.shadow_stencil},
      Switch{"Facing the light (T)", "Polygons that face the light are pale, averted ones blue.",
             look.show.shadow_facing},
      Switch{"Ghost of what is gone (G)", "Removed faces stay as a faint veil.", look.ghost},
      Switch{"Two-sided lighting", "Faces are lit from both sides; off, their backs are black.",
             look.two_sided},
      Switch{
          "Cull backs",
          "Leaves out the faces that are seen from behind, as is usual for closed models and faster. The "
          "paper had to turn it off: once a hole is cut, one looks through it at the backs of the far side, "
          "and with culling there is nothing there.",
          look.cull_backs},
      Switch{"Anti-aliasing", "Smooth edges; off is faster without a graphics card.", look.antialias},
  };
  for (const Switch& s : switches) {
    if (ImGui::Checkbox(s.label, &s.on)) state.picture_old = true;
    tooltip(s.meaning);
  }
}

}  // namespace kerf
