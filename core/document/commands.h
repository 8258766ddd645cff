#pragma once

#include <concepts>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/cut/cut_step.h"
#include "core/document/extract.h"
#include "core/mesh/remesh/openmesh_tools.h"
#include "core/mesh/remesh/remeshed.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

class Fields;

struct BeamAt {
  Pose pose;
  double time = 0;  // s since the stroke began
};

// Begins a stroke: switches the beam on at this pose (world coordinates), at time 0 of the stroke.
struct BeginStroke {
  CutSettings settings;
  Pose pose;

  static constexpr const char* kName = "begin-stroke";
};
void describe(Fields& f, BeginStroke& c);

// Moves the beam of the running stroke with the beam on all the way.
struct MoveBeam {
  Pose pose;        // world coordinates; not opposite to the previous direction
  double time = 0;  // s since the stroke began, not descending; all 0 if times are unknown

  static constexpr const char* kName = "move-beam";
};
void describe(Fields& f, MoveBeam& c);

// Ends the running stroke: switches the beam off and smooths a smooth rim.
struct EndStroke {
  static constexpr const char* kName = "end-stroke";
};

// Ends the last stroke at a place of its path, before the end of its moves, for strokes that take long to
// cut. Belongs to the step of the stroke.
struct StopStroke {
  // The number of moves that are cut, of which the first only switches the beam on: 12.5 are twelve moves
  // and the first half of the next one, rounded to the parts of its subdivision.
  double moves = 0;
  Ticks ticks = 0;  // after those moves, for which the beam stays on while bodies move

  static constexpr const char* kName = "stop-stroke";
};
void describe(Fields& f, StopStroke& c);

// Cuts the last stroke again with other settings.
struct Recut {
  CutSettings settings;

  static constexpr const char* kName = "recut";
};
void describe(Fields& f, Recut& c);

// Advances time by a number of ticks (see core/base/ids.h), in which all changes of the world happen that
// no other command makes. Does not end a running stroke; takes effect when the moves before it have been
// executed.
struct AdvanceTime {
  Ticks ticks = 0;
  bool bodies = false;  // bodies move (see core/physics); begun by Play
  // Belongs to the previous history step, whatever that is, and is undone with it. Otherwise it is a step
  // of its own after an edit (see Document).
  bool joins = false;

  static constexpr const char* kName = "advance-time";
  // Maximum in one line of a journal: each second of a run is a line of its own.
  static constexpr Ticks kMaxInALine = kTicksPerSecond;
};
void describe(Fields& f, AdvanceTime& c);

// Attaches a spring to a piece, or moves the far end of its spring (see Spring). Takes effect between the
// ticks before and after it; bodies follow a spring only while they move.
struct DragBody {
  PieceId piece;
  Vec3 at{0};  // the attached point, in the frame of the body [m]
  Vec3 to{0};  // the far end of the spring, in the world [m]

  static constexpr const char* kName = "drag-body";
};
void describe(Fields& f, DragBody& c);

struct ReleaseBody {
  static constexpr const char* kName = "release-body";
};

// Begins a history step in which bodies move: the AdvanceTime commands that follow, up to the next stroke
// or edit, belong to it and are undone with it.
struct Play {
  static constexpr const char* kName = "play";
};

// Commands that change a piece as a whole. Except for DuplicatePiece, they first make the piece a body of
// its own if it is none (see edit_piece). run() executes the command (see ImmediateCommand).

struct MovePiece {
  PieceId piece;
  Placement to;

  static constexpr const char* kName = "move-piece";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, MovePiece& c);

// Adds a copy of a piece as a body of its own at a placement.
struct DuplicatePiece {
  PieceId piece;
  Placement to;

  static constexpr const char* kName = "duplicate-piece";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, DuplicatePiece& c);

struct HidePiece {
  PieceId piece;
  bool hidden = true;

  static constexpr const char* kName = "hide-piece";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, HidePiece& c);

struct DeletePiece {
  PieceId piece;

  static constexpr const char* kName = "delete-piece";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, DeletePiece& c);

// Renames a piece. Pieces that later come off it are named after it.
struct RenamePiece {
  PieceId piece;
  std::string name;

  static constexpr const char* kName = "rename-piece";
  size_t weight() const { return name.size(); }
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, RenamePiece& c);

// Pins a piece, so that nothing moves it while bodies move, or unpins it.
struct PinPiece {
  PieceId piece;
  bool pinned = true;

