#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

#include "core/base/assert.h"
#include "core/base/tolerances.h"
#include "core/cut/close_rim_internal.h"
#include "core/cut/cut_stages.h"
#include "core/cut/cut_step.h"
#include "core/cut/rim_stages_internal.h"
#include "core/cut/stopwatch.h"
#include "core/joints/joined_parts.h"
#include "core/mesh/mesh.h"

namespace kerf {

SpeckSearch::SpeckSearch(const SweptDistance& distance, std::span<const RimSide> sides)
    : distance_(distance) {
  for (const RimSide& s : sides) at_rim_.insert(at_rim_.end(), {s.from, s.to});
  std::sort(at_rim_.begin(), at_rim_.end());
}

void SpeckSearch::append(RimState& rim, FaceId start, std::vector<FaceId>& specks) const {
  constexpr size_t kMaxFaces = 64;
  std::vector<FaceId> part{start}, neighbours;
  for (size_t i = 0; i < part.size(); ++i) {
    if (part.size() > kMaxFaces || !lies_along(rim, part[i])) return;
    neighbours.clear();
    rim.mesh().append_nearest_neighbours(part[i], neighbours);
    for (const FaceId n : neighbours) {
      if (std::find(part.begin(), part.end(), n) == part.end()) part.push_back(n);
    }
  }
  specks.insert(specks.end(), part.begin(), part.end());
}

bool SpeckSearch::lies_along(RimState& rim, FaceId f) const {
  const double most = kRimNear * rim.radius();
  const auto corners = rim.mesh().corners(f);
  const Triangle t = rim.mesh().triangle(f);
  const auto is_near = [&](const Vec3& p) { return std::abs(distance_(p)) <= most; };
  for (size_t i = 0; i < 3; ++i) {
    if (std::binary_search(at_rim_.begin(), at_rim_.end(), corners[i])) continue;
    const bool is_known = rim.region.is_near(f);  // no further test for distant vertices
    if ((is_known && std::abs(rim.distance(corners[i], f)) > 2 * most) || !is_near(t[i])) return false;
  }
  const Vec3 between[] = {0.5 * (t[0] + t[1]), 0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0]),
                          (t[0] + t[1] + t[2]) / 3.0};
  return std::all_of(std::begin(between), std::end(between), is_near);
}

