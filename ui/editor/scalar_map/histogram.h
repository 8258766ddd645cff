#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ui/render/view/scalar_field.h"

namespace kerf {

// How many faces have which value: bin i counts those from `from + i * width()` on, the last one also `to`.
struct Histogram {
  double from = 0, to = 1;     // from < to
  double least = 0, most = 0;  // of all values
  std::vector<size_t> bins;    // at least one
  size_t faces = 0;            // with a value

  double width() const { return (to - from) / static_cast<double>(bins.size()); }
  // The value below which a share of the faces lies, 0 .. 1, to the width of a bin and within the values.
  double quantile(double share) const;
};

// A scale that has the first colour at `low` and the last at `high`; low < high.
struct ScalarRange {
  double low = 0, high = 1;
  friend bool operator==(const ScalarRange&, const ScalarRange&) = default;
};
// The range from `low` to `high`, widened a little where these are not apart for a float.
ScalarRange range_between(double low, double high);

using ScalarLists = std::span<const std::shared_ptr<const FaceScalars>>;

// Of all values of all lists, in `bins` bins over all of them. `whole`: the values are whole numbers; then a
// bin is one of them where there are no more of them than bins. Precondition: bins > 0.
Histogram histogram_of(ScalarLists lists, size_t bins, bool whole);

}  // namespace kerf
