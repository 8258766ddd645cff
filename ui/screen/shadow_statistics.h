#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace kerf {

// What the views that inspect shadows found in the last picture; nothing where it is not known yet.
struct ShadowStatistics {
  std::optional<size_t> differing;  // pixels that two methods draw differently
  double traced = 0;                // share of the picture's pixels whose shadow rays are traced, 0 to 1
  std::optional<size_t> wrong;      // pixels whose traced shadow differs from the drawn one; all are traced
  friend bool operator==(const ShadowStatistics&, const ShadowStatistics&) = default;
};

// How far the tracing has come: "tracing 40 %".
std::string tracing_text(const ShadowStatistics& statistics);

}  // namespace kerf