namespace {

void sort_faces(std::vector<FaceId>& faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

}  // namespace

Task<Done> WallClosing::find_open_faces() {
  constexpr uint32_t kTogether = 4096;
  std::vector<SheetSide> open;
  for (uint32_t edge = 0; edge < mesh().edge_slots(); edge += kTogether) {
    append_sheet_sides_in(mesh(), edge, edge + kTogether, open);
    co_await yield_after(kTogether / 32);
  }
  for (const SheetSide& s : open) open_faces_.push_back(s.side.face);
  sort_faces(open_faces_);
  co_return Done{};
}

// A flipped face may be near more parts of the region than its list holds.
bool WallClosing::is_at_rim(const Mesh::Side& side) {
  const double most = kRimNear * rim_->radius();
  const auto lies_there = [&](VertexId v) {
    if (rim_->region.is_near(side.face) && std::abs(rim_->distance(v, side.face)) <= most) return true;
    return std::abs((*distance_)(mesh().position(v))) <= most;
  };
  return lies_there(side.from) && lies_there(side.to);
}

// Returns true if the faces on an edge of several sheets bound no solids, i.e. do not traverse the edge
// equally often in both directions.
bool WallClosing::is_unmatched(const Mesh::Side& side, SidesOfRings& seen) const {
  if (seen.contains({side.face, side.from})) return false;
  std::vector<Mesh::Side> others;
  mesh().append_edge_sides(side.face, side.from, side.to, others);
  int balance = 1;
  for (const Mesh::Side& s : others) {
    seen.insert({s.face, s.from});
    balance += mesh().position(s.from) == mesh().position(side.from) ? 1 : -1;
  }
  return balance != 0;
}

// Finds the sides along the rim of parts closed before the stroke; reports where others are open.
Task<Done> WallClosing::find_sides() {
  sides_.clear();
  left_open_.clear();
  std::vector<FaceId> elsewhere;
  std::optional<Mesh::Side> open_side, unmatched;
  std::vector<SheetSide> open;
  SidesOfRings seen;
  for (const FaceId f : open_faces_) {
    co_await yield_after(1);
    open.clear();
    append_sheet_sides_of(mesh(), f, open);
    for (const auto& [s, is_shared] : open) {
      if (is_at_rim(s)) {
        sides_.push_back({s.face, s.from, s.to});
      } else if (!is_shared) {
        elsewhere.push_back(s.face);
        if (!open_side) open_side = s;
      } else if (!unmatched && is_unmatched(s, seen)) {
        unmatched = s;
      }
    }
  }
  std::sort(sides_.begin(), sides_.end(), [](const RimSide& a, const RimSide& b) {
    return std::tie(a.face, a.from) < std::tie(b.face, b.from);
  });
  if (sides_.empty()) co_return Done{};
  if (unmatched)
    left_open_.push_back(
        left_open("an edge has three or more faces that bound no solid", mesh().position(unmatched->from))
            .message);
  if (elsewhere.empty()) co_return Done{};
  const std::vector<bool> was_open = co_await parts_around(elsewhere);
  std::erase_if(sides_, [&](const RimSide& s) { return was_open[s.face.index]; });
  const Vec3 there = mesh().position(open_side->from);
  const char* why =
      sides_.empty() ? "the solid was open before the stroke" : "a part was open before the stroke";
  left_open_.push_back(left_open(why, there).message);
  co_return Done{};
}

// Appends the adjacent faces of the same part: those on the face's sheet and, if its sheet ends at an edge
// of several sheets away from the rim, those of the other sheets that end there.
void WallClosing::append_connected(FaceId f, SidesOfRings& seen, std::vector<FaceId>& out) {
  append_sheet_neighbours(mesh(), f, out);
  std::vector<SheetSide> ends, beyond;
  append_sheet_sides_of(mesh(), f, ends);
  for (const auto& [side, is_shared] : ends) {
    if (!is_shared || seen.contains({f, side.from}) || is_at_rim(side)) continue;
    std::vector<Mesh::Side> others;
    mesh().append_edge_sides(f, side.from, side.to, others);
    for (const Mesh::Side& other : others) {
      seen.insert({other.face, other.from});
      beyond.clear();
      append_sheet_sides_of(mesh(), other.face, beyond);
      const bool ends_there = std::ranges::any_of(
          beyond, [&](const SheetSide& s) { return s.side.from == other.from && s.side.to == other.to; });
      if (ends_there) out.push_back(other.face);
    }
  }
}

// Returns the faces of the connected parts that contain the given faces.
Task<std::vector<bool>> WallClosing::parts_around(const std::vector<FaceId>& faces) {
  std::vector<bool> reached(mesh().face_slots());
  SidesOfRings seen;
  std::vector<FaceId> waiting, neighbours;
  const auto reach = [&](FaceId f) {
    if (reached[f.index]) return;
    reached[f.index] = true;
    waiting.push_back(f);
  };
  for (const FaceId f : faces) reach(f);
  while (!waiting.empty()) {
    const FaceId f = waiting.back();
    waiting.pop_back();
    neighbours.clear();
    append_connected(f, seen, neighbours);
    for (const FaceId n : neighbours) reach(n);
    co_await yield_after(1);
  }
  co_return reached;
}

// Returns the index of the connected part of each face, for parts with sides along the rim.
Task<std::vector<uint32_t>> WallClosing::parts_with_sides() {
  std::vector<uint32_t> part(mesh().face_slots(), kNoPart);
  SidesOfRings seen;
  std::vector<FaceId> waiting, neighbours;
  uint32_t parts = 0;
  for (const RimSide& side : sides_) {
    if (part[side.face.index] != kNoPart) continue;
    part[side.face.index] = parts;
    waiting.push_back(side.face);
    while (!waiting.empty()) {
      const FaceId f = waiting.back();
      waiting.pop_back();
      neighbours.clear();
      append_connected(f, seen, neighbours);
      for (const FaceId n : neighbours) {
        if (part[n.index] != kNoPart) continue;
        part[n.index] = parts;
        waiting.push_back(n);
      }
      co_await yield_after(1);
    }
    ++parts;
  }
  co_return part;
}

// Returns true if all sides of a face are open, or two are and the third one lies on the boundary too.
bool WallClosing::is_ear(std::span<const RimSide> of_face) const {
  KERF_ASSERT(!of_face.empty() && of_face.size() <= 3);
  if (of_face.size() != 2) return of_face.size() == 3;
  const auto c = mesh().corners(of_face[0].face);
  const auto is_open = [&](VertexId from) { return of_face[0].from == from || of_face[1].from == from; };
  const size_t k = is_open(c[0]) ? is_open(c[1]) ? 2 : 1 : 0;
  const Vec3 middle = 0.5 * mesh().position(c[k]) + 0.5 * mesh().position(c[(k + 1) % 3]);
  return std::abs((*distance_)(middle)) <= kRimNear * rim_->radius();
}

// Removes ears and specks. An ear is a face with all corners on the rim whose sides are all open, or all but
// one that also lies on the boundary. Without ears the rim is as near to the boundary; with them it would
// fold back on itself. Returns true if any face was removed.
Task<bool> WallClosing::remove_ears() {
  std::vector<FaceId> ears;
  const SpeckSearch specks(*distance_, sides_);
  for (size_t i = 0; i < sides_.size();) {
    const FaceId f = sides_[i].face;
    size_t end = i + 1;
    while (end < sides_.size() && sides_[end].face == f) ++end;
    if (is_ear(std::span(sides_).subspan(i, end - i))) ears.push_back(f);
    specks.append(*rim_, f, ears);
    i = end;
    co_await yield_after(2);
  }
  if (ears.empty()) co_return false;
  sort_faces(ears);
  remove(std::move(ears));
  co_return true;
}

void WallClosing::remove(std::vector<FaceId> faces) {
  for (const FaceId f : faces) mesh().append_nearest_neighbours(f, open_faces_);
  remove_faces(rim_->step, faces);
  rim_->work.removed = true;
  sort_faces(open_faces_);
  std::erase_if(open_faces_, [&](FaceId f) { return !mesh().is_live(f); });
}

const Mesh& WallClosing::mesh() const { return rim_->mesh(); }

bool WallClosing::resume(RimState& rim) {
  rim_ = &rim;
  if (!distance_) distance_.emplace(rim.region, moves_);
  if (!closing_) closing_.emplace(close());
  try {
    return closing_->resume();
  } catch (...) {
    is_adding_ = false;  // nothing resumes a task that failed
    throw;
  }
}

Task<ClosedRim> WallClosing::close() {
  constexpr int kMaxRounds = 8;
  ClosedRim closed;
  co_await find_open_faces();
  co_await find_sides();
  for (int i = 0; i < kMaxRounds && !sides_.empty(); ++i) {
    if (!co_await remove_ears()) break;
    co_await find_sides();
  }
  closed.left_open = std::move(left_open_);
  if (sides_.empty()) co_return closed;
  const WallStroke stroke{moves_,
                          rim_->radius(),
                          rim_->settings.laser.range,
                          std::cref(*distance_),
                          [this](const Vec3& p, const Vec3& direction) { return crossings(p, direction); },
                          [this] { return parts_with_sides(); }};
  const MadeWalls made = co_await make_walls(mesh(), sides_, stroke);
  closed.left_open.insert(closed.left_open.end(), made.left_open.begin(), made.left_open.end());
  std::vector<FaceId> beside;
  for (const WallPatch& patch : made.patches) {
    if (joins_pieces(patch)) {
      closed.left_open.push_back(
          left_open("a wall would join two pieces", mesh().position(patch.rim[0])).message);
      continue;
    }
    co_await yield_after(kPartOfWork);
    const std::vector<FaceId> walls = co_await add(patch);
    closed.walls.insert(closed.walls.end(), walls.begin(), walls.end());
    beside.insert(beside.end(), patch.beside_wall.begin(), patch.beside_wall.end());
  }
  // The wall connects the faces next to it.
  if (!beside.empty()) rim_->step.edit.search_from(beside);
  co_return closed;
}

std::vector<std::pair<FaceId, int>> WallClosing::crossings(const Vec3& p, const Vec3& direction) const {
  const Body& body = rim_->step.body();
  std::vector<RayHit> hits;
  body.tree.crossings(body.mesh, {p, direction}, {0, std::numeric_limits<double>::max()}, hits);
  std::vector<std::pair<FaceId, int>> crossed;
  for (const RayHit& hit : hits) {
    const Triangle t = body.mesh.triangle(hit.face);
    crossed.emplace_back(hit.face, glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), direction) > 0 ? 1 : -1);
  }
  return crossed;
}

