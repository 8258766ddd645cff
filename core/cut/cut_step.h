#pragma once

#include <algorithm>
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

struct CutSettings;

// Returns the bodies that a beam can cut, i.e. all visible ones, in the order of World::ids(). O(bodies).
std::vector<BodyId> cuttable(const World& world);
// Likewise, without those that CutSettings::bodies excludes. O(bodies * listed bodies).
std::vector<BodyId> cuttable(const World& world, const CutSettings& settings);

// Returns true if a beam touches a face of a cuttable body during a move in world coordinates. Otherwise the
// move removes and heats nothing in the geometric model; rays of the thermal model reach beyond the radius
// (see ray_bundle). Also returns true for a move of very many parts (see subdivide). O(log n) per part.
// Preconditions: directions are unit vectors and not opposite.
bool hits_anything(const World& world, const Laser& laser, const BeamMove& move);
// Likewise for a stationary beam.
bool hits_anything(const World& world, const Laser& laser, const Pose& pose);

// A vertex near the boundary of a stroke and its target on the boundary. `other` is the other end of the edge
// along which the vertex may move; invalid if it may move in the plane of its faces.
struct RimSnap {
  VertexId vertex, other;
  FaceId face;
  Vec3 to;
  double share = 0;  // distance from the boundary as a fraction of the edge length
};

// Progress of closing a smooth rim at the end of a stroke, which a later step continues: the current body and
// stage, and the data of that stage. Default-constructed: at the start. Valid only for the world as the last
// step left it; any other change of the world invalidates it, and faces already removed stay removed.
struct UnfinishedRim {
  enum class Stage {
    kSweep,           // collects the volume that the beam has swept in the body
    kFindNear,        // queries the tree for faces near the boundary of that volume
    kSort,            // sorts these faces by slot
    kRefine,          // splits faces until each can be cut along one chord
    kListInPlane,     // lists vertices that may move onto the boundary in the plane of their faces
    kMoveInPlane,     // moves these vertices, nearest first
    kListAlongEdges,  // lists vertices that may move onto the boundary along edges
    kMoveAlongEdges,
    kSplitInTheWay,    // splits the faces that prevented a move; then back to kRefine
    kListNear,         // lists vertices that cannot be moved but lie very near the boundary
    kSettle,           // treats these vertices as lying on it
    kClip,             // splits edges where they cross the boundary
    kChoose,           // lists the faces inside
    kRemove,           // removes these faces
    kChooseBesideRim,  // lists the faces at the rim
    kFlip,             // flips edges of these faces to enlarge the smallest angles
    kCloseByWalls,     // closes a solid body
    kHeatWalls,        // heats the walls
    kSeparate,         // searches for separated pieces
    kMeasure,          // measures the angles of all new faces
  };

  size_t bodies = 0;  // completed bodies
  Stage stage = Stage::kSweep;
  size_t next = 0;       // index of the next item of the stage
  int rounds = 0;        // of kRefine .. kSplitInTheWay, then of kFlip
  bool flipped = false;  // true if an edge was flipped in this round
  bool removed = false;  // true if faces were removed
  StrokeRegion region;
  std::vector<FaceId> faces;  // on or near the boundary of the region, followed by parts of split ones
  // Faces to process: a heap of near faces, or those to split (next one last), remove, flip or heat.
  std::vector<FaceId> waiting;
  std::vector<RimSnap> snaps;        // heap of vertices to move or settle, nearest on top
  std::vector<FaceId> in_the_way;    // faces to split because a vertex very near the boundary cannot be moved
  std::vector<FaceId> changed;       // faces changed by splits, moves and flips, with repeats
  PagedArray<uint32_t> distance_of;  // by vertex: index in `distances` plus one, or 0 if unknown
  std::vector<double> distances;
  std::shared_ptr<WallClosing> closing;  // from kCloseByWalls on; only one copy of this can be continued

  // Returns true if only the next steps of this closing may change the body, because its walls are
  // incomplete.
  bool is_uninterruptible() const { return closing && closing->is_adding(); }
  // Returns true from the first step until the rim is closed.
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
  kSmooth,  // at the end of the stroke, faces are cut along the boundary of the swept volume (see close_rim)
};

