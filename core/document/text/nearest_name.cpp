#include "core/document/text/nearest_name.h"

#include <algorithm>
#include <vector>

namespace kerf {

namespace {

// Maximum number of letters compared, so that the cost of a key of a megabyte is bounded.
constexpr size_t kComparedLetters = 64;

std::string folded(std::string_view name) {
  std::string text(name.substr(0, kComparedLetters));
  for (char& c : text) {
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

size_t distance(const std::string& a, const std::string& b) {
  if (!a.empty() && !b.empty() && a != b && (a.starts_with(b) || b.starts_with(a))) return 1;
  // Row i holds the distances of the first i letters of a; the two rows before it are kept.
  std::vector<size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string> names) {
  const std::string wanted = folded(name);
  const std::string* nearest = nullptr;
  size_t least = 0;
  for (const std::string& candidate : names) {
    const size_t d = distance(wanted, folded(candidate));
    if (nearest != nullptr && d >= least) continue;
    nearest = &candidate;
    least = d;
  }
  return nearest != nullptr ? *nearest : "";
}

std::string nearest_name_hint(std::string_view name, std::span<const std::string> names) {
  if (names.empty()) return "";
  return "; the nearest name is \"" + nearest_name(name, names) + "\"";
}

}  // namespace kerf
