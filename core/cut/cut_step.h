#pragma once

#include <optional>
#include <span>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cut/unfinished_move.h"
#include "core/laser/laser.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// How a face is split.
enum class Scheme {
  kOneToFour,    // in four, closed with green pairs (see OneToFour)
  kLongestEdge,  // in two at its longest edge (see longest_edge.h)
};

// What is left along a stroke.
enum class Rim {
  kFaces,   // every face that the beam touches goes
  kSmooth,  // faces across the boundary of the beam are cut along it when the stroke ends (see close_rim)
};

// How finely faces are split where the beam touches them before they are removed, and what rim is left.
struct Resolution {
  enum class Rule {
    kTargetEdge,  // until the longest edge is at most target_edge
    kTolerance,   // until taking the face away overshoots the beam by at most `tolerance`
    kDepth,       // until the face lies `depth` levels under its base face; 0 removes base faces whole
  };
  Scheme scheme = Scheme::kLongestEdge;
  Rule rule = Rule::kTargetEdge;
  double target_edge = 0.0025;  // m, > 0
  double tolerance = 0.00125;   // m, > 0
  int depth = 4;                // levels, 0 .. kLargestDepth: a split in four, or two in two
  Rim rim = Rim::kFaces;        // a pattern of rays has no volume: it leaves faces

  static constexpr int kLargestDepth = 24;
  friend bool operator==(const Resolution&, const Resolution&) = default;
};

struct CutSettings {
  Laser laser;
  Resolution resolution;
  bool smooth() const { return resolution.rim == Rim::kSmooth && laser.pattern == Pattern::kVolume; }
  size_t most_faces = 20'000'000;  // a cut that would make more live faces than this stops
  // How many faces a move looks at when what came apart must be searched for; the next moves go on with it,
  // so that pieces get the same labels however moves are dealt out to steps.
  size_t search_a_move = 1'000;
  // How many faces a step finds, looks at and removes before it ends, or few more; about a millisecond. What
  // is cut does not depend on it.
  size_t bite = 3'000;
};

// What a step looked at, made and took, and how long its stages took (seconds).
struct StepFigures {
  size_t queries = 0;  // of trees, by moves of the beam
  QueryCounts tested;  // in all of these
  size_t faces_made = 0;
  double largest_cosine = -1;  // of the corners of faces that were made and are left: their smallest angle
  double query_s = 0, refine_s = 0, remove_s = 0, update_tree_s = 0, separate_s = 0;

  void add(const StepFigures& other);
};

struct StepResult {
  size_t moves = 0;              // of the beam that came to their end
  std::optional<BeamMove> last;  // the last of those
  Delta delta;
  StepFigures figures;
};

// One step of a cut through all bodies that the beam meets (see cuttable): for each move of the beam in turn
// the faces that it touches are found (hit), split until they are fine enough or wholly within the beam
// (refine), and removed; then what came apart gets labels of its own (separate). Topology changes nowhere
// else. Moves are in world coordinates.
//
// The first move is begun where it was left, and the step ends with the last move or after settings.bite
// faces, perhaps within a move: then `unfinished` says where, and the next step is given the moves from that
// one on. However moves are dealt out to steps and whatever the bite, the same faces come to the same slots
// with the same labels, and the tree to the same boxes. Between two steps the world is whole; what the move
// cut off has its label when the move is through. One search of the tree and the separation of one move are
// not parted.
//
// Fails when settings.most_faces is reached and when `progress` stops it; what was cut until then stays cut,
// the delta is lost, so that everything that follows the world must look at it anew, and nothing is
// unfinished: the move is begun anew by whoever goes on.
Result<StepResult> cut_step(World& world, const CutSettings& settings, std::span<const BeamMove> moves,
                            UnfinishedMove& unfinished, const Progress* progress = nullptr);

// Ends a stroke with a smooth rim in all bodies that the beam meets (see cuttable). While the stroke runs,
// steps take only what lies wholly within the beam; here the faces that lie across the boundary of all that
// `path` has swept are cut along it, and what is inside goes. `path` holds the moves of the whole stroke,
// world coordinates.
//
// Where a chord would leave the boundary by more than kRimChord, faces are split by the scheme first. A
// vertex near the boundary moves onto it along an edge where that leaves the surface as it was; every other
// edge across the boundary is split there, so the rim lies on the original surface. Then edges in the plane
// of one base face are turned where that makes the smallest angle larger. Fails as cut_step does.
Result<StepResult> close_rim(World& world, const CutSettings& settings, std::span<const BeamMove> path,
                             const Progress* progress = nullptr);

// Whether no search for what came apart is open in any body.
bool is_settled(const World& world);

// Goes on with those searches as a step that cuts nothing, looking at so many faces in each body, also in
// those that are hidden.
StepResult go_on_separating(World& world, size_t most);

}  // namespace kerf
