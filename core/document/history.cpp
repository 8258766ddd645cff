#include "core/document/history.h"

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

PieceId piece_after(const Delta& delta, PieceId before) {
  for (const Detached& d : delta.detached) {
    if (d.from == before.body && d.label == before.label) before.body = d.to;
  }
  return before;
}

Ticks ticks_of_last(const std::vector<Command>& commands) {
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
  images_ = record ? Images::kHeld : Images::kLetGo;
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
  sums_.bytes += change.bytes();
  changes_.push_back(std::move(change));
}

void HistoryStep::touch(const Delta& delta) {
  sums_.removed_faces += delta.removed_faces;
  sums_.removed_area += delta.removed_area;
  sums_.removed_mass += delta.removed_mass;
  if (delta.changes_bodies()) follow_bodies(delta);
  for (const BodyDelta& b : delta.bodies) {
    Touched& touched = touched_[b.body];
    for (const auto* faces : {&b.born, &b.gone})
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
      if (!lists(delta.went, id)) after[id_after(delta, id)] = std::move(noted);
    }
    by_body = std::move(after);
  };
  follow(touched_);
  follow(cut_faces_);
  std::map<PieceId, uint32_t> came_off;
  for (const auto& [piece, from] : sums_.came_off) came_off[piece_after(delta, piece)] = from;
  sums_.came_off = std::move(came_off);
  std::set<PieceId> specks;
  for (const PieceId& piece : sums_.specks) specks.insert(piece_after(delta, piece));
  sums_.specks = std::move(specks);
  Delta bodies = delta;
  bodies.bodies.clear();
  bodies_.append(std::move(bodies));
}

void HistoryStep::keep_cut_faces(const BodyDelta& delta) {
  const size_t count = std::min(delta.removed.size(), kMaxCutFaces - sums_.cut_faces_kept);
  if (count == 0) return;
  std::vector<CutFace>& kept = cut_faces_[delta.body];
  kept.insert(kept.end(), delta.removed.begin(), delta.removed.begin() + static_cast<std::ptrdiff_t>(count));
  sums_.cut_faces_kept += count;
}

void HistoryStep::drop_cut_faces() {
  cut_faces_.clear();
  sums_.cut_faces_kept = 0;
}

PieceId HistoryStep::piece_after_step(PieceId before) const { return piece_after(bodies_, before); }

// Visits the latest removals first, because the last removal that separates a piece is next to it. Faces
// next to it at that time may have been removed later, with the label of the new piece.
void HistoryStep::record_new_pieces(const World& world, const Delta& delta) {
  constexpr size_t kMaxLookedAt = 20'000;
  if (const std::optional<double> radius = beam_radius(commands_.front()))
    sums_.specks.merge(new_specks(world, delta, *radius));
  for (const BodyDelta& b : delta.bodies) {
    count_cut_names(world, b, sums_.cut_names);
    const auto cut = cut_faces_.find(b.body);
    if (b.new_pieces.empty() || cut == cut_faces_.end()) continue;
    const Body& body = world.body(b.body);
    const std::vector<CutFace>& faces = cut->second;
    std::set<uint32_t> unknown(b.new_pieces.begin(), b.new_pieces.end());
    std::unordered_map<uint32_t, uint32_t> label_then;  // of faces that were removed later; never iterated
    const size_t end = faces.size() - std::min(faces.size(), kMaxLookedAt);
    for (size_t i = faces.size(); i-- > end && !unknown.empty();) {
      label_then[faces[i].face.index] = faces[i].piece;
      for (const FaceId n : faces[i].neighbours) {
        const auto later = label_then.find(n.index);
        if (!body.mesh.is_live(n) && later == label_then.end()) continue;
        const uint32_t label = body.mesh.is_live(n) ? body.label(n) : later->second;
        if (label != faces[i].piece && unknown.erase(label) > 0)
          sums_.came_off[{b.body, label}] = faces[i].piece;
      }
    }
  }
}

void HistoryStep::forget() {
  cut_faces_.clear();
  changes_.clear();
  touched_.clear();
  bodies_ = Delta{};
  sums_ = {};
  state_ = State::kWaiting;
  images_ = Images::kNone;
}

