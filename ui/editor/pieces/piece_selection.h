#pragma once

#include <memory>
#include <vector>

#include "core/world/world.h"
#include "ui/editor/shared/workspace.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/view_options.h"

struct ImDrawList;

namespace kerf {

// A selection box, as in CAD programs: drawn from left to right it selects the pieces inside it, from right
// to left also those that it touches. Occluded pieces are included.
struct RubberBand {
  Vec2 from{0}, to{0};
  bool touching() const { return to.x < from.x; }
  Vec2 low() const { return glm::min(from, to); }
  Vec2 high() const { return glm::max(from, to); }
};

// Returns the visible pieces that a box selects, at the places where they are drawn. Corners as in
// CameraView::ray. Faces behind the eye are outside. O(n) in the number of faces.
std::vector<PieceId> pieces_in(const RubberBand& band, const World& world, const ViewOptions& look,
                               const CameraView& view);

// Draws the box, dashed if it selects touched pieces. Corners are in the window, in screen coordinates.
void draw_rubber_band(const RubberBand& band, ImDrawList& list);

// Interaction of a press that selects pieces: a click selects the piece under the pointer, a drag those in a
// box; Shift adds them to the selection.
std::unique_ptr<Interaction> press_on_pieces(Workspace& workspace);

// Hides all pieces except the selected ones, and shows again only those that it hid.
class Isolation {
 public:
  // The workspace must outlive it.
  explicit Isolation(Workspace& workspace) : workspace_(workspace) {}

  // Requests the change. Precondition: disabled_reason() is null.
  void change();
  // Returns why nothing can be isolated or shown again, as a sentence, or null.
  const char* disabled_reason() const;

  // Call follow() after each change of the world, and forget() when another document is opened.
  void follow();
  void forget() { isolated_from_.clear(); }

 private:
  std::vector<PieceId> to_show_again() const;

  Workspace& workspace_;
  std::vector<BodyId> isolated_from_;                 // bodies hidden by isolation
  std::optional<std::vector<BodyId>> hidden_before_;  // while an isolation is in progress
};

}  // namespace kerf
