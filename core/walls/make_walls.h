#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/base/resumable.h"
#include "core/laser/laser.h"
#include "core/mesh/mesh.h"

namespace kerf {

// A side of a live face along a rim, counter-clockwise in that face: a wall has it the other way round.
struct RimSide {
  FaceId face;
  VertexId from, to;
};

// Faces that close the rims that a stroke has left in a solid. Corners below rim.size() are the vertices of
// the rim, the others new ones.
struct WallPatch {
  std::vector<VertexId> rim;
  std::vector<Vec3> added;  // m
  std::vector<std::array<uint32_t, 3>> faces;
  // The connected walls: which one each face of the patch is in, which one each side of the rim is closed by,
  // and for each a face at its rim.
  std::vector<uint32_t> wall_of_face, wall_of_side;
  std::vector<FaceId> beside_wall;
};

// What is needed to know about the stroke, in the frame of the mesh.
struct WallStroke {
  std::span<const BeamMove> moves;
  double radius = 0;  // m, > 0
  Interval range;     // m along the beam
  // The signed distance from the boundary of what the stroke has swept, in metres.
  std::function<double(const Vec3&)> distance;
  // How often the faces that are left wind around a point, as seen along a unit vector that leads away from
  // what was swept.
  std::function<int(const Vec3&, const Vec3&)> winding;
};

// Makes the walls: of the boundary of what a stroke has swept, the part that lies within the solid that the
// sides bound. In the chart of that boundary (see WallChart) the sides are directed edges, and the walls are
// where they wind around once; where the range of the beam ends in the solid, a flat cap closes the wall. The
// vertices of the rim stay; further ones lie on the boundary, so that edges deviate from it by no more than
// kRimNear radii. The faces are counter-clockwise seen from outside of the solid, i.e. from the beam, and
// every edge has two faces with those at the rim.
//
// Fails, with a sentence that says why and where, if there is no such part or it cannot be told.
// Preconditions: `sides` are all sides without another face of some connected parts of the mesh that were
// closed before; until the walls are made, all arguments live and the mesh stays as it is.
Resumable<Result<WallPatch>> make_walls(const Mesh& mesh, std::span<const RimSide> sides,
                                        const WallStroke& stroke);

}  // namespace kerf
