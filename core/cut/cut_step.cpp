#include "core/cut/cut_step.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/assert.h"
#include "core/cut/cut_stages.h"
#include "core/cut/stopwatch.h"
#include "core/cut/thermal_step.h"
#include "core/edit/detach.h"
#include "core/tree/queries.h"

namespace kerf {

namespace {

constexpr size_t kMaxParts = 2000;  // of a move; a drag across the viewport has fewer

bool meets(const Body& body, const SweptCylinder& beam) {
  return !trace_touched(body.tree, body.mesh, beam).touched.empty();
}

bool meets(const Body& body, const Laser& laser, const BeamMove& move) {
  const BeamMove seen{body.placement.to_body(move.from), body.placement.to_body(move.to), move.seconds};
  return std::ranges::any_of(sweep_beam(laser, seen),
                             [&](const SweptCylinder& part) { return meets(body, part); });
}

// Returns the distance (m) from the beam's origin within which all faces lie.
double reach(const World& world, const Laser& laser, const Vec3& origin) {
  const World::Bounds bounds = world.bounds();
  const Vec3 far = glm::max(glm::abs(bounds.min - origin), glm::abs(bounds.max - origin));
  return std::min(laser.range.high, glm::length(far));
}

// One step, which ends after settings.faces_per_step faces.
class StepRun {
 public:
  StepRun(World& world, const CutSettings& settings, UnfinishedMove& unfinished, const Progress& progress)
      : world_(world), settings_(settings), move_(unfinished), progress_(progress) {
    for (const BodyId id : cuttable(world, settings)) bodies_.emplace_back(id, world.body(id));
  }

  // For moves through one body, in its frame.
  StepRun(World& world, BodyId id, const CutSettings& settings, UnfinishedMove& unfinished,
          const Progress& progress)
      : world_(world), settings_(settings), move_(unfinished), progress_(progress), in_body_frame_(true) {
    bodies_.emplace_back(id, world.body(id));
  }

  // Executes at most `max_parts` parts of a move within faces_per_step faces. Returns true if the move is
  // finished.
  Result<bool> take(const BeamMove& move, size_t max_parts = kNoLimit) {
    KERF_ASSERT(move_.bodies <= bodies_.size());
    const bool stage_by_stage = max_parts != kNoLimit;
    for (; move_.bodies < bodies_.size(); ++move_.bodies) {
      BodyStep& step = bodies_[move_.bodies];
      sweep(step, settings_.laser, move, in_body_frame_);
      do {
        const size_t faces = faces_ahead();
        if (max_parts-- == 0 || (taken_ > 0 && taken_ + faces > settings_.faces_per_step)) return false;
        taken_ += faces;
        if (const Status done = run_stage(step); !done) return done.error();
        if (!stage_by_stage && is_missed(step)) move_.stage = Stage::kFind;
      } while (move_.stage != Stage::kFind);
    }
    end_move();
    return true;
  }

  void skip_joints() { applies_joints_ = false; }

  void end(StepResult& result) {
    for (BodyStep& step : bodies_) end_step(step, result);
    result.delta.append(std::move(held_));
  }

 private:
  using Stage = UnfinishedMove::Stage;

  // Returns the number of faces that the next part processes, except those that it finds or visits in a
  // search.
  size_t faces_ahead() const {
    const auto clamped = [](size_t faces) { return std::clamp<size_t>(faces, 1, faces_per_batch()); };
    switch (move_.stage) {
      case Stage::kFind:
        return 1;
      case Stage::kRefine:
        return clamped(move_.to_split.size());
      case Stage::kRemove:
        return clamped(move_.hit.size() - move_.removed);
      case Stage::kFindAgain:
      case Stage::kSeparate:
        return move_.hit.size();
    }
    return 1;
  }

  // Returns true if a body needs no work: the beam touches none of its faces, and no search for parts is
  // unfinished.
  bool is_missed(const BodyStep& step) const {
    return move_.stage == Stage::kRefine && move_.hit.empty() && is_settled(step.body());
  }

