#include <algorithm>
#include <limits>

#include "core/cut/step_state.h"
#include "core/cut/stopwatch.h"
#include "core/mesh/longest_edge.h"

namespace kerf {

namespace {

constexpr size_t kSplitsToAsk = 1000;  // a few milliseconds

// Splits what the beam touches until it is fine enough, and follows with the tree.
class Refinement {
 public:
  Refinement(BodyStep& step, const CutSettings& settings, const Progress& progress)
      : step_(step), settings_(settings), progress_(progress) {}

  Result<bool> run() {
    std::vector<FaceId> waiting(step_.hit.rbegin(), step_.hit.rend());
    while (!waiting.empty()) {
      const FaceId f = waiting.back();
      waiting.pop_back();
      if (!must_split(f)) continue;
      if (splits_++ % kSplitsToAsk == 0 && !progress_.report(0)) return cancelled();
      const size_t first = replaced_.size();
      split_by_scheme(step_, settings_.resolution.scheme, f, replaced_);
      for (size_t i = replaced_.size(); i > first; --i) {
        const auto& r = replaced_[i - 1];
        waiting.insert(waiting.end(), r.born.begin(), r.born.begin() + r.born_count);
      }
      if (step_.body.mesh.live_faces() > settings_.most_faces) {
        return too_many_faces(settings_);
      }
    }
    return !replaced_.empty();
  }

  const std::vector<Replacement>& replaced() const { return replaced_; }

 private:
  bool must_split(FaceId f) const {
    const Mesh& mesh = step_.body.mesh;
    const OneToFour& refinement = step_.body.refinement;
    const Triangle face = mesh.triangle(f), element = refinement.triangle(mesh, f);
    if (fine_enough(f, element)) return false;
    const auto touched = [&](const SweptCylinder& part) { return part.touches(face); };
    const auto within = [&](const SweptCylinder& part) { return part.contains(element); };
    return std::any_of(step_.beam.begin(), step_.beam.end(), touched) &&
           std::none_of(step_.beam.begin(), step_.beam.end(), within);
  }

  bool fine_enough(FaceId f, const Triangle& element) const {
    const Resolution& r = settings_.resolution;
    const int level = step_.body.mesh.data(f).halvings / 2;
    if (level >= Resolution::kLargestDepth) return true;
    switch (r.rule) {
      case Resolution::Rule::kDepth:
        return level >= r.depth;
      case Resolution::Rule::kTargetEdge:
        return longest_edge2(element) <= r.target_edge * r.target_edge;
      case Resolution::Rule::kTolerance:
        return overshoot(element) <= r.tolerance;
    }
    return true;
  }

  // How far the face reaches out of the volume of this move, whichever ray of the beam is nearest.
  double overshoot(const Triangle& t) const {
    double least = std::numeric_limits<double>::infinity();
    for (const SweptCylinder& part : step_.beam) least = std::min(least, part.overshoot(t));
    return least;
  }

  BodyStep& step_;
  const CutSettings& settings_;
  const Progress& progress_;
  size_t splits_ = 0;
  std::vector<Replacement> replaced_;
};

}  // namespace

Result<bool> refine(BodyStep& step, const CutSettings& settings, const Progress& progress) {
  Refinement refinement(step, settings, progress);
  Result<bool> done = [&] {
    const Stopwatch watch(step.figures.refine_s);
    return refinement.run();
  }();
  follow_splits(step, refinement.replaced());
  return done;
}

Error too_many_faces(const CutSettings& settings) {
  return failed("the cut would make more than " + std::to_string(settings.most_faces) +
                " faces: choose a coarser resolution or a shorter stroke");
}

void follow_splits(BodyStep& step, std::span<const Replacement> replaced) {
  const Stopwatch watch(step.figures.update_tree_s);
  step.body.tree.replace(step.body.mesh, replaced);
  for (const Replacement& r : replaced) {
    step.edited.insert(step.edited.end(), r.born.begin(), r.born.begin() + r.born_count);
    const int made = r.born_count - r.gone_count;
    step.figures.faces_made += static_cast<size_t>(made);
    note_replaced(step.body, r);
    step.body.count(r.born[0], made, 0);
  }
}

void split_by_scheme(BodyStep& step, Scheme scheme, FaceId f, std::vector<Replacement>& out) {
  Body& body = step.body;
  if (scheme == Scheme::kOneToFour) {
    if (body.refinement.can_split(body.mesh, f)) body.refinement.split(body.mesh, f, out);
  } else {
    bisect_longest_edge(body.mesh, body.refinement, f, out);
  }
}

}  // namespace kerf
