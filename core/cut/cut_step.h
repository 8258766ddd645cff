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
#include "core/cut/close_rim_internal.h"
#include "core/cut/stroke_region.h"
#include "core/joints/joined_parts.h"
#include "core/laser/laser.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// Returns the bodies that a beam can cut: all that are visible, in the order of World::ids(). O(bodies).
std::vector<BodyId> cuttable(const World& world);

// Returns true if a beam touches a face of such a body during a move in world coordinates. If not, the move
// removes and heats nothing. A move of very many parts (see subdivide) counts as touching. O(log n) per
// part. Preconditions: directions are unit vectors and not opposite.
bool hits_anything(const World& world, const Laser& laser, const BeamMove& move);
// The same for a stationary beam.
bool hits_anything(const World& world, const Laser& laser, const Pose& pose);

// A vertex near the boundary of a stroke and its target on the boundary. `other` is the end of the edge
// along which it would move, invalid if it would move within the plane of its faces.
struct RimSnap {
  VertexId vertex, other;
  FaceId face;
  Vec3 to;
  double share = 0;  // of the edge that lies between
};

// Progress of ending a stroke with a smooth rim, so that a later step can continue it: the body, the stage,
// and the stage's data of that body. Default-constructed: at the start. Valid only for the world as the
// step left it; any other change of the world invalidates it, and faces already removed stay removed.
struct UnfinishedRim {
  enum class Stage {
    kSweep,           // collects the volume that the beam has swept in the body
    kFindNear,        // queries the tree for faces near its boundary
    kSort,            // sorts them by slot
    kRefine,          // splits faces until each can be cut along one chord
    kListInPlane,     // lists vertices that may move onto the boundary in the plane of their faces
    kMoveInPlane,     // moves them, nearest first
    kListAlongEdges,  // lists vertices that may move onto the boundary along edges
    kMoveAlongEdges,
    kSplitInTheWay,    // splits the faces that prevented a move; then back to kRefine
    kListNear,         // lists vertices that cannot be moved but lie very near the boundary
    kSettle,           // treats them as lying on it
    kClip,             // splits edges where they cross the boundary
    kChoose,           // lists the faces inside
    kRemove,           // removes them
    kChooseBesideRim,  // lists the faces at the rim
    kFlip,             // flips their edges that make small angles
    kCloseByWalls,     // closes a solid body
    kHeatWalls,        // heats the walls
    kSeparate,         // searches for separated pieces
    kMeasure,          // measures the angles of all new faces
  };

  size_t bodies = 0;  // completed bodies
  Stage stage = Stage::kSweep;
  size_t next = 0;       // index of the next item of the stage
  int rounds = 0;        // of kRefine .. kSplitInTheWay, then of kFlip
  bool flipped = false;  // an edge was flipped in this round
  bool removed = false;  // faces were removed
  StrokeRegion region;
  std::vector<FaceId> faces;  // on or near the boundary of the region, followed by parts of split ones
  // Faces to process: a heap of near faces, or those to split (next one last), remove, flip or heat.
  std::vector<FaceId> waiting;
  std::vector<RimSnap> snaps;        // heap of vertices to move or settle, nearest on top
  std::vector<FaceId> in_the_way;    // faces to split because a vertex very near the boundary cannot be moved
  std::vector<FaceId> changed;       // faces changed by splits, moves and flips, with repeats
  PagedArray<uint32_t> distance_of;  // by vertex: index in `distances` plus one, or 0 if unknown
  std::vector<double> distances;
  std::shared_ptr<WallClosing> closing;  // from kCloseByWalls on; of several copies only one can be continued

  // Returns true if only the following steps may change the body, because only some of its walls exist.
  bool is_uninterruptible() const { return closing && closing->is_adding(); }
  // Returns true once a step has begun it.
  bool begun() const { return bodies > 0 || stage != Stage::kSweep || next > 0; }
};

// Scheme by which a face is split.
enum class Scheme {
  kOneToFour,    // into four, with green pairs for conformity (see OneToFour)
  kLongestEdge,  // into two at its longest edge (see refinement.h)
};

