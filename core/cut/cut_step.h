#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/containers.h"
#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/cut/close_by_walls_internal.h"
#include "core/cut/stroke_region.h"
#include "core/joints/joined_parts.h"
#include "core/laser/laser.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// The bodies that a beam can cut: all that are not hidden, in the order of World::ids(). O(bodies).
std::vector<BodyId> cuttable(const World& world);

// Returns whether a beam touches a face of such a body during a move in world coordinates. If not, the move
// removes nothing and heats nothing. A move of very many parts (see subdivide) is taken for one that does.
// O(log n) for each part. Preconditions: directions are unit vectors and not opposite.
bool meets_anything(const World& world, const Laser& laser, const BeamMove& move);
// The same for a beam that stands still.
bool meets_anything(const World& world, const Laser& laser, const Pose& pose);

// A vertex near the boundary of a stroke and a point of the boundary for it. `other` is the end of the edge
// along which it would move, invalid where it would move within the plane of its faces.
struct RimSnap {
  VertexId vertex, other;
  FaceId face;
  Vec3 to;
  double share = 0;  // of the edges at hand that lies between
};

// The state of the end of a stroke with a smooth rim that a step left unfinished, so that a later step can
// continue it: the body, the stage, and what the stages know of that body. A default-constructed one is at
// the start. It is valid only for the world as the step left it; any other change of the world invalidates
// it, and what was cut stays cut.
struct UnfinishedRim {
  enum class Stage {
    kSweep,           // collects what the beam has swept in the body
    kFindNear,        // queries the tree for the faces near the boundary of that
    kSort,            // brings them into the order of their slots
    kRefine,          // splits faces until each can be cut along one chord
    kListInPlane,     // lists vertices that may move onto the boundary in the plane of their faces
    kMoveInPlane,     // moves them, nearest first
    kListAlongEdges,  // lists vertices that may move onto the boundary along edges
    kMoveAlongEdges,
    kSplitInTheWay,    // splits the faces that kept a vertex from moving; then back to kRefine
    kListNear,         // lists vertices that cannot be moved but lie very near the boundary
    kSettle,           // treats them as lying on it
    kClip,             // splits edges where they cross the boundary
    kChoose,           // lists the faces inside
    kRemove,           // removes them
    kChooseBesideRim,  // lists the faces at the rim
    kFlip,             // flips edges of theirs that make small angles
    kCloseByWalls,     // closes a solid body
    kHeatWalls,        // gives the walls the heat of the cut
    kSeparate,         // searches for separated pieces
    kMeasure,          // measures the angles of all faces that are new
  };

  size_t bodies = 0;  // bodies that are completed
  Stage stage = Stage::kSweep;
  size_t next = 0;       // the number of items of the stage that are processed
  int rounds = 0;        // of kRefine .. kSplitInTheWay, then of kFlip
  bool flipped = false;  // an edge was flipped in this round
  bool removed = false;  // faces were removed
  StrokeRegion region;
  std::vector<FaceId> faces;  // on or near the boundary of the region, followed by the parts of split ones
  // The faces to process: a heap of near faces, those to split (the next one is last), to remove, to flip,
  // or to heat.
  std::vector<FaceId> waiting;
  std::vector<RimSnap> snaps;      // a heap of vertices to move or to settle, the nearest on top
  std::vector<FaceId> in_the_way;  // faces to split because a vertex very near the boundary cannot be moved
  std::vector<FaceId> changed;     // faces that splits, moves and flips have changed, with repeats
  PagedArray<uint32_t>
      distance_of;  // by vertex: an index of `distances` plus one, or 0 where it is not known
  std::vector<double> distances;
  std::shared_ptr<WallClosing> closing;  // from kCloseByWalls on; of copies, one alone can be continued

  // Whether the body is in a state that nothing but the following steps may end: some of its walls are there
  // and others not.
  bool is_uninterruptible() const { return closing && closing->is_adding(); }
  // Whether a step has begun it.
  bool begun() const { return bodies > 0 || stage != Stage::kSweep || next > 0; }
};

// How a face is split.
enum class Scheme {
  kOneToFour,    // into four, with green pairs for conformity (see OneToFour)
  kLongestEdge,  // into two at its longest edge (see longest_edge.h)
};

