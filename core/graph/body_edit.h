#pragma once

#include <span>
#include <vector>

#include "core/graph/separation.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// The one way in which faces of a body are split, removed, turned and moved. An edit keeps up all that hangs
// on the faces: the mesh with its columns, green pairs (OneToFour), the tree, the counts, areas and moments
// of the pieces, what the graph must know to find what came apart, and the delta.
//
// The tree follows late, for it is faster with many faces at once, and the order in which it is told decides
// the order in which it finds faces: update_tree() after splits and after removals, refit_tree() after the
// last vertex was moved or edge turned. Queries of the tree are allowed between. The destructor lets the tree
// follow what is left, so that the body is whole whatever stopped the work.
//
// Precondition of every function that takes faces: they are live, and the vertices are their corners.
class BodyEdit {
 public:
  // `body` outlives the edit; meanwhile nothing else edits its faces.
  explicit BodyEdit(Body& body) : body_(&body) {}
  ~BodyEdit();
  BodyEdit(BodyEdit&&) noexcept = default;
  BodyEdit& operator=(BodyEdit&&) = delete;

  const Body& body() const { return *body_; }
  const Mesh& mesh() const { return body_->mesh; }

  // Splits the element of f in four (OneToFour::split), or f in two at its longest edge
  // (bisect_longest_edge), and whatever must follow. Nothing happens where coordinates have no midpoints.
  void split_in_four(FaceId f);
  void bisect_at_longest_edge(FaceId f);
  // Splits the edge of f from corner `from` to the next corner `to` at a point of it that is neither end,
  // with all faces on the edge; appends one entry a face.
  void split_edge_at(FaceId f, VertexId from, VertexId to, const Vec3& at, std::vector<Mesh::FaceSplit>& out);
  // What became of faces that were split since the last update_tree(), in order.
  std::span<const Replacement> splits() const { return splits_; }

  // Removes those of the faces that are still live. Their counts go from their piece, and the graph is told.
  // No splits may wait for update_tree().
  void remove(std::span<const FaceId> faces);

  // Turns the edge between f and its neighbour over, which Mesh::can_flip_edge allows. Both lie in one plane.
  void flip_edge(FaceId f, VertexId from, VertexId to);

  // Moves a vertex; `around` is its star, all of it (Mesh::Star::alone).
  void move_vertex(VertexId v, const Vec3& to, const Mesh::Star& around);

  // Takes whole pieces out, whose faces these are, ascending: they are not removed by a beam, so nothing
  // comes apart and the delta does not count them. The body is settled.
  void take_out(std::span<const FaceId> faces);

  // Lets the tree follow the splits or the removals since the last call.
  void update_tree();
  // Fits the boxes of the tree to the faces whose corners have moved or changed.
  void refit_tree();

  // AabbTree::touched, which remembers in the tree where the beam was.
  QueryCounts touched(const SweptCylinder& beam, std::vector<FaceId>& out);

  // Searches for what came apart (see settle), looking at `most` faces or few more; how many it looked at,
  // those with a new label among them.
  size_t separate(size_t most);

  // Faces that splits have made, those that were split taken off.
  size_t faces_made() const { return faces_made_; }
  size_t removed_faces() const { return removed_faces_; }
  // Area that the body has lost (m^2, see Delta::removed_area).
  double removed_area() const { return removed_area_; }

  // Whether the edit changed anything that a delta tells of.
  bool any() const { return !edited_.empty() || !relabelled_.empty() || !new_pieces_.empty(); }
  // What changed so far, as the delta of the body with that id; what follows is a delta of its own.
  BodyDelta take_delta(BodyId id);

 private:
  void count(FaceId f, int faces, double area);
  AreaMoments moments_of(FaceId f) const;
  void remove_face(FaceId f);
  void forget_pair(FaceId f) { body_->refinement.forget(body_->mesh, f); }
  void note_splits(size_t first);

  Body* body_;
  std::vector<Replacement> splits_;  // that the tree has not followed yet
  std::vector<FaceId> removed_;      // the same
  std::vector<FaceId> moved_;        // faces that the tree must be fitted to, with repeats
  std::vector<FaceId> edited_;       // slots that were born, reused or removed, with repeats
  std::vector<FaceId> relabelled_;
  std::vector<uint32_t> new_pieces_;
  size_t faces_made_ = 0, removed_faces_ = 0;
  double removed_area_ = 0;
};

}  // namespace kerf
