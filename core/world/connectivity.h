#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/containers.h"
#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/base/records.h"
#include "core/base/result.h"
#include "core/mesh/face_batches.h"
#include "core/mesh/mesh.h"

namespace kerf {

// Number and area of a set of live faces.
struct FaceCounts {
  size_t faces = 0;
  double area = 0;  // m^2
};

// The connected components of a mesh as loaded. The remaining faces of a component belong to its home piece:
// the one with label 0, or the one to which joints attach it. A part cut off a component is itself connected,
// and its piece counts it (Piece::cut_off), so the counts of the connected part that contains a face are
// known without a search.
struct LoadedComponents {
  static constexpr uint32_t kNone = 0xffffffffu;

  std::vector<uint32_t> of_base;  // by base face; all lists are empty if the mesh is connected
  Records<FaceCounts> left;       // by component: its faces that have the label of its home piece
  // By component: label of its home piece; kNone if a wall merged it into a part that was cut off.
  Records<uint32_t> home;
  // By component: the component that a wall merged it into, plus one; 0 or beyond the end if none did.
  Records<uint32_t> joined;

  // Returns the component into which walls merged a component; the same one if none did.
  uint32_t merged(uint32_t component) const {
    while (component < joined.size() && joined[component] != 0) component = joined[component] - 1;
    return component;
  }
  // Returns the component of a base face, as merged by walls. Precondition: the mesh was not connected.
  uint32_t of(FaceId base) const { return merged(of_base[base.index]); }

  // Returns the component of the faces with this base face and label; kNone if they were cut off or the mesh
  // was connected.
  uint32_t at_home(FaceId base, uint32_t label) const {
    if (of_base.empty()) return kNone;
    const uint32_t component = of(base);
    return home[component] == label ? component : kNone;
  }

  size_t bytes() const {
    return of_base.capacity() * sizeof(uint32_t) + left.bytes() + home.bytes() + joined.bytes();
  }

  // Merges two components into the lower number. Precondition: both are values of of(), differ, and share a
  // home.
  void join(uint32_t a, uint32_t b);

  class Change;
  template <typename Self>
  static auto parts(Self& self) {
    return std::tie(self.left, self.home, self.joined);
  }
};

class LoadedComponents::Change : public ChangeOfParts<LoadedComponents> {};

// Counts the faces of each component of a mesh as loaded. `components`: number of components. Fails with
// cancelled() when stopped; `progress` may be null. O(n), or O(1) if the mesh is connected.
Result<LoadedComponents> count_components(const Mesh& mesh, size_t components, const Progress* progress);

// One side of a joint. The faces that carry it are the parts of the listed base faces within `radius` of
// `point`; all belong to one connected component.
struct JointSide {
  std::vector<uint32_t> faces;  // base faces of the body as loaded, ascending and not empty
  bool carries(FaceId loaded) const { return std::ranges::binary_search(faces, loaded.index); }
  uint32_t component = 0;                                   // of LoadedComponents
  Vec3 point{0};                                            // m, in the frame of the body
  double radius = std::numeric_limits<double>::infinity();  // m
  // For a hinge, the distance from its anchor within which faces hold the pin [m]. A beam that removes all
  // faces within this distance cuts the hinge, even if it passes between the faces of both sides.
  double reaches_pin = std::numeric_limits<double>::infinity();
};

// A joint between two parts of a mesh that are not connected, or no longer connected after a cut.
//
// A joint is intact while each side has remaining faces, these are connected, and, for a hinge, some of them
// reach its pin. This follows from the faces alone (see held_joints in core/joints), so undo and replay store
// no state of joints.
struct Joint {
  enum class Kind : uint8_t {
    kWeld,   // the parts move as one
    kHinge,  // rotation about the axis, within limits
    kHub,    // free rotation about the axis, as of a wheel
  };
  Kind kind = Kind::kWeld;
  BodyId body;  // body with which the parts were loaded (Body::loaded_as)
  std::array<JointSide, 2> sides;
  Vec3 anchor{0};                  // m, a point of the axis, in the frame of the body
  Vec3 axis{0, 1, 0};              // unit, in the frame of the body
  std::optional<Interval> limits;  // angle of the first part relative to the second [rad]
};

// All joints of a world; cuts do not change them.
struct Joints {
  std::vector<Joint> all;