  // Executes the next part of a move through a body.
  Status run_stage(BodyStep& step) {
    switch (move_.stage) {
      case Stage::kFind:
        find(step);
        break;
      case Stage::kRefine:
        if (const Status refined = refine(step, move_, settings_, progress_); !refined) return refined;
        if (move_.to_split.empty()) move_.stage = move_.has_split ? Stage::kFindAgain : Stage::kRemove;
        break;
      case Stage::kFindAgain:
        hit(step, move_.hit);
        move_.stage = Stage::kRemove;
        break;
      case Stage::kRemove:
        remove(step, move_, settings_.smooth(), settings_.heat_width > 0);
        if (move_.removed == move_.hit.size()) move_.stage = Stage::kSeparate;
        break;
      case Stage::kSeparate:
        leave_heat(step);
        taken_ += separate_parts(step);
        move_.stage = Stage::kFind;
        break;
    }
    return Done{};
  }

  void find(BodyStep& step) {
    hit(step, move_.hit);
    taken_ += move_.hit.size();
    move_.to_split.assign(move_.hit.rbegin(), move_.hit.rend());
    move_.has_split = false;
    move_.removed = 0;
    move_.stage = Stage::kRefine;
  }

  // Separated parts of a solid body are known only after walls have closed it at the end of the stroke.
  size_t separate_parts(BodyStep& step) {
    if (!step.body().solid || !settings_.smooth())
      return separate(world_, step, move_.hit, settings_.search_a_move);
    request_joints(world_, world_.body(step.id), move_.hit, false);
    return 0;
  }

  void leave_heat(BodyStep& step) {
    if (settings_.heat_width <= 0 || move_.hit.empty()) return;
    move_.beside.insert(move_.beside.end(), move_.hit.begin(), move_.hit.end());
    taken_ += move_.beside.size();
    deposit_heat(world_, step, settings_, move_.beside);
    move_.beside.clear();
  }

  void end_move() {
    move_.bodies = 0;
    if (applies_joints_) apply_joints(world_, held_);
  }