// Effect of the beam on a face.
enum class Model {
  kGeometric,  // the face is removed at once if the beam touches it
  kThermal,    // the face is heated; removed once it has absorbed its energy of removal (see thermal_step.h)
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
  int depth = 4;                // levels, 0 .. kMaxDepth; a level is one split into four or two bisections
  Rim rim = Rim::kFaces;        // ignored for a pattern of rays, which always leaves kFaces

  static constexpr int kMaxDepth = 24;
  friend bool operator==(const Resolution&, const Resolution&) = default;
};

// Requirement of the walls of solids that the settings of a cut do not meet.
enum class WallNeed { kNone, kWholeBeam, kGeometricModel, kSmoothRim };
// Returns the requirement as a clause: "walls need a smooth rim"; "" for kNone.
const char* label(WallNeed need);

struct CutSettings {
  Laser laser;
  Resolution resolution;
  Model model = Model::kGeometric;
  // The only bodies to cut; empty: all visible ones.
  std::vector<BodyId> bodies{};
  bool cuts(BodyId id) const { return bodies.empty() || std::ranges::find(bodies, id) != bodies.end(); }
  // Width of the heat-affected zone of the geometric model [m], >= 0; 0: none. See deposit_heat.
  double heat_width = 0;
  // Returns true if the cut leaves a smooth rim. That requires Pattern::kVolume and Model::kGeometric, with
  // which the beam removes everything inside its volume.
  bool smooth() const { return unmet_wall_need() == WallNeed::kNone; }
  // Returns why the cut leaves solids open; kNone if it leaves a smooth rim, along which walls close them.
  WallNeed unmet_wall_need() const {
    if (laser.pattern != Pattern::kVolume) return WallNeed::kWholeBeam;
    if (model != Model::kGeometric) return WallNeed::kGeometricModel;
    return resolution.rim == Rim::kSmooth ? WallNeed::kNone : WallNeed::kSmoothRim;
  }
  // Maximum number of live faces of a body; a cut that would exceed it fails. The default is the limit of
  // 32-bit half-edge indices; memory runs out earlier (see Document::set_face_budget).
  static constexpr size_t kMaxFaces = size_t{1} << 28;
  size_t max_faces = kMaxFaces;
  // Maximum number of faces that one move visits in a search for separated pieces; the next moves continue
  // the search. The limit is per move, not per step, so that labels do not depend on the division into steps.
  size_t search_a_move = 1'000;
  // Approximate number of faces that a step finds, examines and removes; about a millisecond of work. The
  // result of the cut does not depend on it.
  size_t faces_per_step = 3'000;
};

// Counts of the work done in a step, and the durations of its stages [s].
struct StepStatistics {
  size_t queries = 0;  // queries of trees
  QueryCounts tested;  // sum over all queries
  size_t faces_made = 0;
  double largest_cosine = -1;  // cosine of the smallest angle of all faces created and not removed
  // Thermal model: the time for which the beam hit a face, and the integral of the depth over this time [s].
  // The depth is the fraction of its energy of removal that the hottest face under the beam has reached; 1 if
  // a face was removed.
  double met_s = 0, depth_s = 0;
  double query_s = 0, refine_s = 0, remove_s = 0, update_tree_s = 0, separate_s = 0;

  void add(const StepStatistics& other);
};

// Progress within a move of the beam, which a later step continues: the current body and stage, and the faces
// to process. Default-constructed: at the start of a move. Valid only for the world as the last step left it;
// any other change of the world invalidates it, and faces already removed stay removed.
struct UnfinishedMove {
  enum class Stage { kFind, kRefine, kFindAgain, kRemove, kSeparate };

  size_t bodies = 0;             // bodies completed by the move
  Stage stage = Stage::kFind;    // of the next body
  std::vector<FaceId> hit;       // faces that the beam touches, each once
  std::vector<FaceId> to_split;  // faces and parts of faces to refine; the last one is processed first
  std::vector<FaceId> beside;    // neighbours of removed faces; filled only if the cut deposits heat
  size_t removed = 0;            // number of processed faces of `hit`
  bool has_split = false;        // true if a face was split, so that `hit` is out of date
};

struct StepResult {
  size_t moves = 0;              // number of moves completed in the step
  std::optional<BeamMove> last;  // the last completed move
  Delta delta;
  StepStatistics statistics;
};

