#pragma once

#include "core/base/interval.h"
#include "core/walls/chart_region.h"
#include "core/walls/wall_chart.h"

namespace kerf {

// The chart of one curve of the outline in whole numbers: x goes around, y against the depth. The beam is on
// the left of the outline, so that walls whose outside faces the beam are counter-clockwise.
class SideChart {
 public:
  static constexpr int64_t kSize = int64_t{1} << 30;  // the width of the chart; y is less

  // The chart for depths within `depths` (m). Precondition: `chart` outlives this.
  SideChart(const WallChart& chart, uint32_t curve, Interval depths);

  ChartVertex place(double around, double depth) const;
  Vec3 point(const ChartVertex& v) const;

  // By how much x grows along an edge of the rim, which goes the shorter way around the beam.
  static int64_t x_between(const ChartVertex& from, const ChartVertex& to);
  // The vertex in the middle of an edge, the x of whose ends may lie beyond the width.
  static ChartVertex middle(const ChartVertex& from, const ChartVertex& to);

 private:
  // Beams through an apex see straight lines as such where depth is measured by its reciprocal.
  double height(double depth) const { return chart_->parallel() ? -depth : 1 / depth; }
  double depth(double height) const { return chart_->parallel() ? -height : 1 / height; }

  const WallChart* chart_;
  uint32_t curve_;
  double lowest_ = 0, scale_ = 1;  // of heights
};

}  // namespace kerf