// Returns true if one wall would be adjacent to faces of two pieces.
bool WallClosing::joins_pieces(const WallPatch& patch) const {
  KERF_ASSERT(patch.sides.size() == patch.wall_of_side.size());
  for (size_t i = 0; i < patch.sides.size(); ++i) {
    const FaceId beside = patch.beside_wall[patch.wall_of_side[i]];
    if (mesh().data(patch.sides[i].face).piece != mesh().data(beside).piece) return true;
  }
  return false;
}

Task<std::vector<FaceId>> WallClosing::add(const WallPatch& patch) {
  KERF_ASSERT(patch.faces.size() == patch.wall_of_face.size());
  constexpr size_t kTogether = 256;
  std::vector<VertexId> vertices = patch.rim;
  for (const Vec3& p : patch.added) vertices.push_back(rim_->step.edit.add_vertex(p));
  co_await yield_after(vertices.size() / 4);
  FaceAddition addition(std::move(vertices), patch.faces);
  std::vector<FaceId> walls, beside;
  is_adding_ = true;
  while (walls.size() < patch.faces.size()) {
    beside.clear();
    for (size_t i = walls.size(); i < std::min(walls.size() + kTogether, patch.faces.size()); ++i)
      beside.push_back(patch.beside_wall[patch.wall_of_face[i]]);
    const std::vector<FaceId> added = rim_->step.edit.add_walls(addition, beside);
    walls.insert(walls.end(), added.begin(), added.end());
    co_await yield_after(4 * added.size());
  }
  while (!rim_->step.edit.split_fans(addition, kTogether)) co_await yield_after(kTogether / 2);
  for (size_t i = 0; i < patch.sides.size(); ++i) {
    co_await yield_after(1);
    rim_->step.edit.join_parts(patch.sides[i].face, patch.beside_wall[patch.wall_of_side[i]]);
  }
  is_adding_ = false;
  co_return walls;
}

