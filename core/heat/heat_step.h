#pragma once

#include <vector>

#include "core/heat/conduct.h"
#include "core/heat/heat_region.h"
#include "core/heat/heat_solver.h"

namespace kerf {

// Up to this much above the ambient a face counts as cold (K).
inline constexpr double kColdRise = 0.5;

// One implicit step of conduction and losses over the nodes of a region; see conduct().
class HeatStep {
 public:
  class Memory;

  // Precondition: no other step uses the memory at the same time.
  HeatStep(HeatRegion& region, const Substance& substance, const HeatLoss& loss, double thickness,
           Memory& memory);

  // Advances the energies by `seconds` (> 0) or, where losses would not be accurate, by less, but at least by
  // `least`. Returns the time by which they were advanced.
  double advance(double seconds, double least);
  // Whether any node is hot.
  bool any_hot() const;

 private:
  // The relation of energy and temperature of a node: below the transition, in it, or beyond.
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
  const double heat_per_area_;  // J/(m^2 K) of the sheet, the lesser of its phases

  HeatEquations& equations_;
  HeatSolver& solver_;
  std::vector<double>& rises_;
  std::vector<double>& inflow_;
  std::vector<double>& after_;
  std::vector<Phase>& phases_;
  std::vector<LossLine>& loss_lines_;
};

// The arrays of a step, which the next one may use again.
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

}  // namespace kerf
