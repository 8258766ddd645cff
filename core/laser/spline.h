#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/laser/drawing.h"

namespace kerf {

// A B-spline curve of the plane, rational if it has weights.
struct Spline {
  int degree = 3;
  std::vector<double> knots;    // ascending, one more than controls plus degree
  std::vector<Vec2> controls;   // m
  std::vector<double> weights;  // > 0, one per control point; empty: all 1
};

// Returns what is wrong with the numbers of a spline; nullopt if it can be evaluated. Degrees are 1 to 10.
std::optional<std::string> spline_fault(const Spline& spline);

// Evaluates the spline by de Boor's algorithm. Preconditions: no fault; t within the knots at the indices
// degree and controls. O(degree^2 + log n).
Vec2 spline_point(const Spline& spline, double t);

// Begins a line with the flattened spline: each span is halved until points at a quarter, a half and three
// quarters are within half the tolerance of the chord. Precondition: no fault.
void add_spline(const Spline& spline, const std::string& layer, DrawingBuilder& builder);

}  // namespace kerf