namespace {

using Stage = UnfinishedRim::Stage;

constexpr size_t kAllAtOnce = std::numeric_limits<size_t>::max();  // an unlimited step
// Cost of a part of a stage, in faces of a step; cost of a face found near the boundary.
constexpr size_t kLightPart = 200, kHeavyPart = 2000, kHeaviestPart = 3000, kNearFace = 2;

// Moves that swept the body: those of the stroke, or, if the body has moved, those in its frame.
struct Sweep {
  std::span<const BeamMove> moves;
  bool in_body_frame = false;
};

Sweep sweep_of(BodyId id, std::span<const BeamMove> path, const SweptByBody& swept) {
  const auto own = swept.find(id);
  if (own == swept.end()) return {path, false};
  return {own->second, true};
}

std::vector<BeamMove> moves_in_body(const Placement& placement, const Sweep& sweep) {
  std::vector<BeamMove> moves(sweep.moves.begin(), sweep.moves.end());
  for (BeamMove& m : moves) {
    if (!sweep.in_body_frame) m = {placement.to_body(m.from), placement.to_body(m.to), m.seconds};
  }
  return moves;
}

void add_to_region(RimState& rim, const BeamMove& move, bool in_body_frame) {
  sweep(rim.step, rim.settings.laser, move, in_body_frame);
  for (const SweptCylinder& part : rim.step.beam) rim.region.add(part);
}

// Finds the faces that meet the boundary of part `i` or could have a vertex on it. Returns their number.
size_t find_near(RimState& rim, uint32_t i) {
  std::vector<FaceId> found;
  const SweptCylinder& part = rim.region.part(i);
  const QueryCounts counts = rim.step.edit.touched(part.with_radius(part.radius() * (1 + 2 * kRimOn)), found);
  rim.step.statistics.tested.boxes += counts.boxes;
  rim.step.statistics.tested.faces += counts.faces;
  std::vector<FaceId>& heap = rim.work.waiting;
  for (const FaceId f : found) {
    if (!rim.region.is_near(f)) {
      heap.push_back(f);
      std::push_heap(heap.begin(), heap.end(), std::greater<>());
    }
    rim.region.record_near(f, i);
  }
  return found.size();
}

// Moves the next faces from the heap to the list. Returns true if the heap is empty.
bool sort_near(RimState& rim) {
  const size_t at_once = 8 * faces_per_batch();
  std::vector<FaceId>& heap = rim.work.waiting;
  for (size_t i = 0; i < at_once && !heap.empty(); ++i) {
    std::pop_heap(heap.begin(), heap.end(), std::greater<>());
    rim.faces.push_back(heap.back());
    heap.pop_back();
  }
  return heap.empty();
}

bool measure(RimState& rim) {
  double& largest = rim.step.statistics.largest_cosine;
  return visit_next(rim, rim.work.changed, [&](FaceId f) {
    if (rim.mesh().is_live(f)) largest = std::max(largest, largest_cosine(rim.mesh().triangle(f)));
  });
}

// One step, which ends after about settings.faces_per_step faces.
class RimBite {
 public:
  RimBite(World& world, const CutSettings& settings, UnfinishedRim& unfinished, const Progress& progress)
      : world_(world), settings_(settings), work_(unfinished), progress_(progress) {}

