#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/base/containers.h"
#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"

namespace kerf {

// A light in homogeneous coordinates: a position with w = 1, or with w = 0 the direction towards a light at
// infinity, of any length but zero. The frame depends on the context.
struct LightPoint {
  Vec3 xyz{0, 1, 0};
  double w = 0;
  friend bool operator==(const LightPoint&, const LightPoint&) = default;
};

struct Light {
  enum class Kind { kDirectional, kPoint };

  Kind kind = Kind::kDirectional;
  // In world coordinates. kDirectional: the direction to the light, of any length but zero; kPoint: its
  // position [m].
  Vec3 at{-0.42, 1.0, 0.62};
  Vec3 colour{1.0, 0.938, 0.848};  // linear RGB
  // Irradiance of a surface that faces the light, relative to the display's white; 2.1 is a bright key light.
  // For a point light it holds at a distance of one diagonal of the world when it was first shown, and falls
  // off with the squared distance.
  double intensity = 2.1;

  // Returns the light in homogeneous world coordinates.
  LightPoint point() const { return {at, kind == Kind::kPoint ? 1.0 : 0.0}; }
  friend bool operator==(const Light&, const Light&) = default;
};

// The triangles of a body as shadow casters, independent of any light: for each side of a triangle the edge
// it lies on, identified by position alone. Half-edges are unsuitable, because they have no edge of three
// faces.
//
// Positions are those drawn by the GPU: floats of a FloatFrame. Two corners are the same vertex if these
// floats are equal to the bit (-0.0 counts as +0.0) and their faces belong to the same piece, so that a piece
// can be drawn displaced or hidden. A triangle with two equal corners casts no shadow; of triangles with the
// same three corners only the one in the lowest slot casts.
//
// The numbers of vertex and edge slots never decrease. Takes about 82 bytes per face.
class ShadowCaster {
 public:
  // By face slot, the label that replaces its piece when loose parts are drawn apart; its piece beyond the
  // end.
  using Labels = std::span<const uint32_t>;

  // Adds all live faces of the mesh. Expected linear time.
  ShadowCaster(const Mesh& mesh, const FloatFrame& frame, Labels labels = {});
  // Builds a caster of all live faces; fails with cancelled() when stopped. `progress` may be null.
  static Result<ShadowCaster> build(const Mesh& mesh, const FloatFrame& frame, const Progress* progress);

  // The slots of faces and edges that update() changed, ascending, each once.
  struct Change {
    std::vector<uint32_t> faces, edges;
  };
  // Updates these face slots from the mesh; they may be new, dead or unchanged, and slots that undo removed
  // from the mesh are dead. `relabelled` are slots whose label alone may have changed, which skips their
  // corners; slots in both lists are updated fully. Expected time linear in the number of slots times the
  // number of faces on their edges. If all faces at a vertex get the same new label, the vertex and its edges
  // keep their slots.
  Change update(const Mesh& mesh, std::span<const uint32_t> slots, std::span<const uint32_t> relabelled = {},
                Labels labels = {});

  uint32_t face_slots() const { return static_cast<uint32_t>(casts_.size()); }
  uint32_t edge_slots() const { return static_cast<uint32_t>(edges_.size()); }

  // Returns true if the face exists and casts a shadow. Precondition: face < face_slots().
  bool casts(uint32_t face) const {
    assert(face < face_slots());
    return casts_[face] != 0;
  }
  // Corners of a face in the float frame, and its piece. Precondition: the face casts a shadow.
  std::array<glm::vec3, 3> corners(uint32_t face) const;
  uint32_t piece(uint32_t face) const {
    assert(casts(face));
    return vertices_[corner_[3 * face]].piece;
  }

  // Ends of an edge in the float frame. `low` precedes `high` in the lexicographic order of x, y
  // and z, so that equal edges of different bodies and pieces are drawn identically to the bit.
  struct Ends {
    glm::vec3 low, high;
    uint32_t piece;
  };
  // Precondition: edge < edge_slots().
  Ends ends(uint32_t edge) const;

  // Calls visit(face, along) for every triangle on the edge, casting or not; `along` is 1 if the triangle's
  // boundary runs from low to high there, else -1. Precondition: edge < edge_slots().
  template <typename Visit>
  void for_each_face_on(uint32_t edge, const Visit& visit) const {
    assert(edge < edge_slots());
    for (uint32_t side = edges_[edge].first; side != kNone; side = sides_[side].next) {
      visit(side / 3, sides_[side].edge & 1u ? -1 : 1);
    }
  }

  const FloatFrame& frame() const { return frame_; }

  size_t bytes() const;

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  struct Vertex {
    glm::vec3 at;
    uint32_t piece;
    uint32_t uses;  // number of face corners
  };
  // A face that changes its label but not its corners.
  struct Relabelled {
    uint32_t face, from, to;
  };
  struct Edge {
    uint32_t low, high;  // vertices
    uint32_t first;      // side
    uint32_t faces;
  };
  // Side 3 f + i of face f runs from its corner i to its next corner.
  struct Side {
    uint32_t edge;  // twice the edge, plus one if it runs from high to low
    uint32_t next;  // the next side on the same edge
  };

  explicit ShadowCaster(const FloatFrame& frame) : frame_(frame) {}

