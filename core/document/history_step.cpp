#include "core/document/history_step.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <unordered_map>

#include "core/base/assert.h"
#include "core/document/command_log.h"
#include "core/document/cut_effects.h"

namespace kerf {

namespace {

struct BegunStep {
  using Kind = HistoryStep::Kind;
  std::optional<Kind> last;

  std::optional<Kind> operator()(const BeginStroke&) const { return Kind::kStroke; }
  std::optional<Kind> operator()(const Recut&) const { return Kind::kRecut; }
  std::optional<Kind> operator()(const Play&) const { return Kind::kTime; }
  std::optional<Kind> operator()(const ImmediateCommand auto&) const { return Kind::kEdit; }
  // Bodies move in steps begun by Play, or in those of strokes (see Document).
  std::optional<Kind> operator()(const AdvanceTime& c) const { return time(c.joins && !c.bodies); }
  std::optional<Kind> operator()(const TimedCommand auto&) const { return time(false); }
  std::optional<Kind> operator()(const MoveBeam&) const { return std::nullopt; }
  std::optional<Kind> operator()(const EndStroke&) const { return std::nullopt; }
  std::optional<Kind> operator()(const StopStroke&) const { return std::nullopt; }
  std::optional<Kind> operator()(const Undo&) const { return std::nullopt; }
  std::optional<Kind> operator()(const Redo&) const { return std::nullopt; }