  // Returns true if the rim is closed in all bodies.
  Result<bool> take(std::span<const BeamMove> path, const SweptByBody& swept, StepResult& result) {
    const std::vector<BodyId> ids = cuttable(world_, settings_);
    while (work_.bodies < ids.size()) {
      const BodyId id = ids[work_.bodies];
      BodyStep step(id, world_.body(id));
      RimState rim(step, settings_, work_);
      const Result<Reached> reached = go_through(rim, sweep_of(id, path, swept));
      if (!reached) return reached.error();
      if (const BodyDelta* changes = take_changes(step, result))
        work_.changed.insert(work_.changed.end(), changes->added.begin(), changes->added.end());
      result.statistics.add(step.statistics);
      if (*reached == Reached::kEndOfBody) {
        const size_t bodies = work_.bodies + 1;
        work_ = UnfinishedRim{};
        work_.bodies = bodies;
      }
      if (taken_ >= settings_.faces_per_step && work_.bodies < ids.size()) {
        result.delta.left_open = std::move(left_open_);
        return false;
      }
    }
    result.delta.left_open = std::move(left_open_);
    apply_joints(world_, result.delta);
    return true;
  }

 private:
  enum class Reached { kEndOfBite, kEndOfEdits, kEndOfBody };

  Result<Reached> go_through(RimState& rim, const Sweep& sweep) {
    do {
      if (!work_.is_uninterruptible() && !progress_.report(0)) return cancelled();
      const Stage before = work_.stage;
      const Result<bool> over = close_part(rim, sweep);
      if (!over) return over.error();
      if (*over) return Reached::kEndOfBody;
      follow_with_tree(rim);
      if (work_.stage == Stage::kMeasure && before != Stage::kMeasure) return Reached::kEndOfEdits;
    } while (taken_ < settings_.faces_per_step);
    return Reached::kEndOfBite;
  }

  void follow_with_tree(RimState& rim) const {
    update_tree(rim.step);
    const Stopwatch watch(rim.step.statistics.update_tree_s);
    rim.step.edit.refit_tree();
  }

  // A stage over a list: the function that executes its next part (returns true at the end), and the
  // following stage.
  struct ListStage {
    Stage stage;
    bool (*do_part)(RimState&);
    Stage next;
  };
  static constexpr std::array kListStages{
      ListStage{Stage::kListInPlane, list_moves_in_plane, Stage::kMoveInPlane},
      ListStage{Stage::kMoveInPlane, move_onto_rim, Stage::kListAlongEdges},
      ListStage{Stage::kListAlongEdges, list_moves_along_edges, Stage::kMoveAlongEdges},
      ListStage{Stage::kMoveAlongEdges, move_onto_rim, Stage::kSplitInTheWay},
      ListStage{Stage::kListNear, list_near_rim, Stage::kSettle},
      ListStage{Stage::kSettle, settle_on_rim, Stage::kClip},
      ListStage{Stage::kClip, clip_at_rim, Stage::kChoose},
      ListStage{Stage::kChoose, select_within_rim, Stage::kRemove},
      ListStage{Stage::kChooseBesideRim, select_beside_rim, Stage::kFlip}};

