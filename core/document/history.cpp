#include "core/document/history.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace kerf {

namespace {

void sort_each_once(std::vector<FaceId>& faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

bool is_live(const Mesh& mesh, FaceId f) { return f.index < mesh.face_slots() && mesh.is_live(f); }

}  // namespace

void HistoryStep::add(World::Change change) {
  bytes_ += change.bytes();
  changes_.push_back(std::move(change));
}

void HistoryStep::touch(const Delta& delta) {
  removed_faces += delta.removed_faces;
  removed_area += delta.removed_area;
  for (const BodyDelta& b : delta.bodies) {
    Touched& touched = touched_[b.body];
    for (const auto* faces : {&b.born, &b.gone})
      touched.corners.insert(touched.corners.end(), faces->begin(), faces->end());
    touched.labels.insert(touched.labels.end(), b.relabelled.begin(), b.relabelled.end());
  }
  if (delta.changes_bodies()) {
    // A command that changes bodies is a step of its own.
    assert(bodies_.empty() && touched_.size() == delta.bodies.size());
    bodies_ = delta;
    bodies_.bodies.clear();
  }
}

void HistoryStep::forget() {
  let_go();
  touched_.clear();
  bodies_ = Delta{};
  removed_faces = 0;
  removed_area = 0;
  begun = done = false;
}

void HistoryStep::let_go() {
  changes_.clear();
  bytes_ = 0;
}

Delta HistoryStep::take_back(World& world) {
  for (size_t i = changes_.size(); i-- > 0;) world.exchange(changes_[i]);
  return delta(world, true);
}

Delta HistoryStep::bring_again(World& world) {
  for (World::Change& change : changes_) world.exchange(change);
  return delta(world, false);
}

Delta HistoryStep::restore(World& world) const {
  for (size_t i = changes_.size(); i-- > 0;) world.restore(changes_[i]);
  return delta(world, true);
}

// The faces are told apart by what the world has become.
Delta HistoryStep::delta(const World& world, bool back) const {
  Delta all = back ? bodies_taken_back(bodies_) : bodies_;
  all.removed_faces = 0;
  all.removed_area = 0;
  for (const auto& [after, touched] : touched_) {
    const BodyId id = back ? id_before(bodies_, after) : after;
    if (!world.contains(id)) continue;
    const Mesh& mesh = world.body(id).mesh;
    BodyDelta body;
    body.body = id;
    std::vector<FaceId> corners = touched.corners, labels = touched.labels;
    sort_each_once(corners);
    for (const FaceId f : corners) (is_live(mesh, f) ? body.born : body.gone).push_back(f);
    sort_each_once(labels);
    std::set_difference(labels.begin(), labels.end(), corners.begin(), corners.end(),
                        std::back_inserter(body.relabelled));
    all.bodies.push_back(std::move(body));
  }
  return all;
}

void History::append(HistoryStep step) {
  steps_.resize(position_);
  steps_.push_back(std::make_unique<HistoryStep>(std::move(step)));
  ++position_;
}

void History::forget_behind(size_t step) {
  for (size_t i = step + 1; i < steps_.size(); ++i) steps_[i]->forget();
}

void History::set_window(size_t bytes) {
  window_ = bytes;
  trim();
}

size_t History::bytes() const {
  size_t bytes = 0;
  for (const auto& step : steps_) bytes += step->bytes();
  return bytes;
}

void History::trim() {
  size_t held = bytes();
  for (size_t i = 0; i < steps_.size() && held > window_; ++i) {
    held -= steps_[i]->bytes();
    steps_[i]->let_go();
  }
}

}  // namespace kerf
