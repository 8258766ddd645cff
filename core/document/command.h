#pragma once

#include <concepts>
#include <variant>

#include "core/document/commands/add_mesh.h"
#include "core/document/commands/advance.h"
#include "core/document/commands/begin_stroke.h"
#include "core/document/commands/delete_piece.h"
#include "core/document/commands/end_stroke.h"
#include "core/document/commands/hide_piece.h"
#include "core/document/commands/move_piece.h"
#include "core/document/commands/move_stroke.h"
#include "core/document/commands/recut.h"
#include "core/document/commands/redo.h"
#include "core/document/commands/rename_piece.h"
#include "core/document/commands/undo.h"

namespace kerf {

// Everything that changes the world is one of these. A stroke is its beginning, poses in world coordinates
// and its end, never pixels, so the journal of commands gives the same world wherever it is replayed.
//
// Each kind of command is one pair of files in core/document/commands. Its struct has, beside its data:
//   kName, kKeys, kOptionalKeys   its name and its keys in a journal
//   words()                       what it does, for people: "Stroke, radius 4 mm"
//   weight()                      bytes that it holds beside its own size
//   write(), read()               its keys as text, see CommandWriter and CommandReader
// A kind that lacks one of these does not compile, and neither does one that is missing where commands are
// told apart, which is done by std::visit everywhere.
using Command = std::variant<BeginStroke, MoveStroke, EndStroke, Recut, Advance, AddMesh, MovePiece,
                             HidePiece, DeletePiece, RenamePiece, Undo, Redo>;

// A command that changes the world in one go, after all that waits: run(world, generation, progress). The
// delta says what changed and is empty where there was nothing to do. `generation` is that of the bodies that
// it makes (see BodyId). On failure the world is as it was.
template <typename C>
concept HappensAtOnce = requires(const C& command, World& world) {
  { command.run(world, uint32_t{}, nullptr) } -> std::same_as<Result<Delta>>;
};

// Function objects for std::visit, one for each kind of command or for some of them.
template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace kerf
