#include "core/heat/heat_region.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {
namespace {

// How near centroids may count as, relative to the square root of the area and to the edge. This bounds the
// conductances of slivers.
constexpr double kNearestByArea = 0.1;
constexpr double kNearestByEdge = 1e-3;

constexpr uint32_t kNone = 0xffffffffu;  // no node

}  // namespace

HeatRegion::HeatRegion(const Mesh& mesh, const FaceHeat& heat, const Substance& substance, double thickness,
                       Memory& memory)
    : mesh_(mesh),
      heat_(heat),
      mass_per_area_(thickness * substance.density),
      sheet_conductivity_(thickness * substance.conductivity),
      nodes_(memory.nodes),
      links_(memory.links),
      neighbours_(memory.neighbours),
      neighbour_end_(memory.neighbour_end),
      surrounded_(memory.surrounded),
      node_of_(memory.node_of) {
  KERF_ASSERT(nodes_.empty());
  if (node_of_.size() < mesh.face_slots()) node_of_.resize(mesh.face_slots(), kNone);
}

HeatRegion::~HeatRegion() {
  for (const Node& node : nodes_) node_of_[node.face.index] = kNone;
  nodes_.clear();
  links_.clear();
  neighbours_.clear();
  neighbour_end_.clear();
  surrounded_.clear();
}

bool HeatRegion::contains(FaceId f) const { return node_of_[f.index] != kNone; }

void HeatRegion::add(FaceId f) {
  assert(mesh_.is_live(f));
  if (contains(f)) return;
  const uint32_t node = size();
  node_of_[f.index] = node;
  const auto corners = mesh_.corners(f);
  const Triangle t = {mesh_.position(corners[0]), mesh_.position(corners[1]), mesh_.position(corners[2])};
  const double area = triangle_area(t);
  nodes_.push_back({f, (t[0] + t[1] + t[2]) / 3.0, area, area * mass_per_area_, heat_.energy_of(mesh_, f)});
  for (size_t i = 0; i < 3; ++i) {
    const size_t next = (i + 1) % 3;
    sides_.clear();
    mesh_.append_edge_sides(f, corners[i], corners[next], sides_);
    add_edge(node, {t[i], t[next]});
  }
  neighbour_end_.push_back(static_cast<uint32_t>(neighbours_.size()));
}

void HeatRegion::add_edge(uint32_t node, const Edge& edge) {
  if (sides_.empty()) return;
  const FaceId own = nodes_[node].face;
  if (sides_.size() == 1) return join(node, sides_[0].face, edge, 1);
  around_.assign(1, own);
  for (const Mesh::Side& side : sides_) around_.push_back(side.face);
  std::sort(around_.begin(), around_.end());
  around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
  const size_t count = around_.size();
  const size_t at =
      static_cast<size_t>(std::lower_bound(around_.begin(), around_.end(), own) - around_.begin());
  const FaceId next = around_[(at + 1) % count], previous = around_[(at + count - 1) % count];
  if (next == previous) return join(node, next, edge, 1);
  const double share = static_cast<double>(count - 1) / static_cast<double>(count);
  join(node, next, edge, share);
  join(node, previous, edge, share);
}

void HeatRegion::join(uint32_t node, FaceId neighbour, const Edge& edge, double share) {
  if (neighbour == nodes_[node].face) return;
  neighbours_.push_back(neighbour);
  const uint32_t other = node_of_[neighbour.index];
  if (other == kNone) return;
  const double conductance = share * this->conductance(nodes_[node], nodes_[other], edge);
  if (conductance > 0) links_.push_back({other, node, conductance});
}

// A centroid lies at a third of the height over the edge.
double HeatRegion::conductance(const Node& a, const Node& b, const Edge& edge) const {
  const Vec3 along = edge.to - edge.from;
  const double length = glm::length(along);
  if (!(length > 0)) return 0;
  const Vec3 direction = along / length, to_a = a.centroid - edge.from, to_b = b.centroid - edge.from;
  const double along_a = glm::dot(to_a, direction), along_b = glm::dot(to_b, direction);
  const double across = glm::length(to_a - along_a * direction) + glm::length(to_b - along_b * direction);
  const double distance = std::sqrt(across * across + (along_a - along_b) * (along_a - along_b));
  const double nearest =
      std::max(kNearestByArea * std::sqrt(0.5 * (a.area + b.area)), kNearestByEdge * length);
  return sheet_conductivity_ * length / std::max(distance, nearest);
}

void HeatRegion::surround(uint32_t node) {
  surrounded_.resize(nodes_.size(), 0);
  if (surrounded_[node] != 0) return;
  surrounded_[node] = 1;
  for (uint32_t i = node == 0 ? 0 : neighbour_end_[node - 1]; i < neighbour_end_[node]; ++i)
    add(neighbours_[i]);
}

}  // namespace kerf