  static constexpr const char* kName = "pin-piece";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, PinPiece& c);

// Sets the sheet of a piece: its thickness, its density and the constants of its material. Its faces keep
// their energy.
struct SetSheetProperties {
  PieceId piece;
  Sheet sheet;

  static constexpr const char* kName = "set-sheet-properties";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SetSheetProperties& c);

// Makes a piece a solid or a sheet. The faces of a solid enclose a volume: strokes with a smooth rim close
// it again by walls, and its mass is that of the volume.
struct SetSolid {
  PieceId piece;
  bool solid = true;

  static constexpr const char* kName = "set-solid";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SetSolid& c);

// Commands that replace the mesh of a piece and make it a body of its own (see remesh_piece). run()
// executes the command (see ImmediateCommand).

// Simplifies a piece to a number of faces or to an error [m] (see simplify).
struct SimplifyPiece {
  PieceId piece;
  SimplifyTarget target;

  static constexpr const char* kName = "simplify-piece";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SimplifyPiece& c);

// Subdivides every face of a piece once (see subdivide).
struct SubdividePiece {
  PieceId piece;
  Subdivision scheme = Subdivision::kLoop;

  static constexpr const char* kName = "subdivide-piece";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SubdividePiece& c);

struct SmoothPiece {
  PieceId piece;
  size_t times = 1;

  static constexpr const char* kName = "smooth-piece";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SmoothPiece& c);

// Reverses the closed parts of a piece that lie in others and overlap with them (see turn_shells).
struct TurnShells {
  PieceId piece;

  static constexpr const char* kName = "turn-shells";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, TurnShells& c);

// Adds a body to the world from a mesh file.
struct AddMesh {
  std::filesystem::path file;
  std::string name;

  static constexpr const char* kName = "add-mesh";
  size_t weight() const { return file.native().size() + name.size(); }
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, AddMesh& c);

struct SetEnvironment {
  Environment around;

  static constexpr const char* kName = "set-environment";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SetEnvironment& c);

// Undoes the last history step; a stroke with all its moves is one step.
struct Undo {
  static constexpr const char* kName = "undo";
};

// Redoes the history step that was undone last.
struct Redo {
  static constexpr const char* kName = "redo";
};

// All changes of the world are commands. A stroke consists of a beginning, poses in world coordinates and
// an end; it contains no pixels, so that a journal of commands produces the same world in every replay.
//
// Each kind of command is a struct with, in addition to its data:
//   kName      its name in a journal
//   weight()   the memory that it owns in addition to its own size [bytes]; only if it owns some
// and, if it has data, describe(), the table of its keys in a journal (see Fields). Kinds are always
// distinguished by std::visit, so that a missing case does not compile.
using Command = std::variant<BeginStroke, MoveBeam, EndStroke, StopStroke, Recut, AdvanceTime, DragBody,
                             ReleaseBody, Play, AddMesh, MovePiece, DuplicatePiece, HidePiece, DeletePiece,
                             RenamePiece, PinPiece, SetSheetProperties, SetSolid, SimplifyPiece,
                             SubdividePiece, SmoothPiece, TurnShells, SetEnvironment, Undo, Redo>;

// A command that executes immediately, after the queue. run(world, generation, progress) returns the
// changes, which are empty if the command has no effect. Bodies that it creates get `generation` (see
// BodyId). On failure the world is unchanged.
template <typename C>
concept ImmediateCommand = requires(const C& command, World& world) {
  { command.run(world, uint32_t{}, nullptr) } -> std::same_as<Result<Delta>>;
};

// A command that advances time or acts while time passes. It is queued behind the moves before it.
template <typename C>
concept TimedCommand =
    std::same_as<C, AdvanceTime> || std::same_as<C, DragBody> || std::same_as<C, ReleaseBody>;

// Function objects for std::visit, one per kind of command or group of kinds.
template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

// The piece that a command names; nullopt if it names none.
inline std::optional<PieceId> piece_of(const Command& command) {
  const auto named = [](const auto& c) -> std::optional<PieceId> {
    if constexpr (requires { c.piece; }) return c.piece;
    return std::nullopt;
  };
  return std::visit(named, command);
}

inline size_t weight(const Command& command) {
  const auto owned = [](const auto& c) -> size_t {
    if constexpr (requires { c.weight(); }) return c.weight();
    return 0;
  };
  return sizeof(Command) + std::visit(owned, command);
}

}  // namespace kerf
