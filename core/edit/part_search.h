#pragma once

#include <cassert>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "core/base/containers.h"
#include "core/base/ids.h"
#include "core/base/tolerances.h"
#include "core/edit/separation.h"
#include "core/mesh/face_batches.h"
#include "core/world/world.h"

namespace kerf {

// Connected components of faces over ties: pairs of a removed face and a former neighbour.
class TieClusters {
 public:
  // O(n). All items of `scratch` must be 0, and are 0 afterwards.
  TieClusters(std::span<const std::pair<FaceId, FaceId>> ties, PagedArray<uint32_t>& scratch);

  // Faces of all ties, each once, in order of first appearance.
  std::span<const FaceId> faces() const { return faces_; }
  // Returns the cluster of faces()[place]: the place of its first face. Precondition: place < faces().size().
  uint32_t cluster(uint32_t place) {
    assert(place < faces_.size());
    return clusters_.find(place);
  }

 private:
  std::vector<FaceId> faces_;
  UnionFind clusters_;
};

// Estimates which of two fronts of an open search will become the larger part. Samples faces of the component
// and assigns each to the front that has reached it, or else to the nearer one. Preconditions: both fronts
// grow in one component, and both have a frontier. Reads a few hundred faces.
uint32_t estimate_larger_front(const Body& body, uint32_t a, uint32_t b);

// Searches for the parts into which components were separated. A front of faces spreads breadth-first from
// every former neighbour of a removed face, and fronts that meet are merged. The front with the fewest
// visited faces advances, so that the smaller of two parts is complete once as many faces of the larger one
// were visited. An exhausted front is a part. The last front of a component need not be exhausted, because
// its area is that of the component minus the other parts. Fronts that do not meet are independent of each
// other. Therefore, if no faces are edited during the search, of the last two fronts the one estimated to
// become the larger part is held back, which does not change the result.
//
// The state is stored in the body, so that the search can stop at any face and continue in a later step.
class PartSearch {
 public:
  explicit PartSearch(Body& body, EditPolicy policy = EditPolicy::kAllowEdits)
      : body_(body),
        state_(body.separation),
        search_(body.separation.search),
        compares_(policy == EditPolicy::kNoEdits),
        walk_(body.mesh) {}

  // Fronts that may belong to the same component. kClusters: fronts whose seeds were connected over removed
  // faces; sufficient for the removals of one step. kComponents: fronts whose faces have the same label and
  // component, for removals during an open search.
  enum class Scope { kClusters, kComponents };

  // Starts a front at every live face of the recorded ties. Precondition: no search is open.
  void start(Scope scope);
  // Runs until `result` counts about `most` visited and as many relabelled faces. Returns true if complete.
  bool continue_search(size_t most, SettleResult& result);

  // Updates the search for the removal of f. Preconditions: f is live and about to be removed,
  // state.neighbours holds its neighbours.
  void record_removed_part(FaceId f);

  // Updates the search for a split: the parts of a face belong to its front, and are visited again.
  void record_replaced(const Replacement& replaced);

  // Updates the search for a flip of an edge of f, which is visited again.
  void record_flipped(FaceId f, double area_gained);

 private:
  // The parts found of one component, and its remainder.
  struct Found {
    const FaceCounts* whole;
    size_t faces = 0;
    double area = 0, largest = 0;
    size_t rest_faces() const { return whole->faces - faces; }
    bool rest_is_largest() const { return whole->area - area - largest > kEqualArea * whole->area; }
  };
  // The turn of a front, the lowest rank first: the number of visited faces, times a handicap for a front
  // that is likely to be the larger part.
  struct Turn {
    size_t rank;
    uint32_t front;
    bool operator<(const Turn& other) const {
      return rank != other.rank ? rank > other.rank : front > other.front;
    }
  };

  void seed_clusters();
  void seed_components();
  void record_visited(FaceId f, uint32_t mark, double area);
  void revisit(FaceId f);
  double half_of(const Replacement& replaced) const;
  void reach(uint32_t front, const ReachedFace& reached);
  void reach_face(uint32_t front, const ReachedFace& reached);
  void merge(uint32_t a, uint32_t b);
  void unite_groups(uint32_t a, uint32_t b);

  bool grow(size_t most, SettleResult& result);
  size_t rank_of(uint32_t front) const;
  void queue(uint32_t front) { turns_.push({rank_of(front), front}); }
  bool compare(uint32_t front);
  uint32_t only_other(uint32_t front) const;
  size_t take_turn(uint32_t front, size_t faces);
  void take_from(SearchFront& front, size_t faces);
  bool must_grow(uint32_t front);
  void sum_up();
  void record_exhausted(uint32_t front);
  Found& found_of(uint32_t front);

  // In separation.cpp.
  void assign_labels(SettleResult& result);
  void drop_largest(std::vector<uint32_t>& parts) const;
  void give_label(uint32_t part, SettleResult& result);
  void relabel(size_t most, SettleResult& result);
  bool find_unlabelled(size_t most);
  void assign_label(FaceId f, uint32_t label, SettleResult& result);
  void move_moments(std::span<const FaceId> faces);
  void reset();

  static uint32_t root(std::vector<uint32_t>& parent, uint32_t x);

  Body& body_;
  SeparationState& state_;
  OpenSearch& search_;
  bool compares_;               // true to estimate the larger of two fronts
  std::vector<uint32_t> open_;  // by group: the number of its fronts that are not exhausted
  std::vector<Found> found_;
  std::priority_queue<Turn> turns_;
  FaceWalk walk_;
  // Scratch.
  std::vector<ReachedFace> turn_;
  std::vector<FaceId> unlabelled_;
  std::vector<uint32_t> moved_from_;  // former pieces of relabelled faces
};

}  // namespace kerf
