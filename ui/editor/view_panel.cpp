#include "ui/editor/view_panel.h"

#include <imgui.h>

#include "ui/editor/property.h"

namespace kerf {

void draw_view_panel(EditorState& state) {
  ShowOptions& show = state.look.show;
  struct Switch {
    const char* label;
    const char* meaning;
    bool& on;
  };
  const std::array switches{
      Switch{"Level colouring",
             "Small faces glow: the smaller a face against the one it was split from, the hotter.",
             state.look.level_colours},
      Switch{"Wire (W)", "Edges of the faces.", show.wire},
      Switch{"Boxes of the tree (B)", "The bounding boxes that find the faces under the beam.", show.aabb},
      Switch{"Boxes that the beam met", "Only the boxes in which the beam is or was.", show.aabb_hit},
      Switch{"Pieces (P)", "Every piece that came off in a strong colour of its own.", show.pieces},
      Switch{"Normals (N)", "A short line out of the front of every face.", show.normals},
      Switch{"Anti-aliasing", "Smooth edges; off is faster without a graphics card.", state.look.antialias},
  };
  for (const Switch& s : switches) {
    if (ImGui::Checkbox(s.label, &s.on)) state.picture_old = true;
    tooltip(s.meaning);
  }
}

}  // namespace kerf
