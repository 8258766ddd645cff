#include "core/graph/separation.h"

#include <algorithm>
#include <map>

namespace kerf {

namespace {

constexpr uint32_t kNone = 0xffffffffu;

// A search that spreads over faces from one or more seeds.
struct Front {
  std::vector<FaceId> reached;   // all of its faces
  std::vector<FaceId> frontier;  // those from `next` on have neighbours that were not looked at yet
  size_t next = 0;
  double area = 0;  // of `reached`
  uint32_t lowest = kNone;
  bool exhausted() const { return next == frontier.size(); }
};

// All fronts of one body, and the groups of fronts whose seeds hung together before.
class Fronts {
 public:
  // One group a seed: what seeds that hung together have in common, a number below the number of groups.
  Fronts(const Mesh& mesh, std::span<const FaceId> seeds, std::span<const uint32_t> group, size_t groups)
      : mesh_(mesh), fronts_(seeds.size()), same_front_(seeds.size()), group_(group), same_group_(groups) {
    for (uint32_t i = 0; i < seeds.size(); ++i) reach(i, seeds[i]);
  }

  // Grows the fronts in turn until in every group at most one can still grow, and that one is known to be the
  // largest part or not.
  void run() {
    constexpr size_t kFirstTurn = 16;
    // Each turn is twice as long as the one before, so that there are few, and a small part costs no more
    // than a few times its size.
    for (size_t faces = kFirstTurn; grow_all(faces); faces *= 2) {
    }
  }

  // The parts of each group that fell apart, by representative front.
  std::map<uint32_t, std::vector<uint32_t>> parts() {
    std::map<uint32_t, std::vector<uint32_t>> parts;
    for (uint32_t i = 0; i < fronts_.size(); ++i) {
      if (same_front_.find(i) == i) parts[group_of(i)].push_back(i);
    }
    return parts;
  }

  const Front& front(uint32_t i) const { return fronts_[i]; }

 private:
  struct Open {
    uint32_t fronts = 0;
    double largest_closed = 0;
    bool any_closed = false;
  };

  uint32_t group_of(uint32_t front) { return same_group_.find(group_[front]); }

  // Whether any front had to grow.
  bool grow_all(size_t faces) {
    bool grown = false;
    const auto open = open_fronts();
    for (uint32_t i = 0; i < fronts_.size(); ++i) {
      if (same_front_.find(i) != i || fronts_[i].exhausted() || !must_grow(i, open)) continue;
      for (size_t k = 0; k < faces && same_front_.find(i) == i && !fronts_[i].exhausted(); ++k) grow(i);
      grown = true;
    }
    return grown;
  }

  std::map<uint32_t, Open> open_fronts() {
    std::map<uint32_t, Open> open;
    for (uint32_t i = 0; i < fronts_.size(); ++i) {
      if (same_front_.find(i) != i) continue;
      Open& o = open[group_of(i)];
      if (!fronts_[i].exhausted()) {
        ++o.fronts;
      } else {
        o.any_closed = true;
        o.largest_closed = std::max(o.largest_closed, fronts_[i].area);
      }
    }
    return open;
  }

  bool must_grow(uint32_t i, const std::map<uint32_t, Open>& open) {
    const auto found = open.find(group_of(i));
    if (found == open.end()) return false;
    const Open& o = found->second;
    if (o.fronts > 1) return true;
    return o.any_closed && !(fronts_[i].area > o.largest_closed);
  }

  void reach(uint32_t front, FaceId f) {
    const auto [entry, fresh] = front_of_.try_emplace(f.index, front);
    if (!fresh) {
      merge(entry->second, front);
      return;
    }
    Front& own = fronts_[same_front_.find(front)];
    own.reached.push_back(f);
    own.frontier.push_back(f);
    own.area += triangle_area(mesh_.triangle(f));
    own.lowest = std::min(own.lowest, f.index);
  }

  void grow(uint32_t i) {
    const FaceId f = fronts_[i].frontier[fronts_[i].next++];
    neighbours_.clear();
    mesh_.append_nearest_neighbours(f, neighbours_);
    for (const FaceId n : neighbours_) reach(i, n);
  }

