#pragma once

#include <concepts>
#include <variant>

#include "core/document/commands/add_mesh.h"
#include "core/document/commands/advance.h"
#include "core/document/commands/begin_stroke.h"
#include "core/document/commands/delete_piece.h"
#include "core/document/commands/duplicate_piece.h"
#include "core/document/commands/end_stroke.h"
#include "core/document/commands/hide_piece.h"
#include "core/document/commands/move_piece.h"
#include "core/document/commands/move_stroke.h"
#include "core/document/commands/pin_piece.h"
#include "core/document/commands/play.h"
#include "core/document/commands/pull.h"
#include "core/document/commands/recut.h"
#include "core/document/commands/redo.h"
#include "core/document/commands/rename_piece.h"
#include "core/document/commands/set_sheet.h"
#include "core/document/commands/set_surroundings.h"
#include "core/document/commands/simplify_piece.h"
#include "core/document/commands/smooth_piece.h"
#include "core/document/commands/stop_stroke.h"
#include "core/document/commands/subdivide_piece.h"
#include "core/document/commands/undo.h"

namespace kerf {

// All changes of the world are commands. A stroke consists of a beginning, poses in world coordinates and an
// end; it contains no pixels, so that a journal of commands gives the same world wherever it is replayed.
//
// Each kind of command is one pair of files in core/document/commands. Its struct has, beside its data:
//   kName      its name in a journal
//   words()    a description for the user: "Stroke, radius 4 mm"
//   weight()   the memory that it owns besides its own size, in bytes
// and describe() beside it, the table of its keys in a journal (see Fields). A kind without one of these does
// not compile. Kinds are always distinguished by std::visit, so that
// a case that is missing anywhere does not compile either.
using Command =
    std::variant<BeginStroke, MoveStroke, EndStroke, StopStroke, Recut, Advance, Pull, LetGo, Play, AddMesh,
                 MovePiece, DuplicatePiece, HidePiece, DeletePiece, RenamePiece, PinPiece, SetSheet,
                 SimplifyPiece, SubdividePiece, SmoothPiece, SetSurroundings, Undo, Redo>;

// A command that is executed at once, after the queue: run(world, generation, progress). It returns what
// changed, which is empty if the command has no effect. Bodies that it creates get `generation` (see BodyId).
// On failure the world is unchanged.
template <typename C>
concept HappensAtOnce = requires(const C& command, World& world) {
  { command.run(world, uint32_t{}, nullptr) } -> std::same_as<Result<Delta>>;
};

// A command that lets time pass or acts while it passes. It is queued behind the moves before it.
template <typename C>
concept HappensInTime = std::same_as<C, Advance> || std::same_as<C, Pull> || std::same_as<C, LetGo>;

// Function objects for std::visit, one for each kind of command or for some of them.
template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace kerf