// Boundary that a stroke leaves.
enum class Rim {
  kFaces,   // every face that the beam touches is removed
  kSmooth,  // faces across the boundary of the beam are cut along it at the end of the stroke (see close_rim)
};

// Effect of the beam on a face.
enum class Model {
  kGeometric,  // removes it at once if the beam touches it
  kThermal,    // heats it, and removes it once it has absorbed its energy of removal (see thermal_step.h)
};

// Resolution to which faces are split under the beam before they are removed, and the kind of rim.
struct Resolution {
  enum class Rule {
    kTargetEdge,  // until the longest edge is at most target_edge
    kTolerance,   // until removing the face overshoots the beam by at most `tolerance`
    kDepth,       // until the face is `depth` levels below its base face; 0 removes whole base faces
  };
  Scheme scheme = Scheme::kLongestEdge;
  Rule rule = Rule::kTargetEdge;
  double target_edge = 0.0025;  // m, > 0
  double tolerance = 0.00125;   // m, > 0
  int depth = 4;                // levels, 0 .. kMaxDepth: one split into four, or two into two
  Rim rim = Rim::kFaces;        // a pattern of rays has no volume and always leaves kFaces

  static constexpr int kMaxDepth = 24;
  friend bool operator==(const Resolution&, const Resolution&) = default;
};

struct CutSettings {
  Laser laser;
  Resolution resolution;
  Model model = Model::kGeometric;
  // Width of the heat-affected zone of the geometric model [m], >= 0; 0: none. See deposit_heat.
  double heat_width = 0;
  // Returns true for a smooth rim; it needs a beam that has a volume and removes everything within.
  bool smooth() const {
    return resolution.rim == Rim::kSmooth && laser.pattern == Pattern::kVolume && model == Model::kGeometric;
  }
  // Max live faces of a body; a cut that would exceed it fails. The default is the limit of 32-bit
  // half-edge indices; memory runs out earlier (see Document::set_face_budget).
  static constexpr size_t kMaxFaces = size_t{1} << 28;
  size_t max_faces = kMaxFaces;
  // Number of faces that a move visits in a search for separated pieces; the following moves continue the
  // search. The limit is per move, not per step, so that labels do not depend on the division into steps.
  size_t search_a_move = 1'000;
  // Approximate number of faces that a step finds, examines and removes; about a millisecond of work. The
  // result of the cut does not depend on it.
  size_t bite = 3'000;
};

// Counts of the work of a step, and durations of its stages [s].
struct StepStatistics {
  size_t queries = 0;  // queries of trees
  QueryCounts tested;  // the sum over these queries
  size_t faces_made = 0;
  double largest_cosine = -1;  // of the smallest angle of the faces that were created and not removed
  // Duration of the moves of the thermal model whose beam met a face [s], and its integral weighted by the
  // depth: the share of its energy of removal that the hottest face under the beam reached, 1 if one was
  // removed.
  double met_s = 0, depth_s = 0;
  double query_s = 0, refine_s = 0, remove_s = 0, update_tree_s = 0, separate_s = 0;

  void add(const StepStatistics& other);
};

// Progress of a move of the beam, so that a later step can continue it: the body, the stage, and the faces
// to process there. Default-constructed: at the start of a move. Valid only for the world as the step left
// it; any other change of the world invalidates it, and faces already removed stay removed.
struct UnfinishedMove {
  enum class Stage { kFind, kRefine, kFindAgain, kRemove, kSeparate };

  size_t bodies = 0;             // bodies completed by the move
  Stage stage = Stage::kFind;    // of the next body
  std::vector<FaceId> hit;       // faces that the beam touches, each once
  std::vector<FaceId> to_split;  // faces and parts of faces to refine; the next one is last
  std::vector<FaceId> beside;    // neighbours of removed faces; only if the cut deposits heat
  size_t removed = 0;            // number of processed faces of `hit`
  bool has_split = false;        // a face was split, so that `hit` must be found again
};

struct StepResult {
  size_t moves = 0;              // finished moves of the beam
  std::optional<BeamMove> last;  // the last of these
  Delta delta;
  StepStatistics statistics;
};

