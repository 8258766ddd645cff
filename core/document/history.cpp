#include "core/document/history.h"

#include <algorithm>

namespace kerf {

void HistoryStep::add(World::Change change) {
  bytes_ += change.bytes();
  all_ = all_ || change.bodies_differ();
  changes_.push_back(std::move(change));
}

void HistoryStep::touch(const Delta& delta) {
  removed_faces += delta.removed_faces;
  removed_area += delta.removed_area;
  all_ = all_ || delta.anew;
  for (const BodyDelta& b : delta.bodies) {
    std::vector<FaceId>& touched = touched_[b.body];
    for (const auto* faces : {&b.born, &b.gone, &b.relabelled})
      touched.insert(touched.end(), faces->begin(), faces->end());
  }
}

void HistoryStep::forget() {
  let_go();
  touched_.clear();
  removed_faces = 0;
  removed_area = 0;
  begun = done = all_ = false;
}

void HistoryStep::let_go() {
  changes_.clear();
  bytes_ = 0;
}

Delta HistoryStep::take_back(World& world) {
  for (size_t i = changes_.size(); i-- > 0;) world.exchange(changes_[i]);
  return delta(world);
}

Delta HistoryStep::bring_again(World& world) {
  for (World::Change& change : changes_) world.exchange(change);
  return delta(world);
}

Delta HistoryStep::restore(World& world) const {
  for (size_t i = changes_.size(); i-- > 0;) world.restore(changes_[i]);
  return delta(world);
}

// As the world is now.
Delta HistoryStep::delta(const World& world) const {
  Delta all;
  all.anew = all_;
  for (const auto& [id, touched] : touched_) {
    if (!world.contains(id)) continue;
    const Mesh& mesh = world.body(id).mesh;
    std::vector<FaceId> faces = touched;
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    BodyDelta body;
    body.body = id;
    for (const FaceId f : faces) {
      const bool live = f.index < mesh.face_slots() && mesh.is_live(f);
      (live ? body.born : body.gone).push_back(f);
    }
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
