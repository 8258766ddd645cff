#pragma once

#include <concepts>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/cut/cut_step.h"
#include "core/cut/knife.h"
#include "core/document/extract.h"
#include "core/joints/joint_description.h"
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

// Moves the beam of the running stroke; the beam stays on during the move.
struct MoveBeam {
  Pose pose;        // world coordinates; not opposite to the previous direction
  double time = 0;  // s since the stroke began, non-decreasing; all 0 if times are unknown

  static constexpr const char* kName = "move-beam";
};
void describe(Fields& f, MoveBeam& c);

// Ends the running stroke: switches the beam off and closes a smooth rim.
struct EndStroke {
  static constexpr const char* kName = "end-stroke";
};

// Stops the last stroke at a point of its path, before the end of its moves, e.g. because cutting takes long.
// Belongs to the history step of the stroke.
struct StopStroke {
  // The number of moves to cut; the first one only switches the beam on. 12.5 means twelve moves and the
  // first half of the next, rounded to the parts of its subdivision.
  double moves = 0;
  Ticks ticks = 0;  // ticks after those moves for which the beam stays on while bodies move

  static constexpr const char* kName = "stop-stroke";
};
void describe(Fields& f, StopStroke& c);

// Cuts the last stroke again with other settings.
struct Recut {
  CutSettings settings;

  static constexpr const char* kName = "recut";
};
void describe(Fields& f, Recut& c);

// Advances time by a number of ticks (see core/base/ids.h). All changes of the world that no other command
// makes, i.e. motion and cooling, happen in ticks. Does not end a running stroke; takes effect when the moves
// before it have been executed.
struct AdvanceTime {
  Ticks ticks = 0;
  bool bodies = false;  // bodies move (see core/physics); begun by Play
  // If true, the time belongs to the previous history step of any kind and is undone with it; if false, it is
  // a step of its own after an edit (see Document).
  bool joins = false;

  static constexpr const char* kName = "advance-time";
  // Maximum in one line of a journal: each second of a run is a line of its own.
  static constexpr Ticks kMaxInALine = kTicksPerSecond;
};
void describe(Fields& f, AdvanceTime& c);

// Attaches a spring to a piece, or moves the far end of its spring (see Spring). Takes effect between the
// ticks before and after it. A spring pulls only in ticks in which bodies move.
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

// Begins a history step in which bodies move: the following AdvanceTime commands, up to the next stroke or
// edit, belong to it and are undone with it.
struct Play {
  static constexpr const char* kName = "play";
};

// Commands that change a piece as a whole. Except for DuplicatePiece, they first detach the piece as a body
// of its own if necessary (see edit_piece). run() executes the command (see ImmediateCommand).

struct MovePiece {
  PieceId piece;
  Placement to;

  static constexpr const char* kName = "move-piece";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, MovePiece& c);

// Adds a copy of a piece as a body of its own at a placement. The energy of its faces counts as absorbed.
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

// Renames a piece. Pieces later cut off it derive their names from the new one.
struct RenamePiece {
  PieceId piece;
  std::string name;

  static constexpr const char* kName = "rename-piece";
  size_t weight() const { return name.size(); }
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, RenamePiece& c);

// Pins a piece, which makes it immovable in the simulation, or unpins it.
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

// Turns a piece into a solid or a sheet. The faces of a solid enclose a volume: strokes with a smooth rim
// close it again by walls, and its mass is that of the volume.
struct SetSolid {
  PieceId piece;
  bool solid = true;
  std::string cut_material{};  // name of the material of walls made later; empty: unchanged

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

// Reverses the closed parts of a piece that lie inside others and whose orientation makes the volumes overlap
// (see turn_shells).
struct TurnShells {
  PieceId piece;

  static constexpr const char* kName = "turn-shells";
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, TurnShells& c);

// Cuts bodies along a plane by a cut of no width (see cut_with_plane).
struct CutPlane {
  KnifePlane plane;
  std::vector<BodyId> bodies{};               // empty: all visible ones
  size_t max_faces = CutSettings::kMaxFaces;  // of a body after the cut
  Pegs pegs{};

  static constexpr const char* kName = "cut-plane";
  size_t weight() const { return bodies.size() * sizeof(BodyId); }
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, CutPlane& c);

// Cuts bodies along the surface of a path by a cut of no width (see cut_with_path).
struct CutPath {
  KnifePath path;
  std::vector<BodyId> bodies{};               // empty: all visible ones
  size_t max_faces = CutSettings::kMaxFaces;  // of a body after the cut

  static constexpr const char* kName = "cut-path";
  size_t weight() const { return path.poses.size() * sizeof(Pose) + bodies.size() * sizeof(BodyId); }
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, CutPath& c);

// Adds a body to the world from a mesh file.
struct AddMesh {
  std::filesystem::path file;
  std::string name;
  // If set, creates the body instead of the file. A journal with such a command must not be written.
  std::function<Result<Body>(const Progress*)> create = {};

  static constexpr const char* kName = "add-mesh";
  size_t weight() const { return file.native().size() + name.size(); }
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, AddMesh& c);

// Joins two parts of a body that is as it was loaded: fails if it was cut, or if its parts move separately
// already (see make_joint for other errors).
struct JoinParts {
  PieceId piece;  // label 0 of the body
  JointDescription joint;

  static constexpr const char* kName = "join-parts";
  size_t weight() const { return joint.parts[0].size() + joint.parts[1].size(); }
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, JoinParts& c);

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

// A command: all changes of the world are commands. A stroke consists of a beginning, poses in world
// coordinates and an end; it does not depend on pixels, so that every replay of a journal produces the same
// world.
//
// Each kind of command is a struct with, in addition to its data:
//   kName      its name in a journal
//   weight()   the memory that it owns in addition to its own size [bytes]; only if it owns some
// and, if it has data, describe(), the table of its keys in a journal (see Fields). Kinds are always
// distinguished by std::visit, so that a missing case does not compile.
using Command =
    std::variant<BeginStroke, MoveBeam, EndStroke, StopStroke, Recut, AdvanceTime, DragBody, ReleaseBody,
                 Play, AddMesh, MovePiece, DuplicatePiece, HidePiece, DeletePiece, RenamePiece, PinPiece,
                 SetSheetProperties, SetSolid, SimplifyPiece, SubdividePiece, SmoothPiece, TurnShells,
                 CutPlane, CutPath, JoinParts, SetEnvironment, Undo, Redo>;

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

// Returns true if bodies move in the time of a command.
inline bool moves_bodies(const Command& command) {
  const auto* advance = std::get_if<AdvanceTime>(&command);
  return advance != nullptr && advance->bodies;
}

// Function objects for std::visit, one per kind of command or group of kinds.
template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

// Returns the piece to which a command applies; nullopt if there is none.
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
