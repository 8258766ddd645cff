#pragma once

namespace kerf {

// A closed interval of the real line; empty where low > high.
struct Interval {
  double low = 0;
  double high = 0;
};

}  // namespace kerf
