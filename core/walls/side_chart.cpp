#include "core/walls/side_chart.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

SideChart::SideChart(const WallChart& chart, uint32_t curve, Interval depths)
    : chart_(&chart), curve_(curve) {
  KERF_ASSERT(curve < chart.curves() && depths.low <= depths.high);
  const auto [low, high] = std::minmax({height(depths.low), height(depths.high)});
  lowest_ = low;
  if (high > low) scale_ = static_cast<double>(kSize - 2) / (high - low);
}

ChartVertex SideChart::place(double around, double depth) const {
  const double share = around / chart_->period(curve_);
  return {std::min(static_cast<int64_t>(share * static_cast<double>(kSize)), kSize - 1),
          static_cast<int64_t>((height(depth) - lowest_) * scale_ + 0.5)};
}

Vec3 SideChart::point(const ChartVertex& v) const {
  const double around = static_cast<double>(v.x) / static_cast<double>(kSize) * chart_->period(curve_);
  return chart_->point_at({curve_, around, depth(lowest_ + static_cast<double>(v.y) / scale_)});
}

int64_t SideChart::x_between(const ChartVertex& from, const ChartVertex& to) {
  const int64_t way = to.x - from.x;
  if (way > kSize / 2) return way - kSize;
  return way < -kSize / 2 ? way + kSize : way;
}

ChartVertex SideChart::middle(const ChartVertex& from, const ChartVertex& to) {
  const int64_t x = (from.x + to.x) / 2;
  return {(x % kSize + kSize) % kSize, (from.y + to.y) / 2};
}

}  // namespace kerf
