#include "core/world/world_delta.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace kerf {

namespace {

// Lists of bodies that changed other than by faces, addition or removal.
constexpr std::array kChanged{&Delta::moved,   &Delta::mass_changed, &Delta::visibility_changed,
                              &Delta::renamed, &Delta::pinned,       &Delta::joined};

void unite(std::vector<FaceId>& faces, const std::vector<FaceId>& more) {
  std::vector<FaceId> both;
  std::set_union(faces.begin(), faces.end(), more.begin(), more.end(), std::back_inserter(both));
  faces = std::move(both);
}

void take_away(std::vector<FaceId>& faces, const std::vector<FaceId>& these) {
  std::vector<FaceId> rest;
  std::set_difference(faces.begin(), faces.end(), these.begin(), these.end(), std::back_inserter(rest));
  faces = std::move(rest);
}

void append_body(BodyDelta& body, const BodyDelta& later) {
  unite(body.added, later.added);
  take_away(body.added, later.dead);
  unite(body.dead, later.dead);
  take_away(body.dead, later.added);
  unite(body.relabelled, later.relabelled);
  take_away(body.relabelled, body.dead);
  body.new_pieces.insert(body.new_pieces.end(), later.new_pieces.begin(), later.new_pieces.end());
  body.removed.insert(body.removed.end(), later.removed.begin(), later.removed.end());
}

std::set<BodyId> set_of(const std::vector<BodyId>& ids) { return {ids.begin(), ids.end()}; }

// The ids of bodies that a step changed, to those after it or before it.
class ChangedIds {
 public:
  static ChangedIds after(const Delta& delta) {
    ChangedIds all;
    for (auto d = delta.detached.rbegin(); d != delta.detached.rend(); ++d) {
      if (d->keeps_slots) all.ids_[d->from] = all.of(d->to);
    }
    return all;
  }
  static ChangedIds before(const Delta& delta) {
    ChangedIds all;
    for (const Detached& d : delta.detached) {
      if (d.keeps_slots) all.ids_[d.to] = all.of(d.from);
    }
    return all;
  }

  BodyId of(BodyId id) const {
    const auto changed = ids_.find(id);
    return changed == ids_.end() ? id : changed->second;
  }

 private:
  std::map<BodyId, BodyId> ids_;
};

// What the next step does to the ids in a delta.
struct NextStep {
  std::set<BodyId> destroyed;
  ChangedIds ids;

  explicit NextStep(const Delta& later) : destroyed(set_of(later.destroyed)), ids(ChangedIds::after(later)) {}
};

// Appends the ids that the list lacks.
void add_once(std::vector<BodyId>& ids, const std::vector<BodyId>& more) {
  std::set<BodyId> known = set_of(ids);
  for (const BodyId id : more) {
    if (known.insert(id).second) ids.push_back(id);
  }
}

// Converts ids to those after a step, without bodies that it destroyed, and appends those of the step.
void append_ids(std::vector<BodyId>& ids, const std::vector<BodyId>& more, const NextStep& step) {
  std::erase_if(ids, [&](BodyId id) { return step.destroyed.contains(id); });
  for (BodyId& id : ids) id = step.ids.of(id);
  if (!more.empty()) add_once(ids, more);
}

void append_bodies(std::vector<BodyDelta>& bodies, std::vector<BodyDelta>& more, const NextStep& step) {
  std::erase_if(bodies, [&](const BodyDelta& b) { return step.destroyed.contains(b.body); });
  std::map<BodyId, size_t> index;
  for (size_t i = 0; i < bodies.size(); ++i) {
    bodies[i].body = step.ids.of(bodies[i].body);
    index.emplace(bodies[i].body, i);
  }
  for (BodyDelta& b : more) {
    const auto [same, is_new] = index.emplace(b.body, bodies.size());
    if (is_new) {
      bodies.push_back(std::move(b));
    } else {
      append_body(bodies[same->second], b);
    }
  }
}

// Appends the bodies that the next step destroyed, by their ids before the first step.
void append_destroyed(Delta& delta, const Delta& later) {
  if (later.destroyed.empty()) return;
  const std::set<BodyId> created = set_of(delta.created);
  const ChangedIds before = ChangedIds::before(delta);
  std::vector<BodyId> more;
  for (const BodyId id : later.destroyed) {
    if (!created.contains(id)) more.push_back(before.of(id));
  }
  add_once(delta.destroyed, more);
}

}  // namespace

BodyId id_after(const Delta& delta, BodyId before) {
  for (const Detached& d : delta.detached) {
    if (d.keeps_slots && d.from == before) before = d.to;
  }
  return before;
}

PieceId id_after(const Delta& delta, PieceId before) {
  for (const Detached& d : delta.detached) {
    if (before == PieceId{d.from, d.label}) before.body = d.to;
  }
  return before;
}

BodyId id_before(const Delta& delta, BodyId after) {
  for (auto d = delta.detached.rbegin(); d != delta.detached.rend(); ++d) {
    if (d->keeps_slots && d->to == after) after = d->from;
  }
  return after;
}

PieceId id_before(const Delta& delta, PieceId after) {
  for (auto d = delta.detached.rbegin(); d != delta.detached.rend(); ++d) {
    if (after == PieceId{d->to, d->label}) after.body = d->from;
  }
  return after;
}

void Delta::append(Delta later) {
  removed_faces += later.removed_faces;
  removed_area += later.removed_area;
  removed_mass += later.removed_mass;
  solid += later.solid;
  const NextStep step(later);
  for (LeftOpen& open : left_open) open.body = step.ids.of(open.body);
  left_open.insert(left_open.end(), later.left_open.begin(), later.left_open.end());
  if (replaced || later.replaced) {
    Delta whole;
    whole.replaced = true;
    whole.removed_faces = removed_faces;
    whole.removed_area = removed_area;
    whole.removed_mass = removed_mass;
    whole.solid = solid;
    whole.left_open = std::move(left_open);
    *this = std::move(whole);
    return;
  }
  append_destroyed(*this, later);
  append_ids(created, later.created, step);
  append_bodies(bodies, later.bodies, step);
  for (const auto list : kChanged) append_ids(this->*list, later.*list, step);
  environment |= later.environment;
  for (const Detached& d : later.detached) {
    const bool back = !detached.empty() && detached.back() == Detached{d.to, d.label, d.from, d.keeps_slots};
    if (back) {
      detached.pop_back();
    } else {
      detached.push_back(d);
    }
  }
  // An added body is read as a whole; its single changes need not be listed.
  if (created.empty()) return;
  const std::set<BodyId> all_created = set_of(created);
  const auto is_new = [&](BodyId id) { return all_created.contains(id); };
  std::erase_if(bodies, [&](const BodyDelta& b) { return is_new(b.body); });
  for (const auto list : kChanged) std::erase_if(this->*list, is_new);
}

Delta inverse_body_changes(const Delta& delta) {
  Delta back;
  back.created = delta.destroyed;
  back.destroyed = delta.created;
  for (auto d = delta.detached.rbegin(); d != delta.detached.rend(); ++d)
    back.detached.push_back({d->to, d->label, d->from, d->keeps_slots});
  for (const auto list : kChanged) {
    for (const BodyId id : delta.*list) (back.*list).push_back(id_before(delta, id));
  }
  back.environment = delta.environment;
  back.replaced = delta.replaced;
  return back;
}

}  // namespace kerf
