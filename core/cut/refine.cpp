#include <algorithm>
#include <limits>

#include "core/cut/step_state.h"
#include "core/cut/stopwatch.h"

namespace kerf {

namespace {

// How far a face reaches out of the volume of a move, whichever ray of the beam is nearest.
double overshoot(const BodyStep& step, const Triangle& t) {
  double least = std::numeric_limits<double>::infinity();
  for (const SweptCylinder& part : step.beam) least = std::min(least, part.overshoot(t));
  return least;
}

bool is_fine_enough(const BodyStep& step, const CutSettings& settings, const Triangle& element, FaceId f) {
  const Resolution& r = settings.resolution;
  const int level = step.mesh().data(f).halvings / 2;
  if (level >= Resolution::kLargestDepth) return true;
  switch (r.rule) {
    case Resolution::Rule::kDepth:
      return level >= r.depth;
    case Resolution::Rule::kTargetEdge:
      return longest_edge2(element) <= r.target_edge * r.target_edge;
    case Resolution::Rule::kTolerance:
      return overshoot(step, element) <= r.tolerance;
  }
  return true;
}

// Looks at faces that the beam may touch, and splits those that are too coarse. A face that lies within the
// beam is removed whole by the geometric model, and needs no splitting.
class Refinement {
 public:
  Refinement(BodyStep& step, const CutSettings& settings, std::vector<FaceId>& to_split)
      : step_(step), settings_(settings), to_split_(to_split) {}

  Status run() {
    for (size_t looked_at = 0; looked_at < faces_together() && !to_split_.empty(); ++looked_at) {
      const FaceId f = to_split_.back();
      to_split_.pop_back();
      if (!must_split(f)) continue;
      step_.edit.clear_hit(f);  // its parts lie in smaller boxes, which the next query tests
      const std::span<const Replacement> splits = split_by_scheme(step_, settings_.resolution.scheme, f);
      for (size_t i = splits.size(); i-- > 0;) {
        const Replacement& r = splits[i];
        to_split_.insert(to_split_.end(), r.born.begin(), r.born.begin() + r.born_count);
      }
      if (step_.mesh().live_faces() > settings_.most_faces) return too_many_faces(settings_);
    }
    return Done{};
  }

 private:
  bool must_split(FaceId f) const {
    const Mesh& mesh = step_.mesh();
    const OneToFour& refinement = step_.body().refinement;
    const Triangle face = mesh.triangle(f), element = refinement.triangle(mesh, f);
    if (is_fine_enough(step_, settings_, element, f)) return false;
    const auto touched = [&](const SweptCylinder& part) { return part.touches(face); };
    const auto within = [&](const SweptCylinder& part) { return part.contains(element); };
    return std::any_of(step_.beam.begin(), step_.beam.end(), touched) &&
           (settings_.model == Model::kThermal || std::none_of(step_.beam.begin(), step_.beam.end(), within));
  }

  BodyStep& step_;
  const CutSettings& settings_;
  std::vector<FaceId>& to_split_;
};

}  // namespace

// The tree follows also where the work fails half-way.
Status refine(BodyStep& step, UnfinishedMove& move, const CutSettings& settings, const Progress& progress) {
  if (!progress.report(0)) return cancelled();
  Refinement refinement(step, settings, move.to_split);
  const Status done = [&] {
    const Stopwatch watch(step.statistics.refine_s);
    return refinement.run();
  }();
  if (step.edit.splits().empty()) return done;
  move.has_split = true;
  update_tree(step);
  return done;
}

bool is_fine_enough(const BodyStep& step, const CutSettings& settings, FaceId f) {
  return is_fine_enough(step, settings, step.body().refinement.triangle(step.mesh(), f), f);
}

Error too_many_faces(const CutSettings& settings) {
  return failed("the cut would make more than " + std::to_string(settings.most_faces) +
                " faces: choose a coarser resolution or a shorter stroke");
}

void update_tree(BodyStep& step) {
  const Stopwatch watch(step.statistics.update_tree_s);
  step.edit.update_tree();
}

std::span<const Replacement> split_by_scheme(BodyStep& step, Scheme scheme, FaceId f) {
  const size_t first = step.edit.splits().size();
  if (scheme == Scheme::kOneToFour) {
    step.edit.split_in_four(f);
  } else {
    step.edit.bisect_at_longest_edge(f);
  }
  return step.edit.splits().subspan(first);
}

}  // namespace kerf
