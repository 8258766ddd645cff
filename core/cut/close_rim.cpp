#include <algorithm>
#include <cmath>

#include "core/base/tolerances.h"
#include "core/cut/cuttable.h"
#include "core/cut/rim_state.h"
#include "core/cut/stopwatch.h"
#include "core/graph/hold_parts.h"

namespace kerf {

double RimState::distance(VertexId v, FaceId face) {
  const auto known = distances.find(v.index);
  if (known != distances.end()) return known->second;
  double d = region.signed_distance(face, mesh().position(v));
  if (std::abs(d) <= kRimOn * radius()) d = 0;
  distances.emplace(v.index, d);
  return d;
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

namespace {

// The faces that meet the boundary, or lie so near that a vertex could be on it.
void find_near(RimState& rim) {
  const Stopwatch watch(rim.step.figures.query_s);
  std::vector<FaceId> found;
  for (uint32_t i = 0; i < rim.region.parts(); ++i) {
    const SweptCylinder& part = rim.region.part(i);
    found.clear();
    const QueryCounts counts =
        rim.step.edit.touched(part.with_radius(part.radius() * (1 + 2 * kRimOn)), found);
    rim.step.figures.tested.boxes += counts.boxes;
    rim.step.figures.tested.faces += counts.faces;
    for (const FaceId f : found) {
      if (!rim.region.is_near(f)) rim.faces.push_back(f);
      rim.region.note_near(f, i);
    }
  }
  std::sort(rim.faces.begin(), rim.faces.end());
}

// Refines and moves vertices, in turn, for the one may ask for the other.
Status fit_to_boundary(RimState& rim, const Progress& progress) {
  const Stopwatch watch(rim.step.figures.refine_s);
  constexpr int kMostRounds = 4;
  std::vector<FaceId> waiting = rim.faces;
  for (int round = 0; round < kMostRounds && !waiting.empty(); ++round) {
    if (const Status refined = refine_rim(rim, std::move(waiting), progress); !refined) return refined;
    waiting.clear();
    for (const FaceId f : snap_to_rim(rim)) split_near_rim(rim, f, waiting);
  }
  settle_on_rim(rim);
  return Done{};
}

void refit_tree(RimState& rim) {
  const Stopwatch watch(rim.step.figures.update_tree_s);
  rim.step.edit.refit_tree();
}

// The tree follows also where the work is stopped half-way.
Status close(RimState& rim, const Progress& progress) {
  find_near(rim);
  if (rim.faces.empty()) return Done{};
  const Status fitted = fit_to_boundary(rim, progress);
  if (fitted) clip_at_rim(rim);
  update_tree(rim.step);
  if (fitted) {
    remove_within_rim(rim);
    flip_near_rim(rim);
  }
  refit_tree(rim);
  return fitted;
}

// All that the beam has swept in the body.
void add_region(RimState& rim, std::span<const BeamMove> path, const SweptByBody& swept) {
  BodyStep& step = rim.step;
  const Laser& laser = rim.settings.laser;
  const auto add = [&] {
    for (const SweptCylinder& part : step.beam) rim.region.add(part);
  };
  const auto own = swept.find(step.id);
  if (own == swept.end()) {
    for (const BeamMove& move : path) {
      sweep(step, laser, move);
      add();
    }
    return;
  }
  for (const BeamMove& move : own->second) {
    step.beam = sweep_beam(laser, move);
    add();
  }
}

}  // namespace

Result<StepResult> close_rim(World& world, const CutSettings& settings, std::span<const BeamMove> path,
                             const SweptByBody& swept, const Progress* progress) {
  StepResult result;
  const std::vector<BodyId> ids = cuttable(world);
  double done = 0;
  for (const BodyId id : ids) {
    BodyStep step(id, world.body(id));
    RimState rim(step, settings);
    add_region(rim, path, swept);
    const double share = 1 / static_cast<double>(ids.size());
    if (const Status closed = close(rim, share_of(progress, done, done + share)); !closed)
      return closed.error();
    done += share;
    separate(world, step, {}, settings.search_a_move);
    ask_joints(world, world.body(id), {}, step.edit.removed_faces() > 0);
    end_step(step, result);
  }
  hold_what_joints_hold(world, result.delta);
  return result;
}

}  // namespace kerf
