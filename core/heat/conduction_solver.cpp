#include "core/heat/conduction_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/assert.h"

namespace kerf {

namespace {

// Minimum distance of centroids relative to sqrt(area) and to the edge; bounds the conductances of slivers.
constexpr double kNearestByArea = 0.1;
constexpr double kNearestByEdge = 1e-3;

constexpr uint32_t kNone = 0xffffffffu;  // no node, or no face

constexpr double kTolerance = 1e-7;
constexpr int kIterations = 2000;

// Maximum share of its heat that a face may lose in one step: for accurate losses, and for the midpoint rule
// (from two on, that loss could exceed its heat).
constexpr double kAccurateLoss = 0.1;
constexpr double kGentleLoss = 1;

// Temperature at which losses are capped (K), so that they stay finite.
constexpr double kHottestLoss = 1e5;

// Bounds of iterations, which end after a few passes in practice.
constexpr int kPasses = 24;
constexpr int kPhasePasses = 12;

}  // namespace

uint32_t HeatGeometry::index_of(const Mesh& mesh, FaceId f) {
  if (index_of_slot_.size() < mesh.face_slots()) index_of_slot_.resize(mesh.face_slots(), kNone);
  if (index_of_slot_[f.index] != kNone) return index_of_slot_[f.index];
  const auto index = static_cast<uint32_t>(faces_.size());
  index_of_slot_[f.index] = index;
  const auto corners = mesh.corners(f);
  const Triangle t = {mesh.position(corners[0]), mesh.position(corners[1]), mesh.position(corners[2])};
  const auto first = static_cast<uint32_t>(links_.size());
  for (uint32_t i = 0; i < 3; ++i) append_links(mesh, f, i, corners[i], corners[(i + 1) % 3]);
  ids_.push_back(f);
  faces_.push_back(
      {t, (t[0] + t[1] + t[2]) / 3.0, triangle_area(t), first, static_cast<uint32_t>(links_.size())});
  return index;
}

void HeatGeometry::append_links(const Mesh& mesh, FaceId own, uint32_t edge, VertexId from, VertexId to) {
  const auto link = [&](FaceId neighbour, double share) {
    if (neighbour != own) links_.push_back({neighbour, edge, share, -1});
  };
  sides_.clear();
  mesh.append_edge_sides(own, from, to, sides_);
  if (sides_.empty()) return;
  if (sides_.size() == 1) return link(sides_[0].face, 1);
  around_.assign(1, own);
  for (const Mesh::Side& side : sides_) around_.push_back(side.face);
  std::sort(around_.begin(), around_.end());
  around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
  const size_t count = around_.size();
  const size_t at =
      static_cast<size_t>(std::lower_bound(around_.begin(), around_.end(), own) - around_.begin());
  const FaceId next = around_[(at + 1) % count], previous = around_[(at + count - 1) % count];
  if (next == previous) return link(next, 1);
  const double share = static_cast<double>(count - 1) / static_cast<double>(count);
  link(next, share);
  link(previous, share);
}

void HeatGeometry::clear() {
  for (const FaceId f : ids_) index_of_slot_[f.index] = kNone;
  faces_.clear();
  ids_.clear();
  links_.clear();
}

HeatRegion::HeatRegion(const Mesh& mesh, const FaceHeat& heat, const Substance& substance, double thickness,
                       HeatGeometry& geometry, Memory& memory)
    : mesh_(mesh),
      heat_(heat),
      mass_per_area_(thickness * substance.density),
      sheet_conductivity_(thickness * substance.conductivity),
      nodes_(memory.nodes),
      links_(memory.links),
      neighbours_(memory.neighbours),
      neighbour_end_(memory.neighbour_end),
      surrounded_(memory.surrounded),
      node_of_(memory.node_of),
      geometry_(geometry) {
  KERF_ASSERT(nodes_.empty());
  KERF_ASSERT(thickness > 0);
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
  const uint32_t node = size(), index = geometry_.index_of(mesh_, f);
  node_of_[f.index] = node;
  const HeatGeometry::Face& face = geometry_.face(index);
  nodes_.push_back({f, face.centroid, face.area, face.area * mass_per_area_, heat_.energy_of(mesh_, f)});
  for (HeatGeometry::Link& link : geometry_.links(index)) {
    neighbours_.push_back(link.neighbour);
    const uint32_t other = node_of_[link.neighbour.index];
    if (other == kNone) continue;
    if (link.conductance < 0) {
      const Edge edge{face.corners[link.edge], face.corners[(link.edge + 1) % 3]};
      link.conductance = link.share * conductance(nodes_[node], nodes_[other], edge);
    }
    if (link.conductance > 0) links_.push_back({other, node, link.conductance});
  }
  neighbour_end_.push_back(static_cast<uint32_t>(neighbours_.size()));
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
  assert(node < size());
  surrounded_.resize(nodes_.size(), 0);
  if (surrounded_[node] != 0) return;
  surrounded_[node] = 1;
  for (uint32_t i = node == 0 ? 0 : neighbour_end_[node - 1]; i < neighbour_end_[node]; ++i)
    add(neighbours_[i]);
}

// A counting sort by rows. It is stable, so that the entries of a row have the order of the links.
void HeatSolver::sort_by_rows(const std::vector<HeatRegion::Link>& links, double seconds, size_t rows) {
  row_end_.assign(rows + 1, 0);
  for (const HeatRegion::Link& link : links) {
    ++row_end_[link.a + 1];
    ++row_end_[link.b + 1];
  }
  std::partial_sum(row_end_.begin(), row_end_.end(), row_end_.begin());
  columns_.resize(2 * links.size());
  weights_.resize(2 * links.size());
  // Each row end is that of the previous row until its own entries are placed.
  for (const HeatRegion::Link& link : links) {
    const double weight = seconds * link.conductance;
    for (const auto& [row, column] : {std::pair(link.a, link.b), std::pair(link.b, link.a)}) {
      const uint32_t entry = row_end_[row]++;
      columns_[entry] = column;
      weights_[entry] = weight;
    }
  }
}

double HeatSolver::row_times(size_t row, double diagonal, const std::vector<double>& x) const {
  double sum = diagonal * x[row];
  for (uint32_t e = row == 0 ? 0 : row_end_[row - 1]; e < row_end_[row]; ++e)
    sum -= weights_[e] * x[columns_[e]];
  return sum;
}

HeatSolver::Norms HeatSolver::begin(const std::vector<HeatRegion::Link>& links,
                                    const HeatEquations& equations, const std::vector<double>& x) {
  const size_t count = x.size();
  KERF_ASSERT(equations.diagonal.size() == count && equations.right.size() == count);
  sort_by_rows(links, equations.seconds, count);
  residual_.resize(count);
  inverse_.resize(count);
  product_.resize(count);
  direction_.assign(count, 0);
  Norms norms;
  for (size_t i = 0; i < count; ++i) {
    residual_[i] = equations.right[i] - row_times(i, equations.diagonal[i], x);
    inverse_[i] = equations.diagonal[i] > 0 ? 1 / equations.diagonal[i] : 0;
    norms.add(inverse_[i] * residual_[i], residual_[i], x[i]);
  }
  return norms;
}

void HeatSolver::Norms::add(double scaled, double residual, double x) {
  dot += scaled * residual;
  worst = std::max(worst, std::abs(scaled));
  largest = std::max(largest, std::abs(x));
}

void HeatSolver::solve(const std::vector<HeatRegion::Link>& links, const HeatEquations& equations,
                       std::vector<double>& x) {
  Norms norms = begin(links, equations, x);
  const size_t count = x.size();
  double beta = 0;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    if (norms.worst <= kTolerance * norms.largest) return;
    for (size_t i = 0; i < count; ++i) direction_[i] = inverse_[i] * residual_[i] + beta * direction_[i];
    double curvature = 0;
    for (size_t i = 0; i < count; ++i) {
      product_[i] = row_times(i, equations.diagonal[i], direction_);
      curvature += direction_[i] * product_[i];
    }
    if (!(curvature > 0)) return;
    const double before = norms.dot, step = before / curvature;
    // A local sum stays in registers, because the arrays cannot alias it.
    Norms next;
    for (size_t i = 0; i < count; ++i) {
      x[i] += step * direction_[i];
      residual_[i] -= step * product_[i];
      next.add(inverse_[i] * residual_[i], residual_[i], x[i]);
    }
    norms = next;
    beta = norms.dot / before;
  }
}

