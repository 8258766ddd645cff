#pragma once

#include <optional>

#include "core/mesh/files/file_frame.h"
#include "core/world/world.h"
#include "ui/editor/shared/picture/view_state.h"

namespace kerf {

// What a move snaps to: whole steps, or a vertex to which the pivot of the piece goes.
struct MoveSnap {
  double step = 0.01;  // in the numbers of the file, > 0
  std::optional<Vec3> vertex;
  static constexpr double kDegrees = 5;  // of a turn
};

// A centimetre where the file has metres or centimetres, a millimetre where it has millimetres, else a tenth
// of an inch.
double snap_step(FileUnit unit);

// The vertex of what is seen under the pointer (screen coordinates), without the piece that is moved, if one
// is seen within about the height of the text. Costs a traversal of each body's tree.
std::optional<Vec3> vertex_near(const World& world, const ViewState& view, Vec2 pointer,
                                const PieceId& moved);

}  // namespace kerf
