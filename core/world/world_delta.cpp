#include "core/world/world_delta.h"

#include <algorithm>
#include <iterator>

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

bool has(const std::vector<BodyId>& ids, BodyId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

void add_once(std::vector<BodyId>& ids, BodyId id) {
  if (!has(ids, id)) ids.push_back(id);
}

// Converts ids to those after `later`, without bodies that it removed.
void follow_ids(std::vector<BodyId>& ids, const Delta& later) {
  std::erase_if(ids, [&](BodyId id) { return has(later.destroyed, id); });
  for (BodyId& id : ids) id = id_after(later, id);
}

void append_ids(std::vector<BodyId>& ids, const std::vector<BodyId>& more, const Delta& later) {
  follow_ids(ids, later);
  for (const BodyId id : more) add_once(ids, id);
}

void append_bodies(std::vector<BodyDelta>& bodies, Delta& later) {
  std::erase_if(bodies, [&](const BodyDelta& b) { return has(later.destroyed, b.body); });
  for (BodyDelta& b : bodies) b.body = id_after(later, b.body);
  for (BodyDelta& b : later.bodies) {
    const auto same =
        std::find_if(bodies.begin(), bodies.end(), [&](const BodyDelta& a) { return a.body == b.body; });
    if (same == bodies.end()) {
      bodies.push_back(std::move(b));
    } else {
      append_body(*same, b);
    }
  }
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
  for (LeftOpen& open : left_open) open.body = id_after(later, open.body);
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
  for (const BodyId id : later.destroyed) {
    if (!has(created, id)) add_once(destroyed, id_before(*this, id));
  }
  append_ids(created, later.created, later);
  append_bodies(bodies, later);
  for (const auto list : kChanged) append_ids(this->*list, later.*list, later);
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
  const auto is_new = [&](BodyId id) { return has(created, id); };
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
