#include "core/base/assert.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace kerf {

bool asserts_are_fatal() {
  const char* wanted = std::getenv("KERF_ASSERTS");
  return wanted != nullptr && std::string_view(wanted) == "fatal";
}

void report_failed_assertion(const char* condition, const char* file, int line) {
  static std::atomic<const char*> said_last = nullptr;
  if (said_last.exchange(condition) != condition)
    std::fprintf(stderr, "kerf: assertion failed: %s (%s:%d); please report it\n", condition, file, line);
  if (asserts_are_fatal()) std::abort();
}

}  // namespace kerf
