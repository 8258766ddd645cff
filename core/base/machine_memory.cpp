#include "core/base/machine_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace kerf {

namespace {

constexpr uint64_t kNone = std::numeric_limits<uint64_t>::max();

uint64_t physical_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), bytes = ::sysconf(_SC_PAGE_SIZE);
  return pages > 0 && bytes > 0 ? static_cast<uint64_t>(pages) * static_cast<uint64_t>(bytes) : kNone;
}

// The limit in the control group as a container sees it; "max" is no number and means none.
uint64_t limit_in(const char* file) {
  std::ifstream in(file);
  uint64_t bytes = 0;
  return in >> bytes ? bytes : kNone;
}

uint64_t resource_limit() {
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY ? limit.rlim_cur : kNone;
}

}  // namespace

uint64_t machine_memory() {
  return std::min({physical_memory(), limit_in("/sys/fs/cgroup/memory.max"),
                   limit_in("/sys/fs/cgroup/memory/memory.limit_in_bytes"), resource_limit()});
}

}  // namespace kerf