HeatStep::HeatStep(HeatRegion& region, const Substance& substance, const HeatLoss& loss, double thickness,
                   Memory& memory)
    : region_(region),
      substance_(substance),
      loss_(loss),
      changing_rise_(substance.transition - kAmbient),
      heat_per_area_(thickness * substance.density * std::min(substance.heat_solid, substance.heat_liquid)),
      equations_(memory.equations),
      solver_(memory.solver),
      rises_(memory.rises),
      inflow_(memory.inflow),
      after_(memory.after),
      phases_(memory.phases),
      loss_lines_(memory.loss_lines) {}

double HeatStep::rise_of(const HeatRegion::Node& node) const {
  return temperature_of(substance_, node.joules, node.mass) - kAmbient;
}

HeatStep::Phase HeatStep::phase_of(const HeatRegion::Node& node, double joules) const {
  if (joules <= node.mass * enthalpy_before_transition(substance_)) return Phase::kSolid;
  return joules <= node.mass * enthalpy_of_removal(substance_) ? Phase::kChanging : Phase::kLiquid;
}

double HeatStep::capacity(const HeatRegion::Node& node, Phase phase) const {
  return node.mass * (phase == Phase::kLiquid ? substance_.heat_liquid : substance_.heat_solid);
}

// Returns the energy of a node extrapolated to the ambient in its phase.
double HeatStep::offset(const HeatRegion::Node& node, Phase phase) const {
  if (phase == Phase::kSolid) return 0;
  return node.mass * (enthalpy_of_removal(substance_) - substance_.heat_liquid * changing_rise_);
}

