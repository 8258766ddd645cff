#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/remesh/remeshed.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// A piece as people are told of it: "piece 2 of body 1".
std::string piece_words(const PieceId& piece);

// Whether the world has the piece, with at least one face.
bool has_faces(const World& world, const PieceId& piece);
// Bad input: it has not.
Error no_such_piece(const PieceId& piece);

// Makes the piece a body of its own of this generation, where it is not one already (see detach), and lets
// `edit` change it, which the list `told` of the delta tells. The delta is empty where `differs`, asked about
// the body that the piece is in, says that there is nothing to change. Bad input where there is no such
// piece; the world is unchanged then.
Result<Delta> edit_piece(World& world, const PieceId& piece, uint32_t generation,
                         std::vector<BodyId> Delta::*told, const std::function<bool(const Body&)>& differs,
                         const std::function<void(Body&)>& edit);

// The faces of a mesh that a tool has to heed, each list ascending.
struct HeededFaces {
  std::vector<FaceId> kept;  // that must stay
  std::vector<FaceId> warm;  // that have energy or were hot
};

// Makes a new mesh of one.
using Remake =
    std::function<Result<Remeshed>(const Mesh& mesh, const HeededFaces& heeded, const Progress* progress)>;

// Replaces a piece by a new body of this generation with the mesh that `remake` makes of it. The body has the
// label, the name, the placement and all else of the piece; its faces are as loaded, with the materials, the
// energy and the names of parts of those from which they stem. Faces that carry joints stay, and so do the
// joints. The delta is empty where the mesh stays what it is.
//
// Bad input where there is no such piece, or where joints hold it to another one that moves by itself: the
// joint could not name both. Fails like `remake`, where no face would be left, and with cancelled() when
// stopped; `progress` may be null. On failure the world is unchanged. O(n log n) besides `remake`.
Result<Delta> remake_piece(World& world, const PieceId& piece, uint32_t generation, const Remake& remake,
                           const Progress* progress);

}  // namespace kerf
