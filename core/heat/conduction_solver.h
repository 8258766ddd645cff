#pragma once

#include <span>
#include <vector>

#include "core/base/assert.h"
#include "core/heat/face_heat.h"

namespace kerf {

// Shapes of the faces of a mesh and conductances between neighbours, computed when they are first needed.
// Valid until the mesh changes; then call clear(). Takes 4 bytes per face slot of the largest mesh, plus some
// 200 bytes per face used.
class HeatGeometry {
 public:
  struct Face {
    Triangle corners;
    Vec3 centroid;
    double area;  // m^2
    uint32_t first_link, link_end;
  };
  // An edge shared with a neighbour, which conducts a fraction `share` over it.
  struct Link {
    FaceId neighbour;
    uint32_t edge;  // begins at this corner
    double share;
    double conductance;  // W/K; negative until HeatRegion computes it
  };

  // Returns the index of a live face. O(1), linear in the degrees of rings.
  uint32_t index_of(const Mesh& mesh, FaceId f);
  const Face& face(uint32_t index) const { return faces_[index]; }
  std::span<Link> links(uint32_t index) {
    return std::span(links_).subspan(faces_[index].first_link,
                                     faces_[index].link_end - faces_[index].first_link);
  }
  double area(const Mesh& mesh, FaceId f) { return faces_[index_of(mesh, f)].area; }
  void clear();

 private:
  void append_links(const Mesh& mesh, FaceId own, uint32_t edge, VertexId from, VertexId to);

  std::vector<Face> faces_;
  std::vector<FaceId> ids_;  // of the faces
  std::vector<Link> links_;
  std::vector<uint32_t> index_of_slot_;
  std::vector<Mesh::Side> sides_;  // working memory
  std::vector<FaceId> around_;     // working memory
};

// The faces of a mesh that conduct heat in a time step, and the conductances between neighbours.
//
// Neighbours conduct k h L / d (k conductivity, h thickness, L common edge, d distance of the centroids with
// both faces unfolded into one plane). Around an edge of n > 2 faces, each face conducts to the next one by
// index, with (n - 1) / n of this conductance, so that the conductance of one face to all others is as if all
// met in the edge.
class HeatRegion {
 public:
  struct Node {
    FaceId face;
    Vec3 centroid;
    double area;    // m^2
    double mass;    // kg
    double joules;  // relative to the ambient
  };
  struct Link {
    uint32_t a, b;       // indices of nodes
    double conductance;  // W/K
  };

  // Arrays of a region, which the next region reuses to avoid allocation: 4 bytes per face slot of the
  // largest mesh, plus the arrays of the largest region.
  class Memory {
    friend class HeatRegion;
    std::vector<Node> nodes;
    std::vector<Link> links;
    std::vector<FaceId> neighbours;       // of all nodes, concatenated
    std::vector<uint32_t> neighbour_end;  // by node: the end of its neighbours
    std::vector<uint8_t> surrounded;      // by node
    std::vector<uint32_t> node_of;        // by slot of a face
  };

  // Creates an empty region. `thickness` in m. Preconditions: no other region uses the memory at the same
  // time, and the geometry is that of the mesh, or cleared; its conductances are for this sheet.
  HeatRegion(const Mesh& mesh, const FaceHeat& heat, const Substance& substance, double thickness,
             HeatGeometry& geometry, Memory& memory);
  ~HeatRegion();
  HeatRegion(const HeatRegion&) = delete;
  HeatRegion& operator=(const HeatRegion&) = delete;

  // Adds a face with its energy in the mesh, and its links to the faces already added; a no-op if it was
  // added before. Precondition: it is live. O(1), linear in the degrees of rings.
  void add(FaceId f);
  // Adds all neighbours of a node; a no-op if that was done before.
  void surround(uint32_t node);
  bool contains(FaceId f) const;

  std::vector<Node>& nodes() { return nodes_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Link>& links() const { return links_; }
  uint32_t size() const { return static_cast<uint32_t>(nodes_.size()); }

 private:
  struct Edge {
    Vec3 from, to;
  };
  double conductance(const Node& a, const Node& b, const Edge& edge) const;

  const Mesh& mesh_;
  FaceHeat heat_;
  double mass_per_area_;
  double sheet_conductivity_;  // k h, W/K

  std::vector<Node>& nodes_;
  std::vector<Link>& links_;
  std::vector<FaceId>& neighbours_;
  std::vector<uint32_t>& neighbour_end_;
  std::vector<uint8_t>& surrounded_;
  std::vector<uint32_t>& node_of_;
  HeatGeometry& geometry_;
};

// The equations diagonal[i] x[i] - sum over links of seconds * conductance * x[other] = right[i], solved by
// conjugate gradients with a Jacobi preconditioner. They are symmetric, and positive definite because each
// diagonal includes the terms of its links. An unknown whose diagonal is 0 keeps its value.
struct HeatEquations {
  std::vector<double> diagonal;  // J/K
  std::vector<double> right;     // J
  double seconds = 0;
};

class HeatSolver {
 public:
  // Iterates x (K) until the residual over the diagonal is at most 1e-7 of the largest x, or 2,000 times.
  // O(links) each.
  void solve(const std::vector<HeatRegion::Link>& links, const HeatEquations& equations,
             std::vector<double>& x);

