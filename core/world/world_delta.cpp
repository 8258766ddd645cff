#include "core/world/world_delta.h"

#include <algorithm>
#include <iterator>

namespace kerf {

namespace {

// Lists of bodies that changed other than by faces, addition or removal.
constexpr std::array kChanged{&Delta::moved, &Delta::reweighed, &Delta::hid_or_showed, &Delta::renamed,
                              &Delta::pinned};

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
  unite(body.born, later.born);
  take_away(body.born, later.gone);
  unite(body.gone, later.gone);
  take_away(body.gone, later.born);
  unite(body.relabelled, later.relabelled);
  take_away(body.relabelled, body.gone);
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
  std::erase_if(ids, [&](BodyId id) { return has(later.went, id); });
  for (BodyId& id : ids) id = id_after(later, id);
}

void append_ids(std::vector<BodyId>& ids, const std::vector<BodyId>& more, const Delta& later) {
  follow_ids(ids, later);
  for (const BodyId id : more) add_once(ids, id);
}

void append_bodies(std::vector<BodyDelta>& bodies, Delta& later) {
  std::erase_if(bodies, [&](const BodyDelta& b) { return has(later.went, b.body); });
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
    if (d.carries_on && d.from == before) before = d.to;
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
    if (d->carries_on && d->to == after) after = d->from;
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
  if (anew || later.anew) {
    Delta replaced;
    replaced.anew = true;
    replaced.removed_faces = removed_faces;
    replaced.removed_area = removed_area;
    replaced.removed_mass = removed_mass;
    replaced.solid = solid;
    replaced.left_open = std::move(left_open);
    *this = std::move(replaced);
    return;
  }
  for (const BodyId id : later.went) {
    if (!has(came, id)) add_once(went, id_before(*this, id));
  }
  append_ids(came, later.came, later);
  append_bodies(bodies, later);
  for (const auto list : kChanged) append_ids(this->*list, later.*list, later);
  environment |= later.environment;
  for (const Detached& d : later.detached) {
    const bool back = !detached.empty() && detached.back() == Detached{d.to, d.label, d.from, d.carries_on};
    if (back) {
      detached.pop_back();
    } else {
      detached.push_back(d);
    }
  }
  // An added body is read as a whole; its single changes need not be listed.
  const auto is_new = [&](BodyId id) { return has(came, id); };
  std::erase_if(bodies, [&](const BodyDelta& b) { return is_new(b.body); });
  for (const auto list : kChanged) std::erase_if(this->*list, is_new);
}

Delta bodies_taken_back(const Delta& delta) {
  Delta back;
  back.came = delta.went;
  back.went = delta.came;
  for (auto d = delta.detached.rbegin(); d != delta.detached.rend(); ++d)
    back.detached.push_back({d->to, d->label, d->from, d->carries_on});
  for (const auto list : kChanged) {
    for (const BodyId id : delta.*list) (back.*list).push_back(id_before(delta, id));
  }
  back.environment = delta.environment;
  back.anew = delta.anew;
  return back;
}

}  // namespace kerf
