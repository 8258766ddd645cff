#pragma once

#include <memory>
#include <vector>

#include "core/world/world.h"
#include "ui/editor/shared/workspace.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/view_options.h"

struct ImDrawList;

namespace kerf {

// A box that is drawn with the mouse to choose pieces, as in CAD programs: drawn from left to right it
// chooses the pieces that lie wholly in it, from right to left also those that it touches. What is in front
// of a piece does not matter.
struct RubberBand {
  Vec2 from{0}, to{0};
  bool touching() const { return to.x < from.x; }
  Vec2 low() const { return glm::min(from, to); }
  Vec2 high() const { return glm::max(from, to); }
};

// The pieces that a box chooses, among those that are shown, where they are drawn. Its corners are points of
// the picture, as in CameraView::ray. Faces behind the eye are outside. O(n) in the number of faces.
std::vector<PieceId> pieces_in(const RubberBand& band, const World& world, const ViewOptions& look,
                               const CameraView& view);

// Draws the box; its corners are in screen coordinates of the window. One that touches is dashed.
void draw_rubber_band(const RubberBand& band, ImDrawList& list);

// What a press in the picture begins that chooses pieces: a click chooses the piece under the pointer, a drag
// those in a box; with Shift they are added to those that are chosen.
std::unique_ptr<Interaction> press_on_pieces(Workspace& workspace);

// Hides all pieces but the chosen ones, and shows again those that were hidden by it, and no others.
class Isolation {
 public:
  // The workspace must outlive it.
  explicit Isolation(Workspace& workspace) : workspace_(workspace) {}

  // Asks for the change. Precondition: disabled_reason() is null.
  void change();
  // The sentence why nothing can be isolated nor shown again, or null.
  const char* disabled_reason() const;

  // To be called after each change of the world, and when another document is open.
  void follow();
  void forget() { isolated_from_.clear(); }

 private:
  std::vector<PieceId> to_show_again() const;

  Workspace& workspace_;
  std::vector<BodyId> isolated_from_;                 // bodies that are hidden because others were isolated
  std::optional<std::vector<BodyId>> hidden_before_;  // while an isolation is going on
};

}  // namespace kerf