// The boundary that a stroke leaves.
enum class Rim {
  kFaces,   // every face that the beam touches is removed
  kSmooth,  // faces across the boundary of the beam are cut along it when the stroke ends (see close_rim)
};

// How the beam acts on a face.
enum class Model {
  kGeometric,  // removes it at once where the beam touches it
  kThermal,    // heats it, and removes it when it has taken what its material needs (see thermal_step.h)
};

// How finely faces are split where the beam touches them before they are removed, and which rim is left.
struct Resolution {
  enum class Rule {
    kTargetEdge,  // until the longest edge is at most target_edge
    kTolerance,   // until removing the face removes nothing farther than `tolerance` outside the beam
    kDepth,       // until the face is `depth` levels below its base face; 0 removes whole base faces
  };
  Scheme scheme = Scheme::kLongestEdge;
  Rule rule = Rule::kTargetEdge;
  double target_edge = 0.0025;  // m, > 0
  double tolerance = 0.00125;   // m, > 0
  int depth = 4;                // levels, 0 .. kLargestDepth: one split into four, or two into two
  Rim rim = Rim::kFaces;        // a pattern of rays has no volume and always leaves kFaces

  static constexpr int kLargestDepth = 24;
  friend bool operator==(const Resolution&, const Resolution&) = default;
};

struct CutSettings {
  Laser laser;
  Resolution resolution;
  Model model = Model::kGeometric;
  // The geometric model leaves heat beside what it removes, from the melting point at the rim to nothing at
  // this distance (m, >= 0) from it; none if it is 0. See deposit_heat.
  double heat_width = 0;
  // A smooth rim needs a beam that has a volume and removes all that is within.
  bool smooth() const {
    return resolution.rim == Rim::kSmooth && laser.pattern == Pattern::kVolume && model == Model::kGeometric;
  }
  // A cut fails before a body has more live faces than this. By itself it is what 32-bit numbers of
  // half-edges leave room for; memory ends before (see Document::set_face_budget).
  static constexpr size_t kMaxFaces = size_t{1} << 28;
  size_t max_faces = kMaxFaces;
  // The number of faces that a move visits in a search for separated pieces; the following moves continue the
  // search. The limit is per move and not per step, so that labels do not depend on the division into steps.
  size_t search_a_move = 1'000;
  // The number of faces that a step finds, examines and removes before it ends, or slightly more; about a
  // millisecond of work. The result of the cut does not depend on it.
  size_t bite = 3'000;
};

// Counts of the work of a step, and the duration of its stages (s).
struct StepStatistics {
  size_t queries = 0;  // queries of trees
  QueryCounts tested;  // the sum over these queries
  size_t faces_made = 0;
  double largest_cosine = -1;  // of the smallest angle of the faces that were created and not removed
  // The duration (s) of the moves of the thermal model whose beam met a face, and the integral over it of the
  // share of its energy of removal that the hottest face under the beam reached, 1 where one was removed.
  double met_s = 0, depth_s = 0;
  double query_s = 0, refine_s = 0, remove_s = 0, update_tree_s = 0, separate_s = 0;

  void add(const StepStatistics& other);
};

// The state of a move of the beam that a step left unfinished, so that a later step can continue it: the
// body, the stage, and the faces to be processed there. A default-constructed one is at the start of a move.
// It is valid only for the world as the step left it; any other change of the world invalidates it, and what
// the move has cut stays cut.
struct UnfinishedMove {
  enum class Stage { kFind, kRefine, kFindAgain, kRemove, kSeparate };

  size_t bodies = 0;             // bodies that the move has completed
  Stage stage = Stage::kFind;    // of the next body
  std::vector<FaceId> hit;       // faces that the beam touches, each once
  std::vector<FaceId> to_split;  // faces and parts of faces still to be refined; the next one is last
  std::vector<FaceId> beside;    // neighbours of faces that were removed; only where heat is left beside them
  size_t removed = 0;            // number of faces of `hit` that are processed
  bool has_split = false;        // a face was split, so that `hit` has to be found again
};

struct StepResult {
  size_t moves = 0;              // number of moves of the beam that were finished
  std::optional<BeamMove> last;  // the last of these
  Delta delta;
  StepStatistics statistics;
};

