#pragma once

#include <queue>
#include <span>

#include "core/base/tolerances.h"
#include "core/graph/separation.h"

namespace kerf {

// The search for the parts into which components fell: a front of faces spreads from each place where
// something hung on a removed face; fronts that meet are one. The front that looked at the fewest faces goes
// on, so that the smaller of two parts is known when as much of the larger was looked at. A front that is
// exhausted is a part; the last one of a component needs not be, for the area that it must have is known:
// what the component has, less the other parts.
//
// Its state is the body's, so that it can stop at any face and go on in another step. Private to core/graph.
class PartSearch {
 public:
  explicit PartSearch(Body& body) : body_(body), state_(body.separation), search_(body.separation.search) {}

  // Which fronts are compared: those whose seeds hung together over removed faces alone, for what one step
  // took away; or all of a component as far as labels tell, where one cut came while another was searched
  // for.
  enum class Scope { kClusters, kComponents };

  // Seeds fronts at all ties that were told. No search may be open.
  void start(Scope scope);
  // Looks at so many faces or few more, and labels as many, those of the result counted. Whether it is over.
  bool go_on(size_t most, SettleResult& result);

  // f is about to be removed; the state has its neighbours.
  void note_removal(FaceId f);

  // The parts belong to what was reached with the face that they are parts of. They are looked at again, for
  // their neighbours are others.
  void note_replaced(const Replacement& replaced);
  void look_again(FaceId f);

 private:
  // The parts that were found of what one label and component counts, and the rest of that.
  struct Found {
    const Piece* whole;
    size_t faces = 0;
    double area = 0, largest = 0;
    size_t rest_faces() const { return whole->faces - faces; }
    bool rest_is_largest() const { return whole->area - area - largest > kEqualArea * whole->area; }
  };
  struct Turn {
    size_t looked_at;
    uint32_t front;
    bool operator<(const Turn& other) const {
      return looked_at != other.looked_at ? looked_at > other.looked_at : front > other.front;
    }
  };

  void seed_clusters();
  void seed_components();
  void note_looked_at(FaceId f, uint32_t mark);
  void reach(uint32_t front, FaceId f);
  void merge(uint32_t a, uint32_t b);
  void unite_groups(uint32_t a, uint32_t b);

  bool grow(size_t most, SettleResult& result);
  size_t take_turn(uint32_t front, size_t faces);
  void take_from(SearchFront& front, size_t faces);
  bool must_grow(uint32_t front);
  void sum_up();
  void note_exhausted(uint32_t front);
  Found& found_of(uint32_t front);

  void hand_out_labels(SettleResult& result);
  void leave_out_largest(std::vector<uint32_t>& parts) const;
  void give_label(uint32_t part, SettleResult& result);
  bool relabel(size_t most, SettleResult& result);

  Body& body_;
  SeparationState& state_;
  OpenSearch& search_;
  std::vector<uint32_t> open_;  // by group: how many of its fronts are not exhausted
  std::vector<Found> found_;
  std::priority_queue<Turn> turns_;
  std::vector<FaceId> turn_, neighbours_;  // scratch
};

}  // namespace kerf
