#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/world/delta.h"
#include "core/world/world.h"

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

}  // namespace kerf
