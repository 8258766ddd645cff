#include "core/api/change_log.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "core/api/api_internal.h"

namespace kerf {

namespace {

// A log that is not read for long is lost once it is longer than the world that it describes.
constexpr size_t kMinEntries = size_t{1} << 20;

bool lists(const std::vector<BodyId>& ids, BodyId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

void sort_each_once(std::vector<FaceId>& faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

std::vector<uint32_t> live_labels(const Body& body) {
  std::vector<uint32_t> labels;
  for (uint32_t label = 0; label < body.pieces.size(); ++label) {
    if (body.pieces[label].faces > 0) labels.push_back(label);
  }
  return labels;
}

// Returns the flags of all bodies that changed other than by faces. O(n log n) in the listed bodies.
std::map<BodyId, uint32_t> flags_of(const Delta& bodies) {
  std::map<BodyId, uint32_t> flags;
  const std::pair<const std::vector<BodyId>*, uint32_t> lists_and_flags[] = {
      {&bodies.created, KERF_BODY_CREATED},         {&bodies.moved, KERF_BODY_MOVED},
      {&bodies.mass_changed, KERF_BODY_PROPERTIES}, {&bodies.renamed, KERF_BODY_PROPERTIES},
      {&bodies.pinned, KERF_BODY_PROPERTIES},       {&bodies.visibility_changed, KERF_BODY_VISIBILITY}};
  for (const auto& [list, flag] : lists_and_flags) {
    for (const BodyId id : *list) flags[id] |= flag;
  }
  return flags;
}

// Returns the number of complete steps: a stroke that is cut in steps is not complete.
size_t complete_steps(const UndoStack& history) {
  const size_t position = history.position();
  return position > 0 && !history.last().done() ? position - 1 : position;
}

// Returns the piece from which a piece was cut off in the steps from `first` on.
uint32_t origin_of(const UndoStack& history, size_t first, PieceId piece) {
  for (size_t i = history.position(); i-- > first;) {
    const HistoryStep& step = history.step(i);
    const auto& came_off = step.totals().came_off;
    if (const auto found = came_off.find(piece); found != came_off.end()) return found->second;
    piece = id_before(step.body_changes(), piece);
  }
  return KERF_NO_PIECE;
}

// Returns the pieces whose bodies were not removed since, or moved on to such bodies.
std::vector<kerf_detached> lasting(const World& world, const std::vector<Detached>& detached) {
  std::vector<kerf_detached> all;
  std::set<BodyId> left;  // bodies that later entries name as origin
  for (auto d = detached.rbegin(); d != detached.rend(); ++d) {
    if (!world.contains(d->to) && !left.contains(d->to)) continue;
    left.insert(d->from);
    all.push_back({to_api(d->from), to_api(d->to), d->label, d->keeps_slots});
  }
  std::reverse(all.begin(), all.end());
  return all;
}

}  // namespace

void ChangeLog::record(const World& world, const Delta& delta) {
  if (!tracks_ || everything_) return;
  if (delta.replaced) return lose();
  if (delta.changes_bodies()) follow_bodies(delta);
  for (const BodyDelta& b : delta.bodies) {
    Touched& touched = touched_[b.body];
    for (const auto* faces : {&b.added, &b.dead})
      touched.corners.insert(touched.corners.end(), faces->begin(), faces->end());
    touched.labels.insert(touched.labels.end(), b.relabelled.begin(), b.relabelled.end());
    entries_ += b.added.size() + b.dead.size() + b.relabelled.size();
  }
  if (entries_ > kMinEntries && entries_ > 2 * world.face_slots()) lose();
}

// Moves records to the ids that the bodies have after a step.
void ChangeLog::follow_bodies(const Delta& delta) {
  std::map<BodyId, Touched> touched;
  for (auto& [id, own] : touched_) {
    if (!lists(delta.destroyed, id)) touched[id_after(delta, id)] = std::move(own);
  }
  touched_ = std::move(touched);
  std::map<BodyId, std::vector<uint32_t>> live;
  for (auto& [id, own] : live_) {
    if (!lists(delta.destroyed, id)) live[id_after(delta, id)] = std::move(own);
  }
  live_ = std::move(live);
  Delta bodies = delta;
  bodies.bodies.clear();
  bodies_.append(std::move(bodies));
}

void ChangeLog::forget() {
  everything_ = false;
  tracks_ = true;
  entries_ = 0;
  touched_.clear();
  bodies_ = Delta();
  answers_.clear();
  views_.clear();
  detached_.clear();
}

ChangeLog::Answer ChangeLog::answer_for(const World& world, BodyId id, uint32_t flags, Touched touched) {
  Answer answer;
  answer.changes.body = to_api(id);
  answer.changes.flags = flags;
  const Body& body = world.body(id);
  const auto piece = [&](FaceId f) { return body.mesh.data(f).piece; };
  const auto add = [&](FaceId f) {
    answer.added.push_back(f.index);
    answer.added_pieces.push_back(piece(f));
  };
  if ((flags & KERF_BODY_CREATED) != 0) {
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (body.mesh.is_live(FaceId(f))) add(FaceId(f));
    }
    return answer;
  }
  sort_each_once(touched.corners);
  for (const FaceId f : touched.corners) {
    if (body.mesh.is_live(f)) {
      add(f);
    } else {
      answer.removed.push_back(f.index);
    }
  }
  sort_each_once(touched.labels);
  std::vector<FaceId> moved;
  std::set_difference(touched.labels.begin(), touched.labels.end(), touched.corners.begin(),
                      touched.corners.end(), std::back_inserter(moved));
  for (const FaceId f : moved) {
    if (!body.mesh.is_live(f)) continue;
    answer.moved.push_back(f.index);
    answer.moved_pieces.push_back(piece(f));
  }
  return answer;
}

void ChangeLog::find_pieces(const Document& document, BodyId id, Answer& answer) {
  const Body& body = document.world().body(id);
  std::vector<uint32_t> now = live_labels(body);
  std::vector<uint32_t>& before = live_[id];
  // A body has the name of its only piece, if that has one of its own.
  if (!body.piece_names.empty() && now != before && (now.size() == 1 || before.size() == 1))
    answer.changes.flags |= KERF_BODY_PROPERTIES;
  std::vector<uint32_t> created;
  std::set_difference(now.begin(), now.end(), before.begin(), before.end(), std::back_inserter(created));
  std::set_difference(before.begin(), before.end(), now.begin(), now.end(),
                      std::back_inserter(answer.destroyed_pieces));
  for (const uint32_t label : created)
    answer.new_pieces.push_back({label, origin_of(document.history(), position_, {id, label})});
  before = std::move(now);
}

// Sets the pointers to the arrays, which no longer move.
void ChangeLog::Answer::link() {
  changes.added_count = added.size();
  changes.added = added.data();
  changes.added_pieces = added_pieces.data();
  changes.removed_count = removed.size();
  changes.removed = removed.data();
  changes.moved_count = moved.size();
  changes.moved = moved.data();
  changes.moved_pieces = moved_pieces.data();
  changes.new_piece_count = new_pieces.size();
  changes.new_pieces = new_pieces.data();
  changes.destroyed_piece_count = destroyed_pieces.size();
  changes.destroyed_pieces = destroyed_pieces.data();
}

kerf_changes ChangeLog::take(const Document& document) {
  const World& world = document.world();
  kerf_changes changes{};
  changes.everything = everything_;
  if (everything_) {
    live_.clear();
    for (const BodyId id : world.ids()) live_[id] = live_labels(world.body(id));
    forget();
  } else {
    std::map<BodyId, Touched> touched = std::move(touched_);
    const std::map<BodyId, uint32_t> flags = flags_of(bodies_);
    for (const auto& [id, own] : flags) touched[id];
    std::vector<Answer> answers;
    for (const BodyId id : bodies_.destroyed) {
      kerf_body_changes& destroyed = answers.emplace_back().changes;
      destroyed.body = to_api(id);
      destroyed.flags = KERF_BODY_DESTROYED;
    }
    for (auto& [id, own] : touched) {
      if (!world.contains(id)) continue;
      const auto flagged = flags.find(id);
      const uint32_t own_flags = flagged == flags.end() ? 0 : flagged->second;
      if ((own_flags & KERF_BODY_CREATED) != 0) live_.erase(id);
      answers.push_back(answer_for(world, id, own_flags, std::move(own)));
      find_pieces(document, id, answers.back());
    }
    const std::vector<Detached> detached = std::move(bodies_.detached);
    forget();
    answers_ = std::move(answers);
    for (Answer& answer : answers_) {
      answer.link();
      views_.push_back(answer.changes);
    }
    detached_ = lasting(world, detached);
  }
  position_ = complete_steps(document.history());
  changes.body_count = views_.size();
  changes.bodies = views_.data();
  changes.detached_count = detached_.size();
  changes.detached = detached_.data();
  return changes;
}

}  // namespace kerf