  std::optional<Kind> time(bool joins_edit) const {
    const bool goes_on = last && (*last != Kind::kEdit || joins_edit);
    return goes_on ? std::nullopt : std::optional(Kind::kTime);
  }
};

void sort_each_once(std::vector<FaceId>& faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

bool lists(const std::vector<BodyId>& ids, BodyId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

Ticks ticks_of_last(const std::vector<Command>& commands) {
  KERF_ASSERT(!commands.empty());
  const auto* advance = std::get_if<AdvanceTime>(&commands.back());
  return advance ? advance->ticks : 0;
}

std::vector<FaceId>::const_iterator at(const std::vector<FaceId>& faces, size_t i) {
  return faces.begin() + static_cast<std::ptrdiff_t>(i);
}

std::optional<double> beam_radius(const Command& first) {
  if (const auto* stroke = std::get_if<BeginStroke>(&first)) return stroke->settings.laser.radius;
  if (const auto* recut = std::get_if<Recut>(&first)) return recut->settings.laser.radius;
  return std::nullopt;
}

bool is_live(const Mesh& mesh, FaceId f) { return f.index < mesh.face_slots() && mesh.is_live(f); }

}  // namespace

HistoryStep::HistoryStep(const Command& first) {
  const std::optional<Kind> kind = history_step_kind(first, std::nullopt);
  KERF_ASSERT(kind);
  kind_ = kind.value_or(Kind::kEdit);
  add(first);
}

void HistoryStep::add(const Command& command) {
  if (const auto* advance = std::get_if<AdvanceTime>(&command)) {
    append_ticks(commands_, *advance);
  } else {
    commands_.push_back(command);
  }
}

void HistoryStep::begin(bool record) {
  if (!waiting()) return;
  state_ = State::kBegun;
  images_ = record ? Images::kHeld : Images::kDiscarded;
}

void HistoryStep::finish() {
  KERF_ASSERT(!waiting());
  state_ = State::kDone;
}

void HistoryStep::reopen() {
  if (done()) state_ = State::kBegun;
}

void HistoryStep::add(World::Change change) {
  if (images_ != Images::kHeld) return;
  totals_.bytes += change.bytes();
  changes_.push_back(std::move(change));
}

void HistoryStep::record(const World& world, const StepResult& part) {
  record(part.delta);
  record_new_pieces(world, part.delta);
  totals_.statistics.add(part.statistics);
}

void HistoryStep::record(const Delta& delta) {
  totals_.removed_faces += delta.removed_faces;
  totals_.removed_area += delta.removed_area;
  totals_.removed_mass += delta.removed_mass;
  if (delta.changes_bodies()) follow_bodies(delta);
  for (const BodyDelta& b : delta.bodies) {
    Touched& touched = touched_[b.body];
    for (const auto* faces : {&b.added, &b.dead})
      touched.corners.insert(touched.corners.end(), faces->begin(), faces->end());
    touched.labels.insert(touched.labels.end(), b.relabelled.begin(), b.relabelled.end());
    keep_cut_faces(b);
  }
}

// Moves records keyed by body id to the ids that the bodies have after this part of the step.
void HistoryStep::follow_bodies(const Delta& delta) {
  const auto follow = [&](auto& by_body) {
    std::remove_reference_t<decltype(by_body)> after;
    for (auto& [id, noted] : by_body) {
      if (!lists(delta.destroyed, id)) after[id_after(delta, id)] = std::move(noted);
    }
    by_body = std::move(after);
  };
  follow(touched_);
  follow(cut_faces_);
  std::map<PieceId, uint32_t> came_off;
  for (const auto& [piece, from] : totals_.came_off) came_off[id_after(delta, piece)] = from;
  totals_.came_off = std::move(came_off);
  std::set<PieceId> specks;
  for (const PieceId& piece : totals_.specks) specks.insert(id_after(delta, piece));
  totals_.specks = std::move(specks);
  Delta bodies = delta;
  bodies.bodies.clear();
  bodies_.append(std::move(bodies));
}

void HistoryStep::keep_cut_faces(const BodyDelta& delta) {
  KERF_ASSERT(totals_.cut_faces_kept <= kMaxCutFaces);
  const size_t count = std::min(delta.removed.size(), kMaxCutFaces - totals_.cut_faces_kept);
  if (count == 0) return;
  std::vector<CutFace>& kept = cut_faces_[delta.body];
  kept.insert(kept.end(), delta.removed.begin(), delta.removed.begin() + static_cast<std::ptrdiff_t>(count));
  totals_.cut_faces_kept += count;
}

void HistoryStep::drop_cut_faces() {
  cut_faces_.clear();
  totals_.cut_faces_kept = 0;
}

// Visits the latest removals first, because the last removal that separates a piece is next to it. Faces
// next to it at that time may have been removed later, with the label of the new piece.
void HistoryStep::record_new_pieces(const World& world, const Delta& delta) {
  constexpr size_t kMaxVisited = 20'000;
  if (const std::optional<double> radius = beam_radius(commands_.front()))
    totals_.specks.merge(new_specks(world, delta, *radius));
  for (const BodyDelta& b : delta.bodies) {
    count_cut_names(world, b, totals_.cut_names);
    const auto cut = cut_faces_.find(b.body);
    if (b.new_pieces.empty() || cut == cut_faces_.end()) continue;
    const Body& body = world.body(b.body);
    const std::vector<CutFace>& faces = cut->second;
    std::set<uint32_t> unknown(b.new_pieces.begin(), b.new_pieces.end());
    std::unordered_map<uint32_t, uint32_t> label_then;  // of faces that were removed later; never iterated
    const size_t end = faces.size() - std::min(faces.size(), kMaxVisited);
    for (size_t i = faces.size(); i-- > end && !unknown.empty();) {
      label_then[faces[i].face.index] = faces[i].piece;
      for (const FaceId n : faces[i].neighbours) {
        const auto later = label_then.find(n.index);
        if (!body.mesh.is_live(n) && later == label_then.end()) continue;
        const uint32_t label = body.mesh.is_live(n) ? body.label(n) : later->second;
        if (label != faces[i].piece && unknown.erase(label) > 0)
          totals_.came_off[{b.body, label}] = faces[i].piece;
      }
    }
  }
}

void HistoryStep::forget() {
  cut_faces_.clear();
  changes_.clear();
  touched_.clear();
  bodies_ = Delta{};
  totals_ = {};
  state_ = State::kWaiting;
  images_ = Images::kNone;
}

void HistoryStep::drop_before_images() {
  if (images_ == Images::kHeld) images_ = Images::kDiscarded;
  changes_.clear();
  totals_.bytes = 0;
}

Delta HistoryStep::undo(World& world) {
  KERF_ASSERT(images_ != Images::kDiscarded);
  for (size_t i = changes_.size(); i-- > 0;) world.exchange(changes_[i]);
  return delta(world, true);
}

Delta HistoryStep::redo(World& world) {
  KERF_ASSERT(images_ == Images::kHeld);
  for (World::Change& change : changes_) world.exchange(change);
  return delta(world, false);
}

Delta HistoryStep::restore(World& world, size_t slots) const {
  KERF_ASSERT(images_ != Images::kDiscarded);
  for (size_t i = changes_.size(); i-- > 0;) world.restore(changes_[i], slots);
  return delta(world, true);
}

std::optional<size_t> HistoryStep::slots_before() const {
  if (changes_.empty()) return std::nullopt;
  return changes_.front().slots_before();
}

// Lists the changes of the step; faces are classified by the present state of the world.
Delta HistoryStep::delta(const World& world, bool back, const SavePoint* since) const {
  Delta all = back ? inverse_body_changes(bodies_) : bodies_;
  all.removed_faces = 0;
  all.removed_area = 0;
  all.removed_mass = 0;
  all.solid = {};
  all.left_open.clear();
  for (const auto& [after, touched] : touched_) {
    const BodyId id = back ? id_before(bodies_, after) : after;
    // A body created in the step is listed as a whole, or no longer exists.
    if (lists(bodies_.created, after) || !world.contains(id)) continue;
    const Mesh& mesh = world.body(id).mesh;
    BodyDelta body;
    body.body = id;
    std::pair<size_t, size_t> before;
    if (since && since->touched_.contains(after)) before = since->touched_.at(after);
    std::vector<FaceId> corners(at(touched.corners, before.first), touched.corners.end());
    std::vector<FaceId> labels(at(touched.labels, before.second), touched.labels.end());
    sort_each_once(corners);
    for (const FaceId f : corners) (is_live(mesh, f) ? body.added : body.dead).push_back(f);
    sort_each_once(labels);
    std::set_difference(labels.begin(), labels.end(), corners.begin(), corners.end(),
                        std::back_inserter(body.relabelled));
    all.bodies.push_back(std::move(body));
  }
  return all;
}

HistoryStep::SavePoint::SavePoint(const HistoryStep& step)
    : commands_(step.commands_.size()),
      ticks_(ticks_of_last(step.commands_)),
      changes_(step.changes_.size()),
      totals_(step.totals_) {
  KERF_ASSERT(!step.waiting());
  for (const auto& [id, touched] : step.touched_)
    touched_[id] = {touched.corners.size(), touched.labels.size()};
  for (const auto& [id, faces] : step.cut_faces_) cut_faces_[id] = faces.size();
}

bool HistoryStep::SavePoint::can_restore(const HistoryStep& step) const {
  return step.images_ == Images::kHeld && !step.waiting() && step.bodies_.empty() &&
         changes_ <= step.changes_.size() && commands_ == step.commands_.size() &&
         ticks_ == ticks_of_last(step.commands_) && totals_.cut_faces_kept <= step.totals_.cut_faces_kept;
}

Delta HistoryStep::SavePoint::restore(HistoryStep& step, World& world) const {
  KERF_ASSERT(can_restore(step));
  for (; step.changes_.size() > changes_; step.changes_.pop_back()) world.exchange(step.changes_.back());
  Delta back = step.delta(world, true, this);
  step.totals_ = totals_;
  std::erase_if(step.touched_, [&](const auto& touched) { return !touched_.contains(touched.first); });
  for (const auto& [id, sizes] : touched_) {
    step.touched_[id].corners.resize(sizes.first);
    step.touched_[id].labels.resize(sizes.second);
  }
  std::erase_if(step.cut_faces_, [&](const auto& faces) { return !cut_faces_.contains(faces.first); });
  for (const auto& [id, size] : cut_faces_) step.cut_faces_[id].resize(size);
  step.state_ = State::kBegun;
  return back;
}

std::optional<HistoryStep::Kind> history_step_kind(const Command& command,
                                                   std::optional<HistoryStep::Kind> last) {
  return std::visit(BegunStep{last}, command);
}

}  // namespace kerf
