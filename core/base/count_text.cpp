#include "core/base/count_text.h"

namespace kerf {

std::string grouped(size_t number) {
  std::string digits = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<size_t>(at), " ");
  return digits;
}

std::string count_text(size_t count, const std::string& word) {
  return grouped(count) + ' ' + word + (count == 1 ? "" : "s");
}

}  // namespace kerf
