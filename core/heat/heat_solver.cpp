#include "core/heat/heat_solver.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr double kTolerance = 1e-7;
constexpr int kIterations = 2000;

void subtract_links(const std::vector<HeatRegion::Link>& links, double seconds, const std::vector<double>& x,
                    std::vector<double>& product) {
  for (const HeatRegion::Link& link : links) {
    const double weight = seconds * link.conductance;
    product[link.a] -= weight * x[link.b];
    product[link.b] -= weight * x[link.a];
  }
}

}  // namespace

void HeatSolver::begin(const std::vector<HeatRegion::Link>& links, const HeatEquations& equations,
                       const std::vector<double>& x) {
  const size_t count = x.size();
  residual_.resize(count);
  inverse_.resize(count);
  product_.resize(count);
  direction_.assign(count, 0);
  for (size_t i = 0; i < count; ++i) product_[i] = equations.diagonal[i] * x[i];
  subtract_links(links, equations.seconds, x, product_);
  norms_ = {};
  for (size_t i = 0; i < count; ++i) {
    residual_[i] = equations.right[i] - product_[i];
    inverse_[i] = equations.diagonal[i] > 0 ? 1 / equations.diagonal[i] : 0;
    norms_.add(inverse_[i] * residual_[i], residual_[i], x[i]);
  }
}

void HeatSolver::Norms::add(double scaled, double residual, double x) {
  dot += scaled * residual;
  worst = std::max(worst, std::abs(scaled));
  largest = std::max(largest, std::abs(x));
}

void HeatSolver::solve(const std::vector<HeatRegion::Link>& links, const HeatEquations& equations,
                       std::vector<double>& x) {
  begin(links, equations, x);
  const size_t count = x.size();
  double beta = 0;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    if (norms_.worst <= kTolerance * norms_.largest) return;
    for (size_t i = 0; i < count; ++i) {
      direction_[i] = inverse_[i] * residual_[i] + beta * direction_[i];
      product_[i] = equations.diagonal[i] * direction_[i];
    }
    subtract_links(links, equations.seconds, direction_, product_);
    double curvature = 0;
    for (size_t i = 0; i < count; ++i) curvature += direction_[i] * product_[i];
    if (!(curvature > 0)) return;
    const Norms before = norms_;
    const double step = before.dot / curvature;
    norms_ = {};
    for (size_t i = 0; i < count; ++i) {
      x[i] += step * direction_[i];
      residual_[i] -= step * product_[i];
      norms_.add(inverse_[i] * residual_[i], residual_[i], x[i]);
    }
    beta = norms_.dot / before.dot;
  }
}

}  // namespace kerf