  std::vector<const JointSide*> sides_of(BodyId body) const {
    std::vector<const JointSide*> sides;
    for (const Joint& joint : all) {
      if (joint.body == body) sides.insert(sides.end(), {&joint.sides[0], &joint.sides[1]});
    }
    return sides;
  }
};

// A breadth-first search over faces from one or more seeds.
struct SearchFront {
  std::vector<ReachedFace> frontier;  // faces reached; those from index `next` on are unvisited
  size_t next = 0;
  size_t visited = 0;             // faces visited
  size_t faces = 0;               // live faces among them
  double area = 0;                // of the live faces, m^2
  uint32_t lowest = 0xffffffffu;  // the lowest slot reached
  bool compared = false;          // true if compared with the only other growing front of its component
  bool estimated_larger = false;  // true if estimated to be larger than that front
  bool exhausted() const { return next == frontier.size(); }
};

// A search for separated parts that may span several steps; see PartSearch.
struct OpenSearch {
  enum class Stage { kNone, kGrow, kRelabel };
  static constexpr uint32_t kVisited = 0x80000000u;

  Stage stage = Stage::kNone;
  bool restart_requested = false;  // true if faces removed during this search require another search
  PagedArray<uint32_t>
      mark;  // by face slot: the front that reached it plus one, or 0; plus kVisited once visited
  std::vector<SearchFront> fronts;
  std::vector<uint32_t> front_parent;  // by front: union-find of fronts that met
  std::vector<FaceId> seed;            // by front
  std::vector<uint32_t> group;         // by front: the component of its seed before the removals
  std::vector<uint32_t> group_parent;  // by group: union-find of groups that were connected
  // By front, including merged ones, while faces are relabelled; 0 to keep the label.
  std::vector<uint32_t> new_label;
  uint32_t next_slot = 0;  // the first face slot not yet relabelled

  // Returns the front that has reached the face, or null.
  SearchFront* front_of(FaceId f) { return const_cast<SearchFront*>(std::as_const(*this).front_of(f)); }
  const SearchFront* front_of(FaceId f) const {
    const uint32_t marked = mark.get(f.index) & ~kVisited;
    if (marked == 0) return nullptr;
    uint32_t front = marked - 1;
    while (front_parent[front] != front) front = front_parent[front];
    return &fronts[front];
  }
  // Returns the label that relabelling will give to the face; 0 if it keeps its own.
  uint32_t label_to_be(FaceId f) const { return stage == Stage::kRelabel ? label_of(mark.get(f.index)) : 0; }
  // Returns the label that relabelling gives to faces with this mark; 0 if they keep theirs. Precondition:
  // faces are being relabelled.
  uint32_t label_of(uint32_t marked) const {
    const uint32_t front = marked & ~kVisited;
    return front == 0 ? 0 : new_label[front - 1];
  }

  // Memory of what grows with the mesh.
  size_t bytes() const {
    size_t bytes = mark.bytes();
    for (const SearchFront& front : fronts) bytes += front.frontier.capacity() * sizeof(ReachedFace);
    return bytes;
  }
};

// Records that core/edit keeps about faces removed from a body. They may be discarded between two strokes,
// because they can be derived from the mesh.
struct SeparationState {
  PagedArray<uint32_t>
      joined;  // by vertex slot: its parent in the union-find of CutLoops plus one, or 0 if unknown

  // Pairs of a removed face and a former neighbour, since the last settle() or the start of an open search.
  std::vector<std::pair<FaceId, FaceId>> ties;
  PagedArray<uint32_t> tie_place;  // scratch of TieClusters

  // Removals since the last call of settle().
  size_t first_tie = 0;
  int64_t loops = 0;             // number of loops closed by the cut, minus `alone`
  int64_t alone = 0;             // number of removed faces without a neighbour
  bool any_closed = false;       // true if any loop was closed, regardless of `alone`
  bool over_rings = false;       // a removed face was connected over a ring: `loops` is inconclusive
  bool is_inconclusive = false;  // true if such a face had more than one neighbour

  // True to check joints (see separate_by_joints): faces that carry joints were removed, or parts separated.
  bool joints_requested = false;
  // True to check cavities (see assign_cavities): walls were added.
  bool cavities_requested = false;

  OpenSearch search;

  // Scratch.
  std::vector<FaceId> neighbours;
  std::vector<VertexId> rim;
  Mesh::Star star;

  // Memory of what grows with the mesh.
  size_t bytes() const {
    return joined.bytes() + ties.capacity() * sizeof(ties[0]) + tie_place.bytes() + search.bytes();
  }

  // Not recorded for undo: exchanging the faces discards it (see ChangeOf).
  struct Change {
    void begin(SeparationState&) {}
    void end(SeparationState&) {}
    bool any() const { return false; }
    void exchange(SeparationState& state) { state = SeparationState(); }
    void restore(SeparationState& state) const { state = SeparationState(); }
    size_t bytes() const { return 0; }
  };
};

}  // namespace kerf