  World& world_;
  const CutSettings& settings_;
  UnfinishedMove& move_;
  const Progress& progress_;
  std::vector<BodyStep> bodies_;
  bool in_body_frame_ = false;  // of the moves
  bool applies_joints_ = true;
  Delta held_;        // changes made by joints
  size_t taken_ = 0;  // faces
};

// Executes moves like cut_step, but at most `max_parts` parts of each.
Result<StepResult> cut(World& world, const CutSettings& settings, std::span<const BeamMove> moves,
                       size_t max_parts, UnfinishedMove& unfinished, const Progress* progress) {
  if (settings.model == Model::kThermal) return thermal_step(world, settings, moves, progress);
  StepResult result;
  const Progress asked = share_of(progress, 0, 1);
  StepRun run(world, settings, unfinished, asked);
  for (const BeamMove& move : moves) {
    const Result<bool> through = run.take(move, max_parts);
    if (!through) {
      unfinished = UnfinishedMove{};
      return through.error();
    }
    if (!*through) break;
    ++result.moves;
    result.last = move;
  }
  run.end(result);
  return result;
}

Result<StepResult> cut_one(World& world, const CutSettings& settings, BodyId id,
                           std::span<const BeamMove> moves, bool applies_joints, const Progress* progress) {
  KERF_ASSERT(!world.body(id).hidden);
  StepResult result;
  UnfinishedMove whole;
  CutSettings at_once = settings;
  at_once.faces_per_step = std::numeric_limits<size_t>::max();
  const Progress asked = share_of(progress, 0, 1);
  StepRun run(world, id, at_once, whole, asked);
  if (!applies_joints) run.skip_joints();
  for (const BeamMove& move : moves) {
    if (const Result<bool> through = run.take(move); !through) return through.error();
  }
  run.end(result);
  return result;
}

}  // namespace

const char* label(WallNeed need) {
  constexpr std::array kLabels{"", "walls need the whole volume of the beam",
                               "walls need the geometric model", "walls need a smooth rim"};
  return kLabels.at(static_cast<size_t>(need));
}

std::vector<BodyId> cuttable(const World& world) {
  std::vector<BodyId> ids = world.ids();
  std::erase_if(ids, [&](BodyId id) { return world.body(id).hidden; });
  return ids;
}

std::vector<BodyId> cuttable(const World& world, const CutSettings& settings) {
  std::vector<BodyId> ids = cuttable(world);
  std::erase_if(ids, [&](BodyId id) { return !settings.cuts(id); });
  return ids;
}

bool hits_anything(const World& world, const Laser& laser, const BeamMove& move) {
  const double far = reach(world, laser, move.from.origin);
  if (subdivisions(move, laser.radius, far) > kMaxParts) return true;
  const std::vector<BeamMove> parts = subdivide(move, laser.radius, far);
  return std::ranges::any_of(cuttable(world), [&](BodyId id) {
    return std::ranges::any_of(parts,
                               [&](const BeamMove& part) { return meets(world.body(id), laser, part); });
  });
}

bool hits_anything(const World& world, const Laser& laser, const Pose& pose) {
  return hits_anything(world, laser, {pose, pose, 0});
}

void StepStatistics::add(const StepStatistics& other) {
  queries += other.queries;
  tested.boxes += other.tested.boxes;
  tested.faces += other.tested.faces;
  faces_made += other.faces_made;
  largest_cosine = std::max(largest_cosine, other.largest_cosine);
  met_s += other.met_s;
  depth_s += other.depth_s;
  query_s += other.query_s;
  refine_s += other.refine_s;
  remove_s += other.remove_s;
  update_tree_s += other.update_tree_s;
  separate_s += other.separate_s;
}

Result<StepResult> cut_step(World& world, const CutSettings& settings, std::span<const BeamMove> moves,
                            UnfinishedMove& unfinished, const Progress* progress) {
  return cut(world, settings, moves, kNoLimit, unfinished, progress);
}

Result<StepResult> cut_stage(World& world, const CutSettings& settings, const BeamMove& move,
                             UnfinishedMove& unfinished, const Progress* progress) {
  return cut(world, settings, {&move, 1}, 1, unfinished, progress);
}

Result<StepResult> cut_body(World& world, const CutSettings& settings, BodyId id,
                            std::span<const BeamMove> moves, const Progress* progress) {
  return cut_one(world, settings, id, moves, true, progress);
}

Result<StepResult> cut_without_separation(World& world, const CutSettings& settings, BodyId id,
                                          std::span<const BeamMove> moves) {
  return cut_one(world, settings, id, moves, false, nullptr);
}

// Includes hidden bodies, because a body may be hidden during a search, and is_settled() requires its end.
StepResult continue_separation(World& world, size_t most, JointMode mode) {
  StepResult result;
  for (const BodyId id : world.ids()) {
    BodyStep step(id, world.body(id));
    separate(world, step, {}, most,
             mode == JointMode::kRigid ? EditPolicy::kNoEdits : EditPolicy::kAllowEdits);
    end_step(step, result);
  }
  apply_joints(world, result.delta, mode);
  return result;
}

bool is_settled(const World& world) {
  return std::ranges::all_of(world.ids(), [&](BodyId id) { return is_settled(world.body(id)); });
}

size_t separate(World& world, BodyStep& step, std::span<const FaceId> hit, size_t most, EditPolicy policy) {
  const Stopwatch watch(step.statistics.separate_s);
  const size_t visited = step.edit.separate(most, policy);
  request_joints(world, world.body(step.id), hit, visited > 0);
  return visited;
}

void apply_joints(World& world, Delta& delta, JointMode mode) {
  for (const BodyId id : world.ids()) {
    if (cavities_requested(world.body(id)) && is_settled(world.body(id)))
      assign_cavities(id, world.body(id), delta);
  }
  if (joints_requested(world) && is_settled(world)) separate_requested_by_joints(world, mode, delta);
}

const BodyDelta* take_changes(BodyStep& step, StepResult& result) {
  step.statistics.faces_made = step.edit.faces_made();
  if (!step.edit.any()) return nullptr;
  result.delta.removed_faces += step.edit.removed_faces();
  const double area = step.edit.removed_area();
  result.delta.removed_area += area;
  result.delta.removed_mass += area * step.body().sheet.thickness * step.body().sheet.substance.density;
  result.delta.solid += step.edit.solid();
  result.delta.bodies.push_back(step.edit.take_delta(step.id));
  return &result.delta.bodies.back();
}

void end_step(BodyStep& step, StepResult& result) {
  if (const BodyDelta* changes = take_changes(step, result)) {
    for (const FaceId f : changes->added) {
      step.statistics.largest_cosine =
          std::max(step.statistics.largest_cosine, largest_cosine(step.mesh().triangle(f)));
    }
  }
  result.statistics.add(step.statistics);
}

}  // namespace kerf
