#include "app/threads.h"

#include <charconv>
#include <cstdlib>
#include <string_view>

namespace kerf {

Result<std::optional<ThreadLimit>> threads_of_environment() {
  constexpr size_t kMost = 1024;
  const char* value = std::getenv("KERF_THREADS");
  if (value == nullptr) return std::optional<ThreadLimit>();
  const std::string_view text = value;
  size_t threads = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), threads);
  if (fault != std::errc() || end != text.data() + text.size() || threads < 1 || threads > kMost)
    return bad_input("the environment variable KERF_THREADS must be a whole number from 1 to 1024");
  return std::optional<ThreadLimit>(ThreadLimit(threads));
}

}  // namespace kerf
