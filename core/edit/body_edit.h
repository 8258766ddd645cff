#pragma once

#include <span>
#include <vector>

#include "core/edit/separation.h"
#include "core/mesh/mesh.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// All edits of the faces of a body, i.e. splitting, removing, flipping and moving, use this class. It keeps
// all data that depend on faces consistent: the mesh with its columns, green pairs (OneToFour), the tree, the
// counts, areas and moments of pieces, the separation state, and the delta.
//
// The tree is updated in batches, which is faster for many faces. Call update_tree() after splits and after
// removals, and refit_tree() after the last vertex move or edge flip. Queries of the tree are allowed between
// updates. The destructor executes pending updates, so that the body is consistent however the edit ends.
//
// Precondition of every function that takes faces: they are live, and given vertices are corners of them.
class BodyEdit {
 public:
  // Preconditions: `body` outlives the edit, and no other code edits its faces during the edit.
  explicit BodyEdit(Body& body) : body_(&body) {}
  ~BodyEdit();
  BodyEdit(BodyEdit&&) noexcept = default;
  BodyEdit& operator=(BodyEdit&&) = delete;

  const Body& body() const { return *body_; }
  const Mesh& mesh() const { return body_->mesh; }

  // Splits the element of f into four (OneToFour::split), or bisects f at its longest edge
  // (bisect_longest_edge), with all dependent faces. No-op if f is so small that midpoints round to corners.
  void split_in_four(FaceId f);
  void bisect_at_longest_edge(FaceId f);
  // Splits the edge of f from corner `from` to its next corner `to`, with all faces on it. Appends one entry
  // per face. Precondition: `at` is a point of the edge and neither of its ends.
  void split_edge_at(FaceId f, VertexId from, VertexId to, const Vec3& at, std::vector<Mesh::FaceSplit>& out);
  // Replacements of faces split since the last update_tree(), in order.
  std::span<const Replacement> splits() const { return splits_; }

  // Removes the faces that are still live, updates the counts of their pieces and reports them to the
  // separation state. Precondition: update_tree() was called after the last split.
  void remove(std::span<const FaceId> faces);

  // Adds the next faces of an addition as walls (see WallFaces), each with the label and the loaded part of
  // its adjacent face in the list, and returns them. Their material is cut_material(), or that of this face
  // if the body has none. Precondition: the body is settled.
  std::vector<FaceId> add_walls(FaceAddition& addition, std::span<const FaceId> beside);
  bool split_fans(FaceAddition& addition, size_t most);
  void weld(FaceAddition& addition, uint32_t v, VertexId other) {
    addition.weld(body_->mesh, v, other, moved_);
  }
  // Disconnects sides from the other faces on their edges (see Mesh::open_edges). Call search_from() before
  // the body is searched for parts again. Precondition: update_tree() was called after the last split.
  void open_edges(std::span<const Mesh::Side> sides);
  VertexId add_vertex(const Vec3& position) { return body_->mesh.add_vertex(position); }
  // Merges the connected parts of two faces that a wall has joined. Precondition: their labels are equal.
  void join_parts(FaceId a, FaceId b) { kerf::join_parts(*body_, a, b); }
  // Makes the next calls of separate() search for parts from these faces, regardless of removals.
  void search_from(std::span<const FaceId> faces) { kerf::search_from(*body_, faces); }

  // Flips the edge between f and its neighbour. Preconditions: Mesh::can_flip_edge(), and both faces are
  // coplanar.
  void flip_edge(FaceId f, VertexId from, VertexId to);

  // Moves a vertex. Precondition: `around` is its complete star (Mesh::Star::alone).
  void move_vertex(VertexId v, const Vec3& to, const Mesh::Star& around);

  // Extracts whole pieces from the body. The faces do not count as removed by a beam: they separate nothing
  // and are not in the delta. Preconditions: `faces` are all faces of these pieces, ascending, and the body
  // is settled.
  void take_out(std::span<const FaceId> faces);

  // Updates the tree for the splits or the removals since the last call.
  void update_tree();
  // Refits the boxes of the tree to faces whose corners have changed.
  void refit_tree();

  // Calls AabbTree::touched and sets FaceData::hit of the faces whose boxes it met.
  QueryCounts touched(const SweptCylinder& beam, std::vector<FaceId>& out);
  void clear_hit(FaceId f);

  // Searches for separated parts (see settle), visiting about `most` faces. Returns the number of faces
  // visited and relabelled.
  size_t separate(size_t most, EditPolicy policy = EditPolicy::kAllowEdits);

  // Number of faces created by splits, minus those split.
  size_t faces_made() const { return faces_made_; }
  size_t removed_faces() const { return removed_faces_; }
  // Area lost by the body (m^2); see Delta::removed_area.
  double removed_area() const { return removed_area_; }
  // Walls added, and volume lost by a solid body.
  const SolidChange& solid() const { return solid_; }

  // Returns true if the edit changed anything that a delta contains.
  bool any() const { return !edited_.empty() || !relabelled_.empty() || !new_pieces_.empty(); }
  // Returns the changes so far as the delta of the body with this id, and starts the next delta.
  BodyDelta take_delta(BodyId id);

 private:
  void count(FaceId f, int faces, double area);
  AreaMoments moments_of(FaceId f) const;
  void remove_face(FaceId f);
  void record_removal(FaceId f, const Triangle& corners, int64_t loops_before);
  void forget_pair(FaceId f) { body_->refinement.forget(body_->mesh, f); }
  void record_splits(size_t first);

  Body* body_;
  std::vector<Replacement> splits_;  // not applied to the tree yet
  std::vector<FaceId> removed_;      // likewise
  std::vector<FaceId> moved_;        // faces whose boxes must be refitted, with repeats
  std::vector<FaceId> edited_;       // slots that were created, reused or removed, with repeats
  std::vector<FaceId> relabelled_;
  std::vector<uint32_t> new_pieces_;
  std::vector<CutFace> cut_faces_;
  size_t faces_made_ = 0, removed_faces_ = 0;
  double removed_area_ = 0;
  SolidChange solid_;
};

}  // namespace kerf
