#pragma once

#include <vector>

#include "core/heat/face_heat.h"

namespace kerf {

// The faces of a mesh between which heat flows during a step, and how well each pair of neighbours conducts.
//
// Neighbours conduct k h L / d (k conductivity, h thickness, L common edge, d distance of the centroids when
// one face is turned about the edge into the plane of the other). Around an edge of n > 2 faces each conducts
// to the next by index, with (n - 1) / n of that, so that one face against all others sees what it would if
// they all met in the edge.
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

  // The arrays of a region, which the next one may use again so that no memory is allocated for it: 4 bytes a
  // slot of the largest mesh, and what the largest region took.
  class Memory {
    friend class HeatRegion;
    std::vector<Node> nodes;
    std::vector<Link> links;
    std::vector<FaceId> neighbours;       // of all nodes, one after the other
    std::vector<uint32_t> neighbour_end;  // by node: where its neighbours end
    std::vector<uint8_t> surrounded;      // by node
    std::vector<uint32_t> node_of;        // by slot of a face
  };

  // The region is empty at first. The thickness is in m. Precondition: no other region uses the memory at the
  // same time.
  HeatRegion(const Mesh& mesh, const FaceHeat& heat, const Substance& substance, double thickness,
             Memory& memory);
  ~HeatRegion();
  HeatRegion(const HeatRegion&) = delete;
  HeatRegion& operator=(const HeatRegion&) = delete;

  // Adds a face with the energy that it has in the mesh, and its links to the faces that are there; nothing
  // happens if it is there. Precondition: it is live. Constant time, linear in the degrees of rings.
  void add(FaceId f);
  // Adds all neighbours of a node; nothing happens if that was done before.
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
  void add_edge(uint32_t node, const Edge& edge);
  void join(uint32_t node, FaceId neighbour, const Edge& edge, double share);
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
  std::vector<Mesh::Side> sides_;  // working memory
  std::vector<FaceId> around_;     // working memory
};

}  // namespace kerf
