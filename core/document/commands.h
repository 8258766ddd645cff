#pragma once

#include <concepts>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/base/tick.h"
#include "core/cut/cut_step.h"
#include "core/document/edit_piece.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/remesh/openmesh_tools.h"
#include "core/mesh/remesh/simplify.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

class Fields;

// Where the beam of a stroke is, and when.
struct BeamAt {
  Pose pose;
  double time = 0;  // s since the stroke began
};

// Begins a stroke: the beam is on from here, at this pose (world coordinates), at time 0 of the stroke.
struct BeginStroke {
  CutSettings settings;
  Pose pose;

  static constexpr const char* kName = "begin-stroke";
  std::string words(FileUnit unit) const;
};
void describe(Fields& f, BeginStroke& c);

// Moves the beam of the running stroke on, with the beam on all the way.
struct MoveBeam {
  Pose pose;        // world coordinates; the direction is not opposite to the one before
  double time = 0;  // s since the stroke began, not before the pose before; all 0 where times are not known

  static constexpr const char* kName = "move-beam";
  std::string words() const { return "Move the beam"; }
};
void describe(Fields& f, MoveBeam& c);

// Ends the running stroke: the beam is off. A stroke with a smooth rim is smoothed here.
struct EndStroke {
  static constexpr const char* kName = "end-stroke";
  std::string words() const { return "End the stroke"; }
};

// Ends the last stroke earlier than it was drawn: the beam goes off at a place of its path. It is for strokes
// that take long to cut, and belongs to the step of the stroke.
struct StopStroke {
  // The moves of the beam that are cut, of which the first one only switches it on: 12.5 are twelve moves and
  // the first half of the next one, rounded to the parts into which it is subdivided.
  double moves = 0;
  Ticks ticks = 0;  // after those, for which the beam stays on while bodies move

  static constexpr const char* kName = "stop-stroke";
  std::string words() const { return "Stop the stroke"; }
};
void describe(Fields& f, StopStroke& c);

// Takes the last stroke back and cuts it again with other settings.
struct Recut {
  CutSettings settings;

  static constexpr const char* kName = "recut";
  std::string words(FileUnit unit) const;
};
void describe(Fields& f, Recut& c);

class Fields;

// Lets time pass: so many ticks (see core/base/tick.h). It does not end a running stroke; it takes effect
// when the moves before it are executed. All that changes in a world by itself changes here.
struct AdvanceTime {
  Ticks ticks = 0;
  bool bodies = false;  // bodies move (see core/physics), which Play begins
  // Belongs to the step of the history before it whatever that is, and is undone with it. Time that does not
  // is a step of its own after an edit (see Document).
  bool joins = false;

  static constexpr const char* kName = "advance-time";
  // The largest number in one line of a journal: each second of a run is a line of its own.
  static constexpr Ticks kMaxInALine = kTicksPerSecond;

  std::string words() const { return bodies ? "Time with moving bodies" : "Time"; }
};
void describe(Fields& f, AdvanceTime& c);

// Holds a piece by a spring, or moves the far end of the spring that holds it (see Spring). It takes effect
// between the ticks before and after it; bodies only follow a spring while they move.
struct DragBody {
  PieceId piece;
  Vec3 at{0};  // m, the point that is held, in the frame of the body
  Vec3 to{0};  // m, in the world, where the spring pulls it

  static constexpr const char* kName = "drag-body";
  std::string words(const std::string& piece_name) const;
};
void describe(Fields& f, DragBody& c);

// Takes the spring away.
struct ReleaseBody {
  static constexpr const char* kName = "release-body";
  std::string words() const { return "Let go"; }
};

// Begins a step of the history in which bodies move: the AdvanceTime commands that follow, up to the next
// stroke or edit, belong to it and are undone with it.
struct Play {
  static constexpr const char* kName = "play";
  std::string words() const { return "Play"; }
};

class Fields;

// Commands that change a piece as a whole. But for DuplicatePiece, the piece becomes a body of its own first,
// where it is not one already (see edit_piece). run() does the command (see ImmediateCommand).

// Puts a piece at a placement.
struct MovePiece {
  PieceId piece;
  Placement to;

  static constexpr const char* kName = "move-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, MovePiece& c);

// Adds a copy of a piece as a body of its own, at a placement. The piece itself is not changed.
struct DuplicatePiece {
  PieceId piece;
  Placement to;

  static constexpr const char* kName = "duplicate-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, DuplicatePiece& c);

// Hides a piece, or shows it again.
struct HidePiece {
  PieceId piece;
  bool hidden = true;

