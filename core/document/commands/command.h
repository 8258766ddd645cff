#pragma once

#include <concepts>
#include <string>
#include <variant>

#include "core/document/commands/piece_commands.h"
#include "core/document/commands/remesh_commands.h"
#include "core/document/commands/stroke_commands.h"
#include "core/document/commands/time_commands.h"
#include "core/document/commands/world_commands.h"

namespace kerf {

// Takes the last step of the history back; a stroke with all its moves is one step.
struct Undo {
  static constexpr const char* kName = "undo";
  std::string words() const { return "Undo"; }
};

// Does the step of the history again that was taken back last.
struct Redo {
  static constexpr const char* kName = "redo";
  std::string words() const { return "Redo"; }
};

// All changes of the world are commands. A stroke consists of a beginning, poses in world coordinates and an
// end; it contains no pixels, so that a journal of commands gives the same world wherever it is replayed.
//
// Each kind of command is a struct in core/document/commands. It has, beside its data:
//   kName      its name in a journal
//   words()    a description for the user, or words(unit) where it names lengths: "Stroke, radius 4 mm",
//              or words(piece_name) where it names a piece
//   weight()   the memory that it owns besides its own size, in bytes; only where it owns some
// and, where it has data, describe() beside it, the table of its keys in a journal (see Fields). Kinds are
// always distinguished by std::visit, so that a case that is missing anywhere does not compile.
using Command = std::variant<BeginStroke, MoveBeam, EndStroke, StopStroke, Recut, AdvanceTime, DragBody,
                             ReleaseBody, Play, AddMesh, MovePiece, DuplicatePiece, HidePiece, DeletePiece,
                             RenamePiece, PinPiece, SetSheetProperties, SetSolid, SimplifyPiece,
                             SubdividePiece, SmoothPiece, TurnShells, SetEnvironment, Undo, Redo>;

// A command that is executed at once, after the queue: run(world, generation, progress). It returns what
// changed, which is empty if the command has no effect. Bodies that it creates get `generation` (see BodyId).
// On failure the world is unchanged.
template <typename C>
concept HappensAtOnce = requires(const C& command, World& world) {
  { command.run(world, uint32_t{}, nullptr) } -> std::same_as<Result<Delta>>;
};

// A command that lets time pass or acts while it passes. It is queued behind the moves before it.
template <typename C>
concept HappensInTime =
    std::same_as<C, AdvanceTime> || std::same_as<C, DragBody> || std::same_as<C, ReleaseBody>;

// Function objects for std::visit, one for each kind of command or for some of them.
template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace kerf
