#include "ui/render/view/show_options.h"

#include <algorithm>

#include "ui/render/view/view_switches.h"

namespace kerf {

namespace {

std::string_view trimmed(std::string_view word) {
  const size_t first = word.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return word.substr(first, word.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::string offered_show_names() {
  std::string all;
  for (const ViewSwitch& s : view_switches()) {
    if (s.show[0] != '\0') all += (all.empty() ? "" : ", ") + std::string(s.show);
  }
  return all;
}

ShowOptions default_show() {
  ShowOptions show;
  show.shadows = Shadows::kAll;
  return show;
}

Result<ShowOptions> parse_show_list(std::string_view list) {
  ViewOptions look;
  while (!list.empty()) {
    const size_t comma = std::min(list.find(','), list.size());
    const std::string_view word = trimmed(list.substr(0, comma));
    list.remove_prefix(std::min(comma + 1, list.size()));
    if (word.empty()) continue;
    const std::span<const ViewSwitch> all = view_switches();
    const auto known = std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.show == word; });
    if (known != all.end()) {
      known->set(look, known->states.size() - 1);
      continue;
    }
    return bad_input("--show: '" + std::string(word) +
                     "' is not the name of an overlay; there is: " + offered_show_names());
  }
  return look.show;
}

}  // namespace kerf
