#include "ui/editor/scalar_map/histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"

namespace kerf {

namespace {

template <typename Visit>
void for_each_value(ScalarLists lists, const Visit& visit) {
  for (const auto& list : lists) {
    for (const float value : *list) {
      if (value != kNoScalar) visit(static_cast<double>(value));
    }
  }
}

void find_extent(ScalarLists lists, Histogram& h) {
  h.least = std::numeric_limits<double>::infinity();
  h.most = -h.least;
  for_each_value(lists, [&](double value) {
    h.least = std::min(h.least, value);
    h.most = std::max(h.most, value);
    ++h.faces;
  });
  if (h.faces == 0) h.least = h.most = 0;
}

}  // namespace

ScalarRange range_between(double low, double high) {
  constexpr double kLeastShare = 1e-4;
  const double apart = std::max(kLeastShare * std::max(std::abs(low), std::abs(high)), 1e-30);
  return {low, std::max(high, low + apart)};
}

double Histogram::quantile(double share) const {
  const double wanted = share * static_cast<double>(faces);
  double below = 0;
  for (size_t i = 0; i < bins.size(); ++i) {
    const auto here = static_cast<double>(bins[i]);
    if (here > 0 && below + here >= wanted) {
      const double at = from + width() * (static_cast<double>(i) + std::max(0.0, wanted - below) / here);
      return std::clamp(at, least, most);
    }
    below += here;
  }
  return most;
}

Histogram histogram_of(ScalarLists lists, size_t bins, bool whole) {
  KERF_ASSERT(bins > 0);
  Histogram h;
  find_extent(lists, h);
  const ScalarRange range = range_between(h.least, h.most);
  h.from = range.low;
  h.to = range.high;
  if (whole && h.most - h.least < static_cast<double>(bins)) {
    h.from = h.least - 0.5;
    h.to = h.most + 0.5;
    bins = static_cast<size_t>(h.most - h.least) + 1;
  }
  h.bins.assign(bins, 0);
  const double per_bin = h.width();
  for_each_value(lists, [&](double value) {
    const auto bin = static_cast<size_t>(std::max(0.0, (value - h.from) / per_bin));
    ++h.bins[std::min(bin, bins - 1)];
  });
  return h;
}

}  // namespace kerf
