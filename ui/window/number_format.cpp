#include "ui/window/number_format.h"

#include <cctype>

namespace kerf {

std::string NumberFormat::unit() const {
  const std::string_view text(text_);
  size_t at = 0;
  while (at < text.size() && text[at] != '%') ++at;
  while (at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) == 0) ++at;
  std::string unit;
  for (++at; at < text.size(); ++at) {
    if (text[at] == ' ' && unit.empty()) continue;
    if (text[at] == '%') ++at;
    unit += text[at];
  }
  while (!unit.empty() && unit.back() == ' ') unit.pop_back();
  return unit;
}

}  // namespace kerf