  // Two fronts met: one of them takes over the other's faces and group. O(the smaller one).
  void merge(uint32_t a, uint32_t b) {
    a = same_front_.find(a);
    b = same_front_.find(b);
    if (a == b) return;
    same_group_.unite(group_[a], group_[b]);
    same_front_.unite(a, b);
    const uint32_t into = same_front_.find(a);
    Front &to = fronts_[into], &other = fronts_[into == a ? b : a];
    if (to.reached.size() < other.reached.size()) std::swap(to, other);
    to.reached.insert(to.reached.end(), other.reached.begin(), other.reached.end());
    to.frontier.insert(to.frontier.end(), other.frontier.begin() + static_cast<std::ptrdiff_t>(other.next),
                       other.frontier.end());
    to.area += other.area;
    to.lowest = std::min(to.lowest, other.lowest);
    other = Front{};
  }

  const Mesh& mesh_;
  std::vector<Front> fronts_;
  UnionFind same_front_;
  std::span<const uint32_t> group_;  // one a front, as given
  UnionFind same_group_;
  std::unordered_map<uint32_t, uint32_t> front_of_;  // looked up, never walked
  std::vector<FaceId> neighbours_;
};

}  // namespace

uint32_t Separation::place(FaceId f) {
  const auto [entry, fresh] = place_of_.try_emplace(f.index, static_cast<uint32_t>(faces_.size()));
  if (fresh) faces_.push_back(f);
  return entry->second;
}

void Separation::note_removal(const Mesh& mesh, FaceId f) {
  neighbours_.clear();
  mesh.append_nearest_neighbours(f, neighbours_);
  const uint32_t here = place(f);
  for (const FaceId n : neighbours_) ties_.emplace_back(here, place(n));
}

Separation::Result Separation::settle(Body& body) {
  UnionFind together(faces_.size());
  for (const auto& [a, b] : ties_) together.unite(a, b);
  std::vector<FaceId> seeds;
  std::vector<uint32_t> groups;
  for (uint32_t i = 0; i < faces_.size(); ++i) {
    if (!body.mesh.is_live(faces_[i])) continue;
    seeds.push_back(faces_[i]);
    groups.push_back(together.find(i));
  }
  Fronts fronts(body.mesh, seeds, groups, faces_.size());
  fronts.run();

  std::vector<uint32_t> came_off;
  for (const auto& [group, parts] : fronts.parts()) {
    const auto stays = std::max_element(parts.begin(), parts.end(), [&](uint32_t a, uint32_t b) {
      const Front &x = fronts.front(a), &y = fronts.front(b);
      return x.area != y.area ? x.area < y.area : x.lowest > y.lowest;
    });
    for (const uint32_t part : parts) {
      if (part != *stays) came_off.push_back(part);
    }
  }
  std::sort(came_off.begin(), came_off.end(),
            [&](uint32_t a, uint32_t b) { return fronts.front(a).lowest < fronts.front(b).lowest; });

  Result result;
  for (const uint32_t part : came_off) {
    const Front& front = fronts.front(part);
    const uint32_t label = body.pieces.size();
    Piece& old = body.pieces.edit(body.mesh.data(front.reached[0]).piece);
    old.faces -= front.reached.size();
    old.area -= front.area;
    body.pieces.push_back({front.reached.size(), front.area});
    for (const FaceId f : front.reached) body.mesh.edit_data(f).piece = label;
    result.relabelled.insert(result.relabelled.end(), front.reached.begin(), front.reached.end());
    result.new_pieces.push_back(label);
  }
  *this = Separation{};
  return result;
}

uint32_t label_components(const Mesh& mesh, std::vector<uint32_t>& label) {
  label.assign(mesh.face_slots(), kNone);
  uint32_t components = 0;
  std::vector<FaceId> queue, neighbours;
  for (uint32_t seed = 0; seed < mesh.face_slots(); ++seed) {
    if (!mesh.is_live(FaceId(seed)) || label[seed] != kNone) continue;
    label[seed] = components;
    queue.assign(1, FaceId(seed));
    for (size_t i = 0; i < queue.size(); ++i) {
      neighbours.clear();
      mesh.append_nearest_neighbours(queue[i], neighbours);
      for (const FaceId n : neighbours) {
        if (label[n.index] != kNone) continue;
        label[n.index] = components;
        queue.push_back(n);
      }
    }
    ++components;
  }
  return components;
}

}  // namespace kerf
