#include "tests/bench/slot_walk.h"

#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

constexpr double kRadii = 500, kEdges = 1000;  // the longest side of the mesh in these units

}  // namespace

Slot::Slot(const Bounds& box) : low_(box.min), high_(box.max), middle_(0.5 * (box.min + box.max)) {
  const Vec3 size = high_ - low_;
  for (int k = 1; k < 3; ++k) {
    if (size[k] > size[across_]) across_ = k;
  }
  beam_ = across_ == 0 ? 1 : 0;
  along_ = 3 - across_ - beam_;
  if (size[along_] < size[beam_]) std::swap(along_, beam_);
}

double Slot::radius() const { return length() / kRadii; }

Pose Slot::pose(double share) const {
  Pose p{middle_, Vec3(0)};
  const double reach = 0.6 * (high_[along_] - low_[along_]);
  p.origin[along_] += (2 * share - 1) * reach;
  p.origin[beam_] -= length();
  p.direction[beam_] = 1;
  return p;
}

std::vector<BeamMove> Slot::path(int moves) const {
  std::vector<BeamMove> path;
  for (int i = 0; i < moves; ++i) path.push_back({pose(double(i) / moves), pose(double(i + 1) / moves)});
  return path;
}

CutSettings Slot::settings() const {
  CutSettings settings;
  settings.laser.radius = radius();
  settings.laser.range = {0, 4 * length()};
  settings.resolution.target_edge = length() / kEdges;
  return settings;
}

CutSettings Slot::smooth_settings() const {
  CutSettings smooth = settings();
  smooth.resolution.rim = Rim::kSmooth;
  return smooth;
}

CutSettings Slot::quick_settings() const {
  CutSettings quick = settings();
  quick.resolution.rule = Resolution::Rule::kTolerance;
  quick.resolution.tolerance = radius();
  return quick;
}

double Walked::quantile(double share) const {
  std::vector<double> some;
  for (size_t i = 0; i < steps.size(); ++i) {
    if (removed[i]) some.push_back(steps[i]);
  }
  return some.empty() ? 0 : bench::quantile(std::move(some), share);
}

Walked walk(World& world, const CutSettings& settings, std::span<const BeamMove> path) {
  Walked walked;
  const auto take = [&](auto&& step) {
    Result<StepResult> result = failed("");
    const double seconds = seconds_of([&] { result = step(); });
    walked.seconds += seconds;
    walked.turned += 2 * result->delta.removed_faces + result->statistics.faces_made;
    walked.walls += result->delta.solid.wall_faces;
    walked.left_open += result->delta.left_open.size();
    walked.steps.push_back(seconds);
    walked.removed.push_back(result->delta.removed_faces > 0);
    return result->moves;
  };
  UnfinishedMove unfinished;
  for (size_t i = 0; i < path.size();)
    i += take([&] { return cut_step(world, settings, path.subspan(i, 1), unfinished); });
  UnfinishedRim rim;
  for (bool closed = !settings.smooth(); !closed; closed = !rim.begun())
    take([&] { return rim_step(world, settings, path, {}, rim); });
  while (!is_settled(world))
    take([&] { return Result<StepResult>(continue_separation(world, settings.search_a_move)); });
  return walked;
}

}  // namespace kerf::bench
