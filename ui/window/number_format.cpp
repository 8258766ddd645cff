#include "ui/window/number_format.h"

namespace kerf {

std::string format_of_text(std::string_view text) {
  std::string format;
  for (const char c : text) format.append(c == '%' ? 2 : 1, c);
  return format;
}

std::string NumberFormat::with(std::string_view after) const { return text_ + format_of_text(after); }

}  // namespace kerf
