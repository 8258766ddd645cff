#pragma once

#include <vector>

#include "core/heat/heat_region.h"

namespace kerf {

// The equations diagonal[i] x[i] - sum over links of seconds * conductance * x[other] = right[i], solved by
// conjugate gradients with a Jacobi preconditioner. They are symmetric; each diagonal includes what its links
// have, so that they are positive definite. An unknown whose diagonal is 0 keeps its value.
struct HeatEquations {
  std::vector<double> diagonal;  // J/K
  std::vector<double> right;     // J
  double seconds = 0;
};

class HeatSolver {
 public:
  // Improves x (K) until the residual over the diagonal is nowhere more than 1e-7 of the largest x, or after
  // 2,000 iterations. O(links) each.
  void solve(const std::vector<HeatRegion::Link>& links, const HeatEquations& equations,
             std::vector<double>& x);

 private:
  struct Norms {
    double dot = 0;      // residual^2 / diagonal
    double worst = 0;    // |residual| / diagonal
    double largest = 0;  // |x|
    void add(double scaled, double residual, double x);
  };
  // Rows have the entries in the order of the links, and so sums have the bits of a walk over these.
  void sort_by_rows(const std::vector<HeatRegion::Link>& links, double seconds, size_t rows);
  // A row of the matrix times x.
  double row_times(size_t row, double diagonal, const std::vector<double>& x) const;
  void begin(const std::vector<HeatRegion::Link>& links, const HeatEquations& equations,
             const std::vector<double>& x);

  Norms norms_;
  std::vector<double> residual_, inverse_, direction_, product_;
  // The entries of the matrix beside the diagonal, negated (J/K), row after row, and where each row ends.
  std::vector<uint32_t> columns_, row_end_;
  std::vector<double> weights_;
};

}  // namespace kerf