  // Executes the next part of a stage. Returns true if the body is complete.
  Result<bool> close_part(RimState& rim, const Sweep& sweep) {
    switch (work_.stage) {
      case Stage::kSweep:
      case Stage::kFindNear:
      case Stage::kSort:
        find(rim, sweep);
        return false;
      case Stage::kRemove:
        taken_ += kHeavyPart;
        if (remove_within_rim(rim)) go_to(Stage::kChooseBesideRim);
        return false;
      case Stage::kCloseByWalls:
        if (close(rim, sweep)) go_to(Stage::kHeatWalls);
        return false;
      case Stage::kHeatWalls:
        if (heat(rim)) go_to(Stage::kSeparate);
        return false;
      case Stage::kSeparate:
        separate_pieces(rim.step);
        if (work_.changed.empty() && !rim.step.edit.any()) return true;
        go_to(Stage::kMeasure);
        return false;
      case Stage::kMeasure:
        taken_ += kLightPart;
        return measure(rim);
      default:
        if (const Status reshaped = reshape(rim); !reshaped) return reshaped.error();
        return false;
    }
  }

  void find(RimState& rim, const Sweep& sweep) {
    const Stopwatch watch(rim.step.statistics.query_s);
    size_t& next = work_.next;
    if (work_.stage == Stage::kSweep) {
      KERF_ASSERT(next <= sweep.moves.size());
      const size_t end = std::min(sweep.moves.size(), next + faces_per_batch());
      for (; next < end; ++next) add_to_region(rim, sweep.moves[next], sweep.in_body_frame);
      taken_ += kLightPart;
      if (next == sweep.moves.size()) go_to(Stage::kFindNear);
    } else if (work_.stage == Stage::kFindNear) {
      if (next < rim.region.parts()) taken_ += 1 + kNearFace * find_near(rim, static_cast<uint32_t>(next++));
      if (next == rim.region.parts()) go_to(work_.waiting.empty() ? Stage::kSeparate : Stage::kSort);
    } else {
      taken_ += kLightPart;
      if (!sort_near(rim)) return;
      work_.waiting = rim.faces;
      go_to(Stage::kRefine);
    }
  }

  // Refines and moves vertices alternately, because each may require the other, then cuts and flips edges.
  Status reshape(RimState& rim) {
    if (rim.mesh().live_faces() > settings_.max_faces) return too_many_faces(settings_);
    const Stopwatch watch(rim.step.statistics.refine_s);
    const bool asks_for_distances = work_.stage == Stage::kRefine || work_.stage == Stage::kMoveInPlane ||
                                    work_.stage == Stage::kMoveAlongEdges;
    taken_ += asks_for_distances ? kHeaviestPart : kHeavyPart;
    if (work_.stage == Stage::kRefine) {
      if (const Status refined = refine_rim(rim); !refined) return refined;
      if (work_.waiting.empty()) go_to(Stage::kListInPlane);
    } else if (work_.stage == Stage::kSplitInTheWay) {
      if (split_in_the_way(rim)) refit_or_settle();
    } else if (work_.stage == Stage::kFlip) {
      if (flip_near_rim(rim)) flip_again_or_close();
    } else {
      const auto list = std::ranges::find(kListStages, work_.stage, &ListStage::stage);
      KERF_ASSERT(list != kListStages.end());
      if (list->do_part(rim)) go_to(list->next);
    }
    return Done{};
  }

  void refit_or_settle() {
    constexpr int kMaxRounds = 4;
    if (++work_.rounds < kMaxRounds && !work_.waiting.empty()) return go_to(Stage::kRefine);
    work_.waiting.clear();
    work_.rounds = 0;
    go_to(Stage::kListNear);
  }