// Executes one step of a cut through all bodies that the beam may cut (see cuttable). For each move of the
// beam in turn, finds the faces that it touches (hit), splits them until they are fine enough or wholly
// inside the beam (refine), removes them (remove), and labels separated pieces (separate). The topology
// changes nowhere else. Moves are in world coordinates.
//
// The step continues the first move at `unfinished`, and ends with the last move or after settings.bite
// faces. If it ends within a move, `unfinished` holds the progress, and the next step must be given the
// moves from that one on. The result does not depend on the division into steps or on the bite: slots and
// labels of faces and boxes of the tree are the same. The world is consistent between steps; pieces that a
// move separates have their labels when the move is finished. A single query of the tree and the separation
// after one move are never divided.
//
// Fails if settings.max_faces is reached or `progress` cancels. The part of the cut that was done remains,
// but its delta is lost, so dependants of the world must rebuild from it. Resets `unfinished` then.
Result<StepResult> cut_step(World& world, const CutSettings& settings, std::span<const BeamMove> moves,
                            UnfinishedMove& unfinished, const Progress* progress = nullptr);

// Executes the next stage of a move through one body, or a part of it if the stage has many faces, and
// continues it from `unfinished` like cut_step; result.moves is 1 once the move is finished. The result of
// the move is that of cut_step.
Result<StepResult> cut_stage(World& world, const CutSettings& settings, const BeamMove& move,
                             UnfinishedMove& unfinished, const Progress* progress = nullptr);

// Executes whole moves of the beam through one body, like cut_step: for a body that moves under the beam.
// The moves are in the frame of the body. Fails like cut_step. Precondition: the body is visible.
Result<StepResult> cut_body(World& world, const CutSettings& settings, BodyId id,
                            std::span<const BeamMove> moves, const Progress* progress = nullptr);

// Moves of a stroke in the frames of those bodies that moved during the stroke.
using SweptByBody = std::map<BodyId, std::vector<BeamMove>>;

// Executes one step of ending a stroke with a smooth rim, in all bodies that the beam may cut (see
// cuttable). The previous steps of the stroke have only removed faces wholly inside the beam. This function
// cuts the faces across the boundary of the volume swept by `path` along that boundary, and removes the
// parts inside. `path` holds all moves of the stroke, in world coordinates; for the bodies in `swept`,
// their list replaces it.
//
// The step continues at `unfinished`, and ends after work worth about settings.bite faces. The rim is
// closed once unfinished.begun() is false afterwards; until then nothing else may change the world, and the
// next step must be given the same arguments. The result does not depend on the division into steps. The
// world is consistent between them, except for a body to which walls are being added (see
// UnfinishedRim::is_uninterruptible): neither `progress` nor a budget may stop it then. The last steps
// search for pieces.
//
// Faces in which a chord would deviate from the boundary by more than kRimChord are first split by the
// scheme. A vertex near the boundary is moved onto it along an edge if that does not change the surface;
// every other edge across the boundary is split there, so that the rim lies on the original surface. Finally,
// edges within one base face are flipped if that increases the smallest angle. Fails like cut_step.
Result<StepResult> rim_step(World& world, const CutSettings& settings, std::span<const BeamMove> path,
                            const SweptByBody& swept, UnfinishedRim& unfinished,
                            const Progress* progress = nullptr);

// Closes the rim in one step.
Result<StepResult> close_rim(World& world, const CutSettings& settings, std::span<const BeamMove> path,
                             const SweptByBody& swept = {}, const Progress* progress = nullptr);

// Returns true if no body has an unfinished search for separated pieces.
bool is_settled(const World& world);

// Continues these searches in all bodies, including hidden ones, visiting `most` faces in each. Once all
// are finished, applies the joints in the mode `hold`. Precondition with JointMode::kRigid: nothing edits the
// bodies until is_settled().
StepResult go_on_separating(World& world, size_t most, JointMode mode = JointMode::kRigid);

// Executes moves of the beam through one body like cut_body, but leaves the separation of parts that joints
// no longer hold to the next call of go_on_separating(): for callers that cut many bodies between two
// ticks. Fails like cut_step. Precondition: the body is visible.
Result<StepResult> cut_apart(World& world, const CutSettings& settings, BodyId id,
                             std::span<const BeamMove> moves);

}  // namespace kerf
