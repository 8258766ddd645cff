#pragma once

#include <memory>
#include <set>
#include <vector>

#include "core/document/document.h"
#include "core/world/world.h"
#include "ui/editor/shared/piece_set.h"
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

// A closed polygon drawn by hand, which selects the pieces inside it, including occluded ones. A point is
// inside if a ray from it crosses the polygon an odd number of times.
class Lasso {
 public:
  // Precondition: there are at least three points.
  explicit Lasso(std::vector<Vec2> points);

  // Takes constant time for evenly distributed edges. Method: only edges at the height of the point are
  // tested, from lists of those in horizontal bands.
  bool contains(Vec2 p) const;

 private:
  size_t band_of(double y) const;

  std::vector<Vec2> points_;
  Vec2 low_{0}, high_{0};
  std::vector<std::vector<uint32_t>> bands_;  // edges by band; edge i ends at point i
};

// Return the visible pieces that a box or a lasso selects, at the places where they are drawn. Points as in
// CameraView::ray. Faces behind the eye are outside, and those that the section plane removes do not count.
// O(n) in the number of faces.
std::vector<PieceId> pieces_in(const RubberBand& band, const World& world, const ViewOptions& look,
                               const CameraView& view);
std::vector<PieceId> pieces_in(const Lasso& lasso, const World& world, const ViewOptions& look,
                               const CameraView& view);

// Returns the distance [m, > 0] within which the rims of two pieces count as neighbours: somewhat more than
// the width of the widest cut in the history, so that pieces which a cut parted are neighbours while they lie
// in place. Without cuts, pieces are neighbours only if their rims touch. O(steps).
double neighbour_reach(const Document& document);

// Returns the visible pieces outside a set with a rim within `reach` [m, > 0] of a rim of the set. A rim is
// an edge with one face, or of a wall. Method: points on the rims of the set, half a reach apart, in a grid;
// an edge has at most 64, so that rims more than 32 reaches long may be missed between vertices.
// O(n log n) in the edges.
std::set<PieceId> neighbours_of(const std::set<PieceId>& pieces, const World& world, double reach,
                                const PieceMap& looks);

// Add all neighbours to the selection, and remove the pieces with a visible neighbour that is not selected.
void grow_selection(const Document& document, PieceMap& looks);
void shrink_selection(const Document& document, PieceMap& looks);

enum class SelectionShape { kBox, kLasso };

// Interaction of a press that selects pieces: a click selects the piece under the pointer, a drag those in a
// box or lasso. Shift adds them to the selection, and Ctrl removes them with the Select tool.
std::unique_ptr<Interaction> press_on_pieces(Workspace& workspace, SelectionShape shape);

}  // namespace kerf