  static constexpr const char* kName = "hide-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, HidePiece& c);

// Removes a piece from the world.
struct DeletePiece {
  PieceId piece;

  static constexpr const char* kName = "delete-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, DeletePiece& c);

// Gives a piece a name. Once it is a body of its own, pieces that come off it are named after it.
struct RenamePiece {
  PieceId piece;
  std::string name;

  static constexpr const char* kName = "rename-piece";
  std::string words(const std::string& piece_name) const;
  size_t weight() const { return name.size(); }
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, RenamePiece& c);

// Pins a piece where it is, so that nothing moves it while bodies move, or lets it move again.
struct PinPiece {
  PieceId piece;
  bool pinned = true;

  static constexpr const char* kName = "pin-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, PinPiece& c);

// Says what the sheet of a piece is: its thickness, its density and the constants of its material. Its faces
// keep their energy.
struct SetSheetProperties {
  PieceId piece;
  Sheet sheet;

  static constexpr const char* kName = "set-sheet-properties";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SetSheetProperties& c);

// Says whether the faces of a piece enclose a volume, which strokes with a smooth rim close again by walls
// and which then has the mass of a solid, or are a sheet.
struct SetSolid {
  PieceId piece;
  bool solid = true;

  static constexpr const char* kName = "set-solid";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SetSolid& c);

class Fields;

// Commands that give a piece another mesh. It becomes a body of its own (see remake_piece). run() does the
// command (see ImmediateCommand).

// Simplifies a piece to a number of faces or to an error in metres (see simplify).
struct SimplifyPiece {
  PieceId piece;
  SimplifyTarget target;

  static constexpr const char* kName = "simplify-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SimplifyPiece& c);

// Subdivides every face of a piece once (see subdivide).
struct SubdividePiece {
  PieceId piece;
  Subdivision scheme = Subdivision::kLoop;

  static constexpr const char* kName = "subdivide-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SubdividePiece& c);

// Smooths a piece (see smooth).
struct SmoothPiece {
  PieceId piece;
  size_t times = 1;

  static constexpr const char* kName = "smooth-piece";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SmoothPiece& c);

// Turns the closed parts of a piece that lie in others and overlap with them (see turn_shells).
struct TurnShells {
  PieceId piece;

  static constexpr const char* kName = "turn-shells";
  std::string words(const std::string& piece_name) const;
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, TurnShells& c);

class Fields;

// Adds a body to the world from a mesh file.
struct AddMesh {
  std::filesystem::path file;
  std::string name;

  static constexpr const char* kName = "add-mesh";
  std::string words() const { return "Add " + name; }
  size_t weight() const { return file.native().size() + name.size(); }
  // Does it (see ImmediateCommand).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, AddMesh& c);

// Sets gravity and the ground.
struct SetEnvironment {
  Environment around;

  static constexpr const char* kName = "set-environment";
  std::string words() const { return "Gravity and ground"; }
  // Does it (see ImmediateCommand).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SetEnvironment& c);

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
concept ImmediateCommand = requires(const C& command, World& world) {
  { command.run(world, uint32_t{}, nullptr) } -> std::same_as<Result<Delta>>;
};

// A command that lets time pass or acts while it passes. It is queued behind the moves before it.
template <typename C>
concept TimedCommand =
    std::same_as<C, AdvanceTime> || std::same_as<C, DragBody> || std::same_as<C, ReleaseBody>;

// Function objects for std::visit, one for each kind of command or for some of them.
template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

// The piece that a command names; nothing where it names none.
inline std::optional<PieceId> piece_of(const Command& command) {
  const auto named = [](const auto& c) -> std::optional<PieceId> {
    if constexpr (requires { c.piece; }) return c.piece;
    return std::nullopt;
  };
  return std::visit(named, command);
}

// A description of the command for the user, for example "Stroke, radius 4 mm". `unit` is the one in which
// the work is shown. The piece that it names is called `piece_name`, or where that is empty by its number.
inline std::string words(const Command& command, FileUnit unit, const std::string& piece_name = "") {
  const auto told = [&](const auto& c) {
    if constexpr (requires { c.words(unit); }) {
      return c.words(unit);
    } else if constexpr (requires { c.words(piece_name); }) {
      return c.words(piece_name.empty() ? piece_words(c.piece) : piece_name);
    } else {
      return c.words();
    }
  };
  return std::visit(told, command);
}

// The memory that a command occupies, in bytes.
inline size_t weight(const Command& command) {
  const auto owned = [](const auto& c) -> size_t {
    if constexpr (requires { c.weight(); }) return c.weight();
    return 0;
  };
  return sizeof(Command) + std::visit(owned, command);
}

}  // namespace kerf