void HistoryStep::drop_before_images() {
  if (images_ == Images::kHeld) images_ = Images::kLetGo;
  changes_.clear();
  sums_.bytes = 0;
}

Delta HistoryStep::undo(World& world) {
  for (size_t i = changes_.size(); i-- > 0;) world.exchange(changes_[i]);
  return delta(world, true);
}

HistoryStep::Mark HistoryStep::mark() const {
  KERF_ASSERT(!waiting());
  Mark mark;
  mark.commands = commands_.size();
  mark.ticks = ticks_of_last(commands_);
  mark.changes = changes_.size();
  mark.sums = sums_;
  for (const auto& [id, touched] : touched_)
    mark.touched[id] = {touched.corners.size(), touched.labels.size()};
  for (const auto& [id, faces] : cut_faces_) mark.cut_faces[id] = faces.size();
  return mark;
}

bool HistoryStep::can_go_back_to(const Mark& mark) const {
  return images_ == Images::kHeld && !waiting() && bodies_.empty() && mark.changes <= changes_.size() &&
         mark.commands == commands_.size() && mark.ticks == ticks_of_last(commands_) &&
         mark.sums.cut_faces_kept <= sums_.cut_faces_kept;
}

Delta HistoryStep::go_back_to(const Mark& mark, World& world) {
  KERF_ASSERT(can_go_back_to(mark));
  for (; changes_.size() > mark.changes; changes_.pop_back()) world.exchange(changes_.back());
  Delta back = delta(world, true, &mark);
  sums_ = mark.sums;
  std::erase_if(touched_, [&](const auto& touched) { return !mark.touched.contains(touched.first); });
  for (const auto& [id, sizes] : mark.touched) {
    touched_[id].corners.resize(sizes.first);
    touched_[id].labels.resize(sizes.second);
  }
  std::erase_if(cut_faces_, [&](const auto& faces) { return !mark.cut_faces.contains(faces.first); });
  for (const auto& [id, size] : mark.cut_faces) cut_faces_[id].resize(size);
  state_ = State::kBegun;
  return back;
}

Delta HistoryStep::redo(World& world) {
  for (World::Change& change : changes_) world.exchange(change);
  return delta(world, false);
}

Delta HistoryStep::restore(World& world, size_t slots) const {
  for (size_t i = changes_.size(); i-- > 0;) world.restore(changes_[i], slots);
  return delta(world, true);
}

std::optional<size_t> HistoryStep::slots_before() const {
  if (changes_.empty()) return std::nullopt;
  return changes_.front().slots_before();
}

// Lists the changes of the step; faces are classified by the present state of the world.
Delta HistoryStep::delta(const World& world, bool back, const Mark* since) const {
  Delta all = back ? bodies_taken_back(bodies_) : bodies_;
  all.removed_faces = 0;
  all.removed_area = 0;
  all.removed_mass = 0;
  all.solid = {};
  all.left_open.clear();
  for (const auto& [after, touched] : touched_) {
    const BodyId id = back ? id_before(bodies_, after) : after;
    // A body created in the step is listed as a whole, or no longer exists.
    if (lists(bodies_.came, after) || !world.contains(id)) continue;
    const Mesh& mesh = world.body(id).mesh;
    BodyDelta body;
    body.body = id;
    std::pair<size_t, size_t> before;
    if (since && since->touched.contains(after)) before = since->touched.at(after);
    std::vector<FaceId> corners(at(touched.corners, before.first), touched.corners.end());
    std::vector<FaceId> labels(at(touched.labels, before.second), touched.labels.end());
    sort_each_once(corners);
    for (const FaceId f : corners) (is_live(mesh, f) ? body.born : body.gone).push_back(f);
    sort_each_once(labels);
    std::set_difference(labels.begin(), labels.end(), corners.begin(), corners.end(),
                        std::back_inserter(body.relabelled));
    all.bodies.push_back(std::move(body));
  }
  return all;
}

std::optional<HistoryStep::Kind> history_step_kind(const Command& command,
                                                   std::optional<HistoryStep::Kind> last) {
  return std::visit(BegunStep{last}, command);
}

using Kind = HistoryStep::Kind;