// Executes one step of a cut through all bodies that the beam may cut (see cuttable). For each move of the
// beam in turn, the faces that it touches are found (hit), split until they are fine enough or wholly inside
// the beam (refine), and removed; then separated pieces get new labels (separate). The topology changes
// nowhere else. Moves are in world coordinates.
//
// The step continues the first move where `unfinished` says, and ends with the last move or after
// settings.bite faces. If it ends within a move, `unfinished` says where, and the next step must be given the
// moves from that one on. The result does not depend on the division into steps or on the bite: faces get the
// same slots and labels, and the tree the same boxes. The world is consistent between steps; the pieces that
// a move separates have their labels when the move is finished. A single query of the tree and the separation
// after one move are never divided.
//
// Fails if settings.max_faces is reached or `progress` stops it. The part of the cut that was done remains,
// but its delta is lost, so that everything that follows the world must read it again. `unfinished` is reset.
Result<StepResult> cut_step(World& world, const CutSettings& settings, std::span<const BeamMove> moves,
                            UnfinishedMove& unfinished, const Progress* progress = nullptr);

// Executes the next stage of a move through one body, or a part of it if the stage has many faces, and
// continues it from `unfinished` like cut_step; result.moves is 1 once the move is finished. A move that is
// executed in stages has the same result as one that is executed by cut_step.
Result<StepResult> cut_stage(World& world, const CutSettings& settings, const BeamMove& move,
                             UnfinishedMove& unfinished, const Progress* progress = nullptr);

// Executes moves of the beam through one body, whole, as cut_step does: for a body that moves under the beam.
// The moves are in the frame of the body. Fails like cut_step. Precondition: the body is not hidden.
Result<StepResult> cut_body(World& world, const CutSettings& settings, BodyId id,
                            std::span<const BeamMove> moves, const Progress* progress = nullptr);

// The moves of a stroke in the frames of bodies, for those that moved during the stroke.
using SweptByBody = std::map<BodyId, std::vector<BeamMove>>;

// Executes one step of ending a stroke with a smooth rim, in all bodies that the beam may cut (see cuttable).
// Before that, the steps of the stroke only remove faces that are wholly inside the beam. This function cuts
// the faces that cross the boundary of the volume swept by `path` along that boundary, and removes the parts
// inside. `path` holds all moves of the stroke, in world coordinates; for the bodies that `swept` lists,
// their list replaces it.
//
// The step goes on where `unfinished` says, and ends after an amount of work of about settings.bite faces.
// The rim is closed once unfinished.begun() is false afterwards; until then nothing else may change the
// world, and the next step must be given the same arguments. The result does not depend on the division into
// steps. The world is consistent between them, but for a body to which walls are being added (see
// UnfinishedRim::is_uninterruptible): neither `progress` nor a budget may stop it then. Pieces are looked for
// in the last steps.
//
// Faces in which a chord would deviate from the boundary by more than kRimChord are split by the scheme
// first. A vertex near the boundary is moved onto it along an edge if that does not change the surface; every
// other edge that crosses the boundary is split there, so that the rim lies on the original surface. Finally,
// edges within one base face are flipped where that increases the smallest angle. Fails like cut_step.
Result<StepResult> rim_step(World& world, const CutSettings& settings, std::span<const BeamMove> path,
                            const SweptByBody& swept, UnfinishedRim& unfinished,
                            const Progress* progress = nullptr);

// Closes the rim in one step.
Result<StepResult> close_rim(World& world, const CutSettings& settings, std::span<const BeamMove> path,
                             const SweptByBody& swept = {}, const Progress* progress = nullptr);

// Whether no body has an unfinished search for separated pieces.
bool is_settled(const World& world);

// Continues these searches in all bodies, including hidden ones, and visits `most` faces in each of them.
// Once all are finished, joints hold what they can as `hold` says. Precondition with Hold::kStill: nothing
// edits the bodies until is_settled().
StepResult go_on_separating(World& world, size_t most, Hold hold = Hold::kStill);

// Executes moves of the beam through one body as cut_body does, but leaves parts that joints do not hold any
// more for the next call of go_on_separating(): for callers that cut many bodies between two ticks. Fails
// like cut_step. Precondition: the body is not hidden.
Result<StepResult> cut_apart(World& world, const CutSettings& settings, BodyId id,
                             std::span<const BeamMove> moves);

}  // namespace kerf