// Returns the loss as a linear function of the rise at the end of the step. A small loss is evaluated in the
// middle of the step, by the tangent at its beginning; a large one is proportional to the rise at the end.
HeatStep::LossLine HeatStep::loss_line(double rise) const {
  const double temperature = kAmbient + std::min(rise, kHottestLoss);
  const double per_kelvin = heat_lost_per_kelvin(substance_, loss_, temperature);
  const double slope = heat_lost_slope(substance_, loss_, temperature);
  if (equations_.seconds * slope > kGentleLoss * heat_per_area_) return {0, per_kelvin};
  return {(per_kelvin - 0.5 * slope) * rise, 0.5 * slope};
}

// Ignores faces beyond the transition, which are short-lived and must not shorten the step.
double HeatStep::accurate_time() const {
  double hottest = 0;
  for (const HeatRegion::Node& node : region_.nodes()) hottest = std::max(hottest, rise_of(node));
  const double temperature = kAmbient + std::min(hottest, changing_rise_);
  return kAccurateLoss * heat_per_area_ / heat_lost_slope(substance_, loss_, temperature);
}

void HeatStep::begin_nodes(size_t first) {
  const auto& nodes = region_.nodes();
  rises_.resize(nodes.size());
  phases_.resize(nodes.size());
  loss_lines_.resize(nodes.size());
  for (size_t i = first; i < nodes.size(); ++i) {
    rises_[i] = rise_of(nodes[i]);
    phases_[i] = phase_of(nodes[i], nodes[i].joules);
    loss_lines_[i] = loss_line(rises_[i]);
  }
}

void HeatStep::assemble() {
  const auto& nodes = region_.nodes();
  const double seconds = equations_.seconds;
  equations_.diagonal.resize(nodes.size());
  equations_.right.resize(nodes.size());
  for (size_t i = 0; i < nodes.size(); ++i) {
    const LossLine& loss = loss_lines_[i];
    equations_.diagonal[i] = capacity(nodes[i], phases_[i]) + seconds * nodes[i].area * loss.slope;
    equations_.right[i] =
        nodes[i].joules - offset(nodes[i], phases_[i]) - seconds * nodes[i].area * loss.constant;
  }
  for (const HeatRegion::Link& link : region_.links()) {
    equations_.diagonal[link.a] += seconds * link.conductance;
    equations_.diagonal[link.b] += seconds * link.conductance;
  }
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (phases_[i] != Phase::kChanging) continue;
    equations_.diagonal[i] = 0;
    rises_[i] = changing_rise_;
  }
}

