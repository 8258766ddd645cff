#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/mesh/mesh.h"
#include "core/mesh/remesh/flat_sheets_internal.h"
#include "core/mesh/remesh/remeshed.h"

namespace kerf {

// A sum of squared distances from planes, each weighted by an area (M. Garland, P. S. Heckbert, 1997).
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  Vec3 linear{0};
  double constant = 0;
  double weight = 0;  // sum of the areas

  // Returns the quadric of the plane of a triangle, weighted by its area; 0 if it has no area.
  static Quadric of(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 cross = glm::cross(b - a, c - a);
    const double twice = glm::length(cross);
    if (!(twice > 0)) return {};
    const Vec3 n = cross / twice;
    const double d = -glm::dot(n, a), w = 0.5 * twice;
    return {w * n.x * n.x, w * n.x * n.y, w * n.x * n.z,
            w * n.y * n.y, w * n.y * n.z, w * n.z * n.z,
            w * d * n,     w * d * d,     w};
  }

  Quadric& operator+=(const Quadric& q) {
    xx += q.xx, xy += q.xy, xz += q.xz, yy += q.yy, yz += q.yz, zz += q.zz;
    linear += q.linear;
    constant += q.constant;
    weight += q.weight;
    return *this;
  }

  // Returns the sum for a point, at least 0.
  double at(const Vec3& p) const {
    const double x = xx * p.x + xy * p.y + xz * p.z, y = xy * p.x + yy * p.y + yz * p.z,
                 z = xz * p.x + yz * p.y + zz * p.z;
    const double sum = p.x * x + p.y * y + p.z * z + 2 * glm::dot(linear, p) + constant;
    return sum > 0 ? sum : 0;
  }
};

// Tracks some faces of a mesh while its sheets are simplified, by the quarters into which the edge midpoints
// divide each face. A quarter lies on the face nearest to its centre among those that replaced its previous
// face. So it never moves to another sheet, and the cost of a collapse depends only on the quarters around
// the removed vertex.
class FollowedFaces {
 public:
  // A face changed by a collapse: its number and its new shape, in the frame of the sheets.
  struct Changed {
    uint32_t face;
    Triangle corners;
  };

  // Puts each quarter on its own face. `numbers` has the faces of the mesh by their number on the sheets,
  // ascending, and `frame` is that of the sheets. Precondition: the faces are live.
  FollowedFaces(const Mesh& mesh, const FloatFrame& frame, std::span<const FaceId> numbers,
                std::span<const FaceId> faces);

  // Returns true if any quarter lies on the face.
  bool lie_on(uint32_t f) const { return !lying_.empty() && first_on(f) != kNone; }
  // Moves the quarters on `before`, the faces around a removed vertex, to the changed ones among them.
  // Precondition: neither is empty.
  void hand_on(std::span<const uint32_t> before, std::span<const Changed> changed);

  // Returns the places of the quarters, by face; `numbers` as for the constructor. O(faces).
  std::vector<FollowedFace> places(std::span<const FaceId> numbers) const;

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  uint32_t first_on(uint32_t f) const { return lying_[f]; }

  std::vector<FaceId> faces_;
  std::vector<Vec3> middles_;    // of quarter i % 4 of face i / 4
  std::vector<uint32_t> lying_;  // by face number: the first quarter of its list; empty if none is followed
  std::vector<uint32_t> next_;   // by quarter: the next one in the same list
};

// Bounds the distance of the original surface from the current one, at samples: vertices, edge midpoints and
// face centroids. Testing removed vertices only, as OpenMesh's ModHausdorffT does, left points between them
// up to five times as far away.
class SurfaceSamples {
 public:
  // Takes samples of the current surface. O(faces).
  explicit SurfaceSamples(const FlatSurface& surface);

  // Sets the maximum distance of samples, in the frame of the surface.
  void set_most(double most) { most2_ = most * most; }

