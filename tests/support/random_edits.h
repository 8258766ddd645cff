#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/random.h"
#include "core/document/commands.h"
#include "core/world/world.h"

namespace kerf::test {

// A square of two triangles, as the text of an OBJ file.
inline constexpr const char* kPlateObj =
    "v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0 0.5\nv -0.5 0 0.5\nf 1 4 3\nf 1 3 2\n";

// A random piece that has faces; nothing if the world has no faces.
std::optional<PieceId> random_piece(const World& world, Random& random);

// The commands of a random edit of a world of such plates: a stroke that cuts across them, a plate from the
// file `mesh` that is added, an edit of a random piece, or a step back or forth in the history.
std::vector<Command> random_edit(const World& world, const std::filesystem::path& mesh, Random& random);

}  // namespace kerf::test