  void flip_again_or_close() {
    constexpr int kMaxRounds = 4;
    const bool again = std::exchange(work_.flipped, false) && ++work_.rounds < kMaxRounds;
    if (again) return;
    work_.waiting.clear();
    go_to(Stage::kCloseByWalls);
  }

  void end_bite() {
    if (settings_.faces_per_step < kAllAtOnce) taken_ = std::max(taken_, settings_.faces_per_step);
  }

  // Returns true once the walls are complete or the body is left open. The following search runs in a
  // separate step.
  bool close(RimState& rim, const Sweep& sweep) {
    if (!rim.step.body().solid) return true;
    if (!work_.closing)
      work_.closing = std::make_shared<WallClosing>(moves_in_body(rim.step.body().placement, sweep));
    taken_ += 2 * kPartOfWork;  // one part a step: a unit takes twice as long as a face
    if (!work_.closing->resume(rim)) return false;
    end_bite();
    ClosedRim closed = work_.closing->take();
    for (std::string& why : closed.left_open) left_open_.push_back({rim.step.id, std::move(why)});
    if (settings_.heat_width > 0) work_.waiting = std::move(closed.walls);
    return true;
  }

  // Returns true if all walls are heated.
  bool heat(const RimState& rim) {
    KERF_ASSERT(work_.waiting.empty() || (rim.step.body().solid && settings_.heat_width > 0));
    KERF_ASSERT(work_.next <= work_.waiting.size());
    const size_t end = std::min(work_.waiting.size(), work_.next + 8 * faces_per_batch());
    heat_walls(world_, rim.step, std::span(work_.waiting).subspan(work_.next, end - work_.next));
    taken_ += end - std::exchange(work_.next, end);
    return end == work_.waiting.size();
  }

  void separate_pieces(BodyStep& step) {
    taken_ += separate(world_, step, {}, settings_.search_a_move);
    request_joints(world_, world_.body(step.id), {}, work_.removed);
  }

  void go_to(Stage stage) {
    work_.stage = stage;
    work_.next = 0;
  }

  World& world_;
  const CutSettings& settings_;
  UnfinishedRim& work_;
  const Progress& progress_;
  size_t taken_ = 0;  // faces
  std::vector<LeftOpen> left_open_;
};

}  // namespace

double RimState::distance(VertexId v, FaceId face) {
  const uint32_t known = work.distance_of.get(v.index);
  if (known != 0) return work.distances[known - 1];
  double d = region.signed_distance(face, mesh().position(v));
  if (std::abs(d) <= kRimOn * radius()) d = 0;
  record_distance(v, d);
  return d;
}

void RimState::record_distance(VertexId v, double d) {
  uint32_t& known = work.distance_of.at(v.index);
  if (known == 0) {
    work.distances.push_back(d);
    known = static_cast<uint32_t>(work.distances.size());
  }
  work.distances[known - 1] = d;
}

std::array<double, 3> RimState::distances_of(FaceId face) {
  const auto c = mesh().corners(face);
  return {distance(c[0], face), distance(c[1], face), distance(c[2], face)};
}

bool RimState::inside(FaceId face) {
  const auto d = distances_of(face);
  if (d[0] > 0 || d[1] > 0 || d[2] > 0) return false;
  if (d[0] < 0 || d[1] < 0 || d[2] < 0) return true;
  const Triangle t = mesh().triangle(face);
  return region.signed_distance(face, (t[0] + t[1] + t[2]) / 3.0) < 0;
}

Result<StepResult> rim_step(World& world, const CutSettings& settings, std::span<const BeamMove> path,
                            const SweptByBody& swept, UnfinishedRim& unfinished, const Progress* progress) {
  StepResult result;
  const Progress asked = share_of(progress, 0, 1);
  const Result<bool> closed = RimBite(world, settings, unfinished, asked).take(path, swept, result);
  if (!closed || *closed) unfinished = UnfinishedRim{};
  if (!closed) return closed.error();
  return result;
}

Result<StepResult> close_rim(World& world, const CutSettings& settings, std::span<const BeamMove> path,
                             const SweptByBody& swept, const Progress* progress) {
  CutSettings at_once = settings;
  at_once.faces_per_step = kAllAtOnce;
  UnfinishedRim whole;
  return rim_step(world, at_once, path, swept, whole, progress);
}

}  // namespace kerf
