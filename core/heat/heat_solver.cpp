#include "core/heat/heat_solver.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace kerf {
namespace {

constexpr double kTolerance = 1e-7;
constexpr int kIterations = 2000;

}  // namespace

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
  // Each row end is that of the row before it until its own entries are in place.
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

void HeatSolver::begin(const std::vector<HeatRegion::Link>& links, const HeatEquations& equations,
                       const std::vector<double>& x) {
  const size_t count = x.size();
  sort_by_rows(links, equations.seconds, count);
  residual_.resize(count);
  inverse_.resize(count);
  product_.resize(count);
  direction_.assign(count, 0);
  norms_ = {};
  for (size_t i = 0; i < count; ++i) {
    residual_[i] = equations.right[i] - row_times(i, equations.diagonal[i], x);
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
    for (size_t i = 0; i < count; ++i) direction_[i] = inverse_[i] * residual_[i] + beta * direction_[i];
    double curvature = 0;
    for (size_t i = 0; i < count; ++i) {
      product_[i] = row_times(i, equations.diagonal[i], direction_);
      curvature += direction_[i] * product_[i];
    }
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