double HeatStep::advance(double seconds, double least) {
  KERF_ASSERT(seconds > 0 && least >= 0);
  equations_.seconds = std::min(seconds, std::max(least, accurate_time()));
  begin_nodes(0);
  for (int pass = 0; pass < kPasses; ++pass) {
    assemble();
    solver_.solve(region_.links(), equations_, rises_);
    for (double& rise : rises_) rise = std::max(rise, 0.0);
    find_inflow();
    const bool changed = pass < kPhasePasses && correct_phases();
    if (!reach_further() && !changed) break;
  }
  take_energies();
  return equations_.seconds;
}

void HeatStep::find_inflow() {
  inflow_.assign(rises_.size(), 0);
  for (const HeatRegion::Link& link : region_.links()) {
    const double flow = equations_.seconds * link.conductance * (rises_[link.a] - rises_[link.b]);
    inflow_[link.a] -= flow;
    inflow_[link.b] += flow;
  }
}

double HeatStep::lost(size_t node) const {
  const LossLine& loss = loss_lines_[node];
  return equations_.seconds * region_.nodes()[node].area * (loss.constant + loss.slope * rises_[node]);
}

double HeatStep::joules_after(size_t i) const {
  const HeatRegion::Node& node = region_.nodes()[i];
  if (node.mass == 0) return 0;
  if (phases_[i] == Phase::kChanging) return node.joules + inflow_[i] - lost(i);
  return offset(node, phases_[i]) + capacity(node, phases_[i]) * rises_[i];
}

// Updates phases to the solution; returns true if any changed. Phases change one at a time, because a node
// that crosses the transition within one step is in it in between.
bool HeatStep::correct_phases() {
  const auto& nodes = region_.nodes();
  bool changed = false;
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].mass == 0) continue;
    Phase next = phases_[i];
    if (phases_[i] == Phase::kChanging) {
      next = phase_of(nodes[i], joules_after(i));
    } else if ((phases_[i] == Phase::kSolid) == (rises_[i] > changing_rise_)) {
      next = Phase::kChanging;
    }
    changed |= next != phases_[i];
    phases_[i] = next;
  }
  return changed;
}

// Adds the faces around those that became hot; returns true if there are any.
bool HeatStep::reach_further() {
  const uint32_t count = region_.size();
  for (uint32_t i = 0; i < count; ++i) {
    if (rises_[i] > kColdRise) region_.surround(i);
  }
  if (region_.size() == count) return false;
  begin_nodes(count);
  return true;
}

// The sums over all nodes balance for the solution times a factor near 1, within the solver's tolerance.
void HeatStep::take_energies() {
  KERF_ASSERT(!rises_.empty() && rises_.size() == region_.size());
  auto& nodes = region_.nodes();
  const double hottest = kAmbient + *std::max_element(rises_.begin(), rises_.end());
  const double most = enthalpy_at(substance_, hottest) + substance_.latent;
  double available = 0, wanted = 0;
  after_.resize(nodes.size());
  for (size_t i = 0; i < nodes.size(); ++i) {
    const double scale = equations_.seconds * nodes[i].area;
    after_[i] = std::clamp(joules_after(i), 0.0, nodes[i].mass * most);
    available += nodes[i].joules - scale * loss_lines_[i].constant;
    wanted += after_[i] + scale * loss_lines_[i].slope * rises_[i];
  }
  const double factor = wanted > 0 ? std::max(0.0, available / wanted) : 1;
  for (size_t i = 0; i < nodes.size(); ++i) nodes[i].joules = factor * after_[i];
}

bool HeatStep::any_hot() const {
  return std::any_of(region_.nodes().begin(), region_.nodes().end(),
                     [&](const HeatRegion::Node& node) { return rise_of(node) > kColdRise; });
}

}  // namespace kerf