  // Adds all faces of a mesh to an empty caster. Returns false if stopped.
  bool add_all(const Mesh& mesh, Labels labels, const Progress* progress);
  void grow(uint32_t faces);
  uint32_t find_vertex(const Vec3& p, uint32_t piece);
  uint32_t known_vertex(const glm::vec3& at, uint32_t piece) const;
  uint32_t find_side_edge(uint32_t from, uint32_t to);
  bool there(uint32_t face) const { return corner_[3 * face] != kNone; }
  std::array<uint32_t, 3> sorted_corners(uint32_t face) const;
  bool stands_still(const Mesh& mesh, uint32_t face) const;
  void record_label(uint32_t face, uint32_t label, std::vector<Relabelled>& out) const;
  std::vector<uint32_t> relabel(std::span<const Relabelled> faces, Change& change);
  void rename_vertex(uint32_t vertex, uint32_t piece);
  // add, put and find_copies set `copies_` to the faces with the corners of `face`; take_away excludes
  // `face`.
  void add(const Mesh& mesh, uint32_t face, Labels labels);
  void put(uint32_t face, const std::array<uint32_t, 3>& corners);
  void take_away(uint32_t face);
  void find_copies(uint32_t face);
  void let_lowest_cast();
  void append_edges(uint32_t face, std::vector<uint32_t>& out) const;
  void link(uint32_t side, uint32_t edge_and_way);
  void unlink(uint32_t side);

  FloatFrame frame_;
  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::vector<uint32_t> corner_;  // three per face slot; kNone without a face that could cast
  std::vector<Side> sides_;       // three per face slot
  std::vector<uint8_t> casts_;    // by face slot
  KeyTable vertex_table_, edge_table_;
  std::vector<uint32_t> copies_;  // scratch memory
};

// Construction of the shadow volume of a body.
enum class ShadowMethod {
  // The method of the paper: the polygons that face the light are the cap, and the edges that belong to
  // exactly one of them are the silhouette.
  kPaperOneVolume,
  // Adds the same for the polygons that face away from the light, the paper's method for hollow meshes.
  kPaperTwoVolumes,
  // Every polygon, oriented towards the light, spans its own closed volume; along each edge their sides are
  // added with their signs (G. Aldridge, E. Woods: Robust, geometry-independent shadow volumes, 2004, after
  // P. Bergeron: A general version of Crow's shadow volumes, 1986).
  kRobust,
};

// A light relative to one body, in the coordinates of the body's float frame.
struct LightOnBody {
  LightPoint light;
  // The light relative to each piece, by label, because pieces may be drawn displaced; nullopt for a hidden
  // piece, which casts no shadow. Labels beyond the end use `light`.
  std::vector<std::optional<LightPoint>> pieces;
  friend bool operator==(const LightOnBody&, const LightOnBody&) = default;
};

// An edge of the silhouette and the number of sides of the volume on it.
struct SilhouetteEdge {
  uint32_t edge = 0;  // slot of the caster
  // Never 0. If positive, the volume lies to the left of low -> high as seen from the light, if negative to
  // the right. The magnitude is 1 at the rim of a sheet, 2 at the contour of a closed surface, and any number
  // if more than two triangles meet.
  int multiplicity = 0;
  friend bool operator==(const SilhouetteEdge&, const SilhouetteEdge&) = default;
};

// The shadow volume of one body for one light: a sign for every face and a silhouette, which with the
// caster's positions suffice to draw it. For kRobust it is closed: at every vertex the multiplicities of the
// edges that start there add up to those of the edges that end there. It is independent of the viewpoint.
class ShadowVolume {
 public:
  explicit ShadowVolume(ShadowMethod method = ShadowMethod::kRobust) : method_(method) {}

  ShadowMethod method() const { return method_; }
  const LightOnBody& light() const { return light_; }

  // Computes the volume for a light. O(faces + edges).
  void rebuild(const ShadowCaster& caster, LightOnBody light);
  // Applies a change returned by the caster's update(), for the same light. Precondition: rebuild() was
  // called with this caster. O(size of the change times the number of faces on its edges).
  void follow(const ShadowCaster& caster, const ShadowCaster::Change& change);

  // Returns 1 if the triangle faces the light, -1 if it faces away, 0 if it casts no shadow or the light lies
  // in its plane. Precondition: face < signs().size().
  int8_t sign(uint32_t face) const {
    assert(face < signs_.size());
    return signs_[face];
  }
  std::span<const int8_t> signs() const { return signs_; }

  // Edges of the silhouette in unspecified order.
  std::span<const SilhouetteEdge> silhouette() const { return silhouette_; }

  // Entries recomputed since the last take_touched(): faces whose signs, and indices into silhouette() whose
  // entries may have changed, possibly repeated or beyond its end; or everything.
  struct Touched {
    bool all = true;
    std::vector<uint32_t> faces, places;
  };
  Touched take_touched();

  // Numbers of faces and edges processed since construction.
  struct Effort {
    uint64_t faces = 0, edges = 0;
  };
  const Effort& effort() const { return effort_; }

  // Memory allocated, in bytes.
  size_t bytes() const;

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  int8_t facing(const ShadowCaster& caster, uint32_t face) const;
  int multiplicity(const ShadowCaster& caster, uint32_t edge) const;
  void put(uint32_t edge, int multiplicity);

  ShadowMethod method_;
  LightOnBody light_;
  std::vector<int8_t> signs_;
  std::vector<SilhouetteEdge> silhouette_;
  std::vector<uint32_t> place_;  // by edge: its index in silhouette_, or kNone
  Touched touched_;
  Effort effort_;
};

// Returns the side of the triangle's plane with the light: the sign of (b - a) x (c - a) . (light - a).
int light_side(const std::array<glm::vec3, 3>& triangle, const LightPoint& light);

}  // namespace kerf
