#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/assert.h"
#include "core/base/tolerances.h"
#include "core/cut/cut_stages.h"
#include "core/cut/cut_step.h"
#include "core/cut/rim_stages_internal.h"
#include "core/cut/stopwatch.h"
#include "core/joints/joined_parts.h"

namespace kerf {

namespace {

using Stage = UnfinishedRim::Stage;

constexpr size_t kAllAtOnce = std::numeric_limits<size_t>::max();  // an unlimited bite
// Cost of a part of a stage, in faces of a bite; cost of a face found near the boundary.
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

// One step, which ends after about settings.bite faces.
class RimBite {
 public:
  RimBite(World& world, const CutSettings& settings, UnfinishedRim& unfinished, const Progress& progress)
      : world_(world), settings_(settings), work_(unfinished), progress_(progress) {}

  // Returns true if the rim is closed in all bodies.
  Result<bool> take(std::span<const BeamMove> path, const SweptByBody& swept, StepResult& result) {
    const std::vector<BodyId> ids = cuttable(world_);
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
      if (taken_ >= settings_.bite && work_.bodies < ids.size()) {
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
    } while (taken_ < settings_.bite);
    return Reached::kEndOfBite;
  }

  void follow_with_tree(RimState& rim) const {
    update_tree(rim.step);
    const Stopwatch watch(rim.step.statistics.update_tree_s);
    rim.step.edit.refit_tree();
  }

  // A stage over a list: the function that does its next part (true at the end), and the following stage.
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

  // Does the next part of a stage. Returns true if the body is completed.
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
    if (settings_.bite < kAllAtOnce) taken_ = std::max(taken_, settings_.bite);
  }

  // Returns true once the body is closed or stays open. The search that follows is in a separate step.
  bool close(RimState& rim, const Sweep& sweep) {
    if (!rim.step.body().solid) return true;
    if (!work_.closing)
      work_.closing = std::make_shared<WallClosing>(moves_in_body(rim.step.body().placement, sweep));
    taken_ += kPartOfWork;
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
  at_once.bite = kAllAtOnce;
  UnfinishedRim whole;
  return rim_step(world, at_once, path, swept, whole, progress);
}

}  // namespace kerf