 private:
  struct Norms {
    double dot = 0;      // residual^2 / diagonal
    double worst = 0;    // |residual| / diagonal
    double largest = 0;  // |x|
    void add(double scaled, double residual, double x);
  };
  // Keeps the order of the links within each row, so that sums over a row equal sums over the links to the
  // bit.
  void sort_by_rows(const std::vector<HeatRegion::Link>& links, double seconds, size_t rows);
  double row_times(size_t row, double diagonal, const std::vector<double>& x) const;
  // Prepares the rows and the residual; returns its norms.
  Norms begin(const std::vector<HeatRegion::Link>& links, const HeatEquations& equations,
              const std::vector<double>& x);

  std::vector<double> residual_, inverse_, direction_, product_;
  // The off-diagonal entries of the matrix, negated (J/K), row after row, and the end of each row.
  std::vector<uint32_t> columns_, row_end_;
  std::vector<double> weights_;
};

// A face whose temperature exceeds the ambient by at most this (K) counts as cold.
inline constexpr double kColdRise = 0.5;

// One implicit step of conduction and losses over the nodes of a region; see conduct().
class HeatStep {
 public:
  class Memory;

  // Precondition: no other step uses the memory at the same time.
  HeatStep(HeatRegion& region, const Substance& substance, const HeatLoss& loss, double thickness,
           Memory& memory);

  // Advances the energies by `seconds` (> 0), or less for accurate losses, but at least `least`. Returns the
  // time advanced.
  double advance(double seconds, double least);
  bool any_hot() const;

 private:
  // The branch of the relation between energy and temperature: below, in or beyond the transition.
  enum class Phase : uint8_t { kSolid, kChanging, kLiquid };
  struct LossLine {
    double constant, slope;  // W/m^2 and W/(m^2 K) of the rise
  };

  double rise_of(const HeatRegion::Node& node) const;
  Phase phase_of(const HeatRegion::Node& node, double joules) const;
  double capacity(const HeatRegion::Node& node, Phase phase) const;
  double offset(const HeatRegion::Node& node, Phase phase) const;
  LossLine loss_line(double rise) const;
  double accurate_time() const;

  void begin_nodes(size_t first);
  void assemble();
  bool correct_phases();
  bool reach_further();
  void find_inflow();
  double lost(size_t node) const;
  double joules_after(size_t node) const;
  void take_energies();

  HeatRegion& region_;
  const Substance substance_;
  const HeatLoss loss_;
  const double changing_rise_;  // K above the ambient, in the transition
  const double heat_per_area_;  // J/(m^2 K) of the sheet, the minimum over its phases

  HeatEquations& equations_;
  HeatSolver& solver_;
  std::vector<double>& rises_;
  std::vector<double>& inflow_;
  std::vector<double>& after_;
  std::vector<Phase>& phases_;
  std::vector<LossLine>& loss_lines_;
};

// Arrays of a step, which the next step reuses.
class HeatStep::Memory {
  friend class HeatStep;
  HeatEquations equations;
  HeatSolver solver;
  std::vector<double> rises;   // K above the ambient, by node
  std::vector<double> inflow;  // J, through the links of each node
  std::vector<double> after;   // J, by node
  std::vector<Phase> phases;
  std::vector<LossLine> loss_lines;
};

// Working memory of conduct(); a tick allocates nothing once it has grown.
struct HeatMemory {
  HeatRegion::Memory region;
  HeatStep::Memory step;
  HeatGeometry geometry;
  bool keeps_geometry = false;  // conduct() does not clear it, see KeptHeatGeometry
};

// While it exists, conduct() reuses the geometry of its first call. Precondition: all calls are for one mesh
// with one sheet, and no face of it changes its shape.
class KeptHeatGeometry {
 public:
  explicit KeptHeatGeometry(HeatMemory& memory) : memory_(memory) {
    KERF_ASSERT(!memory.keeps_geometry);
    memory_.geometry.clear();
    memory_.keeps_geometry = true;
  }
  ~KeptHeatGeometry() { memory_.keeps_geometry = false; }
  KeptHeatGeometry(const KeptHeatGeometry&) = delete;
  KeptHeatGeometry& operator=(const KeptHeatGeometry&) = delete;

 private:
  HeatMemory& memory_;
};

}  // namespace kerf