// Executes one step of a cut through all bodies that the settings let the beam cut (see cuttable). For each
// move of the beam in turn, finds the faces that it touches (hit), splits them until they are fine enough or
// wholly inside the beam (refine), removes them (remove), and labels separated pieces (separate). Faces are
// split and removed nowhere else. Moves are in world coordinates.
//
// The step resumes the first move from `unfinished`, and ends with the last move or after
// settings.faces_per_step faces. If it ends within a move, `unfinished` holds the progress, and the caller
// must pass the moves from that one on to the next step. The result does not depend on the division into
// steps or on faces_per_step: slots and labels of faces and boxes of the tree are the same. The world is
// consistent between steps; pieces that a move separates have their labels when the move is finished. A step
// never ends within a query of the tree or within the separation after a move.
//
// Fails if settings.max_faces is reached, or with cancelled() if `progress` stops the step. The completed
// part of the cut then remains, its delta is lost, so that caches of the world must be rebuilt, and
// `unfinished` is reset.
Result<StepResult> cut_step(World& world, const CutSettings& settings, std::span<const BeamMove> moves,
                            UnfinishedMove& unfinished, const Progress* progress = nullptr);

// Executes the next stage of a move in one body, or a part of that stage if it has many faces, starting from
// `unfinished` like cut_step. StepResult::moves is 1 once the move is complete. The move has the same result
// as with cut_step.
Result<StepResult> cut_stage(World& world, const CutSettings& settings, const BeamMove& move,
                             UnfinishedMove& unfinished, const Progress* progress = nullptr);

// Like cut_step, but executes complete moves of the beam through a single body, for bodies that move under
// the beam. The moves are in the frame of the body. Fails like cut_step. Precondition: the body is visible.
Result<StepResult> cut_body(World& world, const CutSettings& settings, BodyId id,
                            std::span<const BeamMove> moves, const Progress* progress = nullptr);

// For each body that moved during a stroke, the moves of the stroke in the frame of the body.
using SweptByBody = std::map<BodyId, std::vector<BeamMove>>;

// Executes one step of closing a smooth rim at the end of a stroke, in all cuttable bodies (see cuttable).
// Earlier steps of the stroke removed only faces wholly inside the beam. This function cuts the faces that
// straddle the boundary of the volume swept by `path` along that boundary, and removes the parts inside.
// `path` holds all moves of the stroke in world coordinates; a body listed in `swept` uses its list there
// instead.
//
// The step resumes from `unfinished`, and ends after work worth about settings.faces_per_step faces. The rim
// is closed if unfinished.begun() is false afterwards; until then no other code may change the world, and the
// next step takes the same arguments. The result does not depend on the division into steps. The world is
// consistent between them, except for a body to which walls are being added (see
// UnfinishedRim::is_uninterruptible): neither `progress` nor a budget may stop it then. The last steps search
// for pieces.
//
// Faces in which a chord would deviate from the boundary by more than kRimChord are first split by the
// scheme. A vertex near the boundary is moved onto it along an edge if that does not change the surface;
// every other edge is split where it crosses the boundary, so that the rim lies on the original surface.
// Finally, edges within one base face are flipped if that increases the smallest angle. Fails like cut_step.
Result<StepResult> rim_step(World& world, const CutSettings& settings, std::span<const BeamMove> path,
                            const SweptByBody& swept, UnfinishedRim& unfinished,
                            const Progress* progress = nullptr);

// Closes the rim in one step.
Result<StepResult> close_rim(World& world, const CutSettings& settings, std::span<const BeamMove> path,
                             const SweptByBody& swept = {}, const Progress* progress = nullptr);

// Returns true if no body has an unfinished search for separated pieces.
bool is_settled(const World& world);

// Continues the searches for separated pieces in all bodies, including hidden ones, and visits at most `most`
// faces in each. Once all searches are complete, applies the joints in this mode. Precondition with
// JointMode::kRigid: no other code edits the bodies until is_settled().
StepResult continue_separation(World& world, size_t most, JointMode mode = JointMode::kRigid);

// Like cut_body, but leaves the separation of parts that joints no longer hold to the next call of
// continue_separation(). For callers that cut many bodies between two ticks. Fails like cut_step.
// Precondition: the body is visible.
Result<StepResult> cut_without_separation(World& world, const CutSettings& settings, BodyId id,
                                          std::span<const BeamMove> moves);

}  // namespace kerf
