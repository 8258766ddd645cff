#include "core/document/text/hash_text.h"

namespace kerf {

namespace {
constexpr std::string_view kDigits = "0123456789abcdef";
constexpr int kLength = 16;
}  // namespace

std::string hash_text(uint64_t hash) {
  std::string text(kLength, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, hash >>= 4) *digit = kDigits[hash & 15];
  return text;
}

std::optional<uint64_t> parse_hash(std::string_view text) {
  if (text.size() != kLength) return std::nullopt;
  uint64_t hash = 0;
  for (const char c : text) {
    const size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    hash = hash << 4 | digit;
  }
  return hash;
}

}  // namespace kerf
