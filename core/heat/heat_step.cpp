#include "core/heat/heat_step.h"

#include <algorithm>

namespace kerf {
namespace {

// The share of its heat that a face may lose in one step for the losses to be accurate, and up to which they
// are taken in the middle of the step; from two on, that could be more than it has.
constexpr double kAccurateLoss = 0.1;
constexpr double kGentleLoss = 1;

// Losses of hotter faces are those at this temperature (K), so that they stay finite.
constexpr double kHottestLoss = 1e5;

// Bounds of iterations that end after a few passes in practice.
constexpr int kPasses = 24;
constexpr int kPhasePasses = 12;

}  // namespace

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

// The energy of a node at the ambient, were its phase the same down to there.
double HeatStep::offset(const HeatRegion::Node& node, Phase phase) const {
  if (phase == Phase::kSolid) return 0;
  return node.mass * (enthalpy_of_removal(substance_) - substance_.heat_liquid * changing_rise_);
}

// The loss as a linear function of the rise at the end of the step. A gentle one is that in the middle of the
// step, by the tangent at its beginning; any other is proportional to the rise at the end.
HeatStep::LossLine HeatStep::loss_line(double rise) const {
  const double temperature = kAmbient + std::min(rise, kHottestLoss);
  const double per_kelvin = heat_lost_per_kelvin(substance_, loss_, temperature);
  const double slope = heat_lost_slope(substance_, loss_, temperature);
  if (equations_.seconds * slope > kGentleLoss * heat_per_area_) return {0, per_kelvin};
  return {(per_kelvin - 0.5 * slope) * rise, 0.5 * slope};
}

// Faces beyond the transition do not last and do not make the step shorter.
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

// Gives nodes the phase that the solution asks for; whether any changed. Phases change one at a time, because
// a node that passes the transition within one step is in it in between.
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

// Adds the faces around those that became hot; whether there are any.
bool HeatStep::reach_further() {
  const uint32_t count = region_.size();
  for (uint32_t i = 0; i < count; ++i) {
    if (rises_[i] > kColdRise) region_.surround(i);
  }
  if (region_.size() == count) return false;
  begin_nodes(count);
  return true;
}

// The sums over all nodes balance exactly for the solution times a factor that is 1 but for the tolerance of
// the solver.
void HeatStep::take_energies() {
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
