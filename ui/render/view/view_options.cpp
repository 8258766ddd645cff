#include "ui/render/view/view_options.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "ui/render/view/colours.h"
#include "ui/render/view/view_switches.h"

namespace kerf {

// Cold colours, not to be mistaken for heat; lightness rises while the hue turns.
glm::dvec3 linear_scalar_colour(double t) {
  const auto path = [](double s) {
    return oklab_of(0.27 + 0.66 * s, 0.07 + 0.03 * std::sin(kPi * s), 305 - 197 * s);
  };
  return linear_along(path, t);
}

glm::vec3 scalar_colour(double t) { return glm::vec3(screen_from_linear(linear_scalar_colour(t))); }

namespace {

constexpr float kHitCounts = 5;  // factor of a hit box's size

struct Seen {
  float size = 0;  // of its diagonal, over its distance
  uint32_t box = 0;
};

// The row of the matrix that gives a coordinate; the length of its first three numbers is that of one unit
// of the body.
glm::vec4 row(const glm::mat4& m, int i) { return {m[0][i], m[1][i], m[2][i], m[3][i]}; }

}  // namespace

std::vector<BoxLine> select_boxes(std::span<const BoxLine> boxes, const glm::mat4& clip_from_body,
                                  size_t most) {
  const glm::vec4 x = row(clip_from_body, 0), y = row(clip_from_body, 1), w = row(clip_from_body, 3);
  const float unit_x = glm::length(glm::vec3(x)), unit_y = glm::length(glm::vec3(y)),
              unit_w = glm::length(glm::vec3(w));
  std::vector<Seen> seen;
  seen.reserve(boxes.size());
  for (uint32_t i = 0; i < boxes.size(); ++i) {
    const glm::vec4 middle(0.5f * (boxes[i].low + boxes[i].high), 1);
    const float half = 0.5f * glm::length(boxes[i].high - boxes[i].low);
    const float nearest = glm::dot(w, middle) + half * unit_w;
    if (nearest <= 0 || std::abs(glm::dot(x, middle)) - half * unit_x > nearest ||
        std::abs(glm::dot(y, middle)) - half * unit_y > nearest)
      continue;
    const float counts = boxes[i].style.x > 0 ? kHitCounts : 1;
    seen.push_back({counts * half / std::max(nearest - half * unit_w, half * unit_w), i});
  }
  const auto larger = [](const Seen& a, const Seen& b) {
    return a.size != b.size ? a.size > b.size : a.box < b.box;
  };
  const auto end = seen.begin() + static_cast<std::ptrdiff_t>(std::min(most, seen.size()));
  std::partial_sort(seen.begin(), end, seen.end(), larger);
  std::vector<BoxLine> selected;
  for (auto s = seen.begin(); s != end; ++s) selected.push_back(boxes[s->box]);
  return selected;
}

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
                     "' is not an overlay; valid names: " + offered_show_names());
  }
  return look.show;
}

namespace {

const PieceGroups& groups_of(const World& world, BodyId id, ViewOptions& look) {
  std::shared_ptr<const PieceGroups>& groups = look.groups[id];
  if (!groups) groups = std::make_shared<const PieceGroups>(group_pieces(world.body(id)));
  return *groups;
}

}  // namespace

void spread_pieces(const World& world, double spread, ViewOptions& look) {
  look.groups.clear();
  spread_further(world, spread, look);
}

void spread_further(const World& world, double spread, ViewOptions& look) {
  KERF_ASSERT(spread >= 0);
  for (auto& [id, piece] : look.pieces) piece.offset = Vec3(0);
  if (spread > 0) {
    const World::Bounds bounds = world.bounds();
    const Vec3 middle = 0.5 * (bounds.min + bounds.max);
    for (const BodyId id : world.ids()) {
      const Body& body = world.body(id);
      const PieceGroups& groups = groups_of(world, id, look);
      KERF_ASSERT(groups.middles.size() == body.pieces.size());
      for (uint32_t label = 0; label < body.pieces.size(); ++label) {
        if (body.pieces[label].faces == 0) continue;
        look.pieces[{id, label}].offset = spread * (body.placement.to_world(groups.middles[label]) - middle);
      }
    }
  } else {
    look.groups.clear();
  }
  std::erase_if(look.pieces, [](const auto& entry) { return entry.second == PieceLook(); });
}

}  // namespace kerf
