#include "core/mesh/files/emit_ranges.h"

#include <algorithm>
#include <array>

#include "core/base/parallel.h"

namespace kerf {

bool emit_ranges(size_t items, const ByteSink& sink,
                 const std::function<void(size_t first, size_t end, std::string& part)>& encode) {
  constexpr size_t kItems = 1 << 13;  // a range
  std::array<std::string, 8> parts;
  const size_t most = parts.size() * kItems;  // at a time
  for (size_t done = 0; done < items; done += most) {
    const size_t now = std::min(most, items - done);
    for_each_range(now, kItems, [&](size_t first, size_t end) {
      std::string& part = parts[first / kItems];
      part.clear();
      encode(done + first, done + end, part);
    });
    for (size_t r = 0; r < range_count(now, kItems); ++r) {
      if (!sink(parts[r])) return false;
    }
  }
  return true;
}

}  // namespace kerf
