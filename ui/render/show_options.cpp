#include "ui/render/show_options.h"

#include <algorithm>

namespace kerf {

namespace {

struct Name {
  std::string_view name;
  bool ShowOptions::*flag;
};

constexpr std::array kOffered{
    Name{"aabb", &ShowOptions::aabb},
    Name{"aabb-hit", &ShowOptions::aabb_hit},
    Name{"wire", &ShowOptions::wire},
    Name{"face-numbers", &ShowOptions::face_numbers},
    Name{"pieces", &ShowOptions::pieces},
    Name{"normals", &ShowOptions::normals},
    Name{"shadows", &ShowOptions::shadows},
    Name{"silhouette", &ShowOptions::silhouette},
    Name{"shadow-volumes", &ShowOptions::shadow_volumes},
    Name{"shadow-stencil", &ShowOptions::shadow_stencil},
    Name{"shadow-facing", &ShowOptions::shadow_facing},
    Name{"shadow-compare", &ShowOptions::shadow_compare},
    Name{"shadow-reference", &ShowOptions::shadow_reference},
};

// Names of the interface that this version cannot draw.
constexpr std::array<std::string_view, 2> kLater{"graph", "heat"};

std::string_view trimmed(std::string_view word) {
  const size_t first = word.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return word.substr(first, word.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::string offered_show_names() {
  std::string all;
  for (const Name& n : kOffered) all += (all.empty() ? "" : ", ") + std::string(n.name);
  return all;
}

Result<ShowOptions> parse_show_list(std::string_view list) {
  ShowOptions show;
  while (!list.empty()) {
    const size_t comma = std::min(list.find(','), list.size());
    const std::string_view word = trimmed(list.substr(0, comma));
    list.remove_prefix(std::min(comma + 1, list.size()));
    if (word.empty()) continue;
    const auto* known =
        std::find_if(kOffered.begin(), kOffered.end(), [&](const Name& n) { return n.name == word; });
    if (known != kOffered.end()) {
      show.*(known->flag) = true;
      continue;
    }
    const bool later = std::find(kLater.begin(), kLater.end(), word) != kLater.end();
    return bad_input("--show: '" + std::string(word) +
                     (later ? "' is not offered yet" : "' is not the name of an overlay") +
                     "; there is: " + offered_show_names());
  }
  return show;
}

}  // namespace kerf