void History::append(HistoryStep step) {
  drop_undone();
  steps_.push_back(std::make_unique<HistoryStep>(std::move(step)));
  ++position_;
}

std::vector<std::unique_ptr<HistoryStep>> History::take_undone() {
  const auto first = steps_.begin() + static_cast<std::ptrdiff_t>(position_);
  std::vector<std::unique_ptr<HistoryStep>> undone(std::make_move_iterator(first),
                                                   std::make_move_iterator(steps_.end()));
  drop_undone();
  return undone;
}

void History::put_undone(std::vector<std::unique_ptr<HistoryStep>> steps) {
  drop_undone();
  std::move(steps.begin(), steps.end(), std::back_inserter(steps_));
}

void History::forget_behind(size_t step) {
  for (size_t i = step + 1; i < steps_.size(); ++i) steps_[i]->forget();
}

bool History::cuts(size_t i) const {
  return step(i).kind() == Kind::kStroke || step(i).kind() == Kind::kRecut;
}

size_t History::base_of(size_t i) const {
  while (step(i).kind() == Kind::kRecut) --i;
  return i;
}

std::optional<size_t> History::last_cut() const {
  for (size_t i = position_; i-- > 0;) {
    if (cuts(i)) return i;
  }
  return std::nullopt;
}

const CutSettings& History::settings_of(size_t i) const {
  KERF_ASSERT(cuts(i));
  const Command& first = step(i).commands().front();
  if (step(i).kind() == Kind::kRecut) return std::get<Recut>(first).settings;
  return std::get<BeginStroke>(first).settings;
}

std::vector<Command> History::commands_of(size_t i) const {
  const size_t base = base_of(i);
  std::vector<Command> all = step(base).commands();
  if (i > base) std::get<BeginStroke>(all.front()).settings = settings_of(i);
  for (size_t again = base + 1; again <= i; ++again) {
    const std::vector<Command>& its = step(again).commands();
    all.insert(all.end(), its.begin() + 1, its.end());
  }
  return all;
}

size_t History::strokes() const {
  size_t strokes = 0;
  for (size_t i = 0; i < position_; ++i) strokes += step(i).kind() == Kind::kStroke;
  return strokes;
}

bool History::is_cut_again(size_t i) const { return i + 1 < position_ && step(i + 1).kind() == Kind::kRecut; }

size_t History::removed_faces() const {
  size_t faces = 0;
  for (size_t i = 0; i < position_; ++i) faces += is_cut_again(i) ? 0 : step(i).removed_faces();
  return faces;
}

double History::removed_area() const {
  double area = 0;
  for (size_t i = 0; i < position_; ++i) area += is_cut_again(i) ? 0 : step(i).removed_area();
  return area;
}

double History::removed_mass() const {
  double mass = 0;
  for (size_t i = 0; i < position_; ++i) mass += is_cut_again(i) ? 0 : step(i).removed_mass();
  return mass;
}

bool History::holds_images(size_t first, size_t end) const {
  for (size_t i = first; i < end; ++i) {
    if (step(i).images() == HistoryStep::Images::kLetGo) return false;
  }
  return true;
}

bool History::any_begun(size_t first, size_t end) const {
  for (size_t i = first; i < end; ++i) {
    if (!step(i).waiting()) return true;
  }
  return false;
}

size_t History::slots_before(size_t first, size_t end) const {
  for (size_t i = first; i < end; ++i) {
    if (const auto slots = step(i).slots_before()) return *slots;
  }
  return 0;
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
    steps_[i]->drop_before_images();
  }
  trim_cut_faces();
}

void History::trim_cut_faces() {
  size_t kept = 0;
  for (size_t i = steps_.size(); i-- > 0;) {
    if (kept > kMaxCutFaces) steps_[i]->drop_cut_faces();
    kept += steps_[i]->cut_faces_kept();
  }
}

CutFaces History::last_cut_faces() const {
  const std::optional<size_t> last = last_cut();
  CutFaces faces;
  if (!last) return faces;
  for (const auto& [cut_in, cut] : step(*last).cut_faces()) {
    BodyId id = cut_in;
    for (size_t i = *last + 1; i < position_; ++i) id = step(i).id_after_step(id);
    faces[id] = cut;
  }
  return faces;
}

}  // namespace kerf