  // Returns true if the samples on `before`, and a removed vertex, are near enough to the changed faces.
  bool are_near(std::span<const uint32_t> before, const Vec3& removed,
                std::span<const FollowedFaces::Changed> changed) const;
  // Moves the samples on `before`, and a removed vertex as a new sample, to the nearest of the changed faces.
  // Precondition: there are changed faces.
  void hand_on(std::span<const uint32_t> before, const Vec3& removed,
               std::span<const FollowedFaces::Changed> changed);

 private:
  void add(uint32_t face, const Vec3& p);

  double most2_ = 0;
  std::vector<Vec3> points_;
  std::vector<uint32_t> next_;   // by sample: the next one on the same face
  std::vector<uint32_t> first_;  // by face
};

// The faces and the vertices around a vertex.
struct Ring {
  std::vector<FlatSurface::Opposite> sides;
  std::vector<uint32_t> vertices;  // each once
};

// Bounds the stretch of UVs. In the plane of a set of UVs, the faces around an inner vertex of a chart tile
// the same region before and after its collapse. Each current face stores the original faces that it overlaps
// there. As both maps are affine, the stretch at a texture point is given by the singular values of the map
// from the original face to the current one that keeps UVs (P. Sander et al.: Texture mapping progressive
// meshes, 2001); within kMaxUvStretch for all overlapping pairs, it is so at every point of the texture.
// Original faces without area, in space or in the UVs, bound nothing.
class UvStretch {
 public:
  // Both must outlive it.
  UvStretch(const FlatSheets& sheets, const FlatSurface& surface);

  // Returns the UVs of a current face.
  const FaceUvs& uvs(size_t set, uint32_t f) const { return sets_[set].uvs[f]; }

  // Returns true if the vertex of a ring may collapse onto `to`: no changed face mirrors its UVs or exceeds
  // the bound. False if only some faces around it have UVs. Preconditions: `to` is in the ring and shares two
  // faces with the vertex, and no seam ends at the vertex. O(1) without UVs, otherwise linear in the original
  // faces that the ring overlaps.
  bool allows(uint32_t v, uint32_t to, const Ring& ring);
  // Updates the UVs and the overlaps. Preconditions: allows(v, to, ring), and the surface has not collapsed.
  void collapse(uint32_t v, uint32_t to, const Ring& ring);

 private:
  struct Set {
    const std::vector<FaceUvs>& original;
    std::vector<FaceUvs> uvs;                     // by face
    std::vector<std::vector<uint32_t>> overlaps;  // by face: original faces
  };

  size_t corner_of(uint32_t f, uint32_t v) const;
  FaceUvs changed(const Set& set, uint32_t f, uint32_t v, const glm::dvec2& to) const;
  glm::dvec2 target(const Set& set, uint32_t to, const Ring& ring) const;
  void collect_overlaps(const Set& set, const Ring& ring);
  bool allows(const Set& set, uint32_t v, uint32_t to, const Ring& ring);
  bool is_within_bound(const Set& set, uint32_t original, const Triangle& corners, const FaceUvs& uvs) const;

  const FlatSheets& sheets_;
  const FlatSurface& surface_;
  std::vector<Set> sets_;
  std::vector<uint32_t> around_;  // scratch: original faces
};

// Decides which vertices may collapse onto which of their neighbours.
class CollapseRules {
 public:
  // Both must outlive the rules.
  CollapseRules(const FlatSheets& sheets, const FlatSurface& surface)
      : sheets_(sheets), surface_(surface), mark_(surface.vertices(), 0) {}

  // Sets the minimum squared cosine of the angle by which a collapse may turn a face; 0 or more.
  void set_min_cosine2(double cosine2) { min_cosine2_ = cosine2; }

  // A vertex with more faces is a hub and does not collapse until its neighbours have: inspecting its ring
  // after each of their collapses would take quadratic time. A collapse onto a hub inspects no other hub.
  static constexpr uint32_t kMaxFaces = 256;

  bool is_hub(uint32_t v) const { return surface_.faces_at(v) > kMaxFaces; }

  // Collects the ring of a vertex, and stores it for allows(). Precondition: the vertex is in use.
  void look_at(uint32_t v, Ring& ring);

  // Returns true if the vertex of the last look_at, which has this ring, may collapse onto `to`: the surface
  // stays a manifold of the same topology (the link condition of T. Dey et al., 1999), no sheets are joined,
  // and no face turns too far or loses its area. Two neighbouring hubs may prevent it, too. Preconditions:
  // `to` is in the ring, and the vertex is neither locked nor a hub.
  bool allows(uint32_t v, uint32_t to, const Ring& ring);

 private:
  bool keeps_topology(uint32_t v, uint32_t to, const Ring& ring);
  bool keeps_topology_of_hub(uint32_t to, const Ring& ring) const;
  bool joins_sheets(uint32_t to, const Ring& ring) const;
  bool turns_too_far(uint32_t v, uint32_t to, const Ring& ring) const;

  const FlatSheets& sheets_;
  const FlatSurface& surface_;
  double min_cosine2_ = 0;
  uint32_t stamp_ = 0;
  std::vector<uint32_t> mark_;                   // by vertex: the stamp of its latest ring
  uint32_t left_ = kNoIndex, right_ = kNoIndex;  // the two vertices that share a face with both ends
};

// Collapses the vertices of sheets in rounds, each in the order of the quadric error, until a number of faces
// is left or a round finds no more.
class Collapser {
 public:
  struct Limits {
    size_t faces = 0;        // ends the round when reached
    double min_cosine2 = 0;  // of the angle by which one collapse may turn a face, squared
  };

  // `sheets` must outlive the collapser, and so must `progress`, which may be null. Progress is the fraction
  // of the faces to be removed to reach `faces`.
  Collapser(const Mesh& mesh, const FlatSheets& sheets, size_t faces, std::span<const FaceId> followed,
            const Progress* progress);

  const FlatSurface& surface() const { return surface_; }
  size_t left() const { return left_; }  // faces
  double area() const;                   // in the frame of the sheets; O(faces)
  const FaceUvs& uvs(size_t set, uint32_t f) const { return uv_stretch_.uvs(set, f); }
  std::vector<FollowedFace> followed() const { return followed_.places(sheets_.faces); }

  // Limits later collapses: samples that the first call takes of the surface must stay within `most` of the
  // current surface, in the frame of the sheets. nullopt removes the limit.
  void bound_distance(std::optional<double> most);

  // Returns false if stopped.
  bool run_round(const Limits& limits);

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  // The target of a collapse, and its quadric error.
  struct Choice {
    double error = kNever;
    uint32_t to = kNoIndex;
  };
  // A vertex with a lower bound of the error of its best collapse.
  struct Queued {
    double error;
    uint32_t vertex;
    bool operator>(const Queued& o) const {
      return error > o.error || (error == o.error && vertex > o.vertex);
    }
  };

  bool may_go(uint32_t v) const { return surface_.in_use(v) && !sheets_.locked[v] && !rules_.is_hub(v); }
  void sum_quadrics();
  void queue_all();
  void enqueue(uint32_t v, double error);
  double error_of(uint32_t v, uint32_t to) const;
  double least_error(uint32_t v) const;
  Choice best_choice(uint32_t v);
  bool stays_near(uint32_t v, const Choice& choice);
  void find_changed(uint32_t to);
  void hand_on(uint32_t v, uint32_t to);
  void collapse(uint32_t v, uint32_t to);
  bool report_progress();

  const FlatSheets& sheets_;
  FlatSurface surface_;
  CollapseRules rules_;
  UvStretch uv_stretch_;
  std::vector<Quadric> quadrics_;  // by vertex
  std::vector<double> queued_;     // by vertex: its error in the queue
  std::priority_queue<Queued, std::vector<Queued>, std::greater<>> queue_;
  FollowedFaces followed_;
  std::optional<SurfaceSamples> samples_;
  std::optional<double> most2_;  // squared bound of the distance of samples
  size_t begin_, left_, target_;
  const Progress* progress_;
  size_t reported_;  // faces left at the last report
  Ring ring_;        // of the vertex inspected by the rules
  std::vector<uint32_t> changed_vertices_, around_;
  std::vector<FollowedFaces::Changed> changed_;
  std::vector<Choice> choices_;
};

}  // namespace kerf
