#include <algorithm>

#include "core/cut/step_state.h"
#include "core/cut/stopwatch.h"

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
      step_.body.refinement.split(step_.body.mesh, f, replaced_);
      for (size_t i = replaced_.size(); i > first; --i) {
        const auto& r = replaced_[i - 1];
        waiting.insert(waiting.end(), r.born.begin(), r.born.begin() + r.born_count);
      }
      if (step_.body.mesh.live_faces() > settings_.most_faces) {
        return failed("the cut would make more than " + std::to_string(settings_.most_faces) +
                      " faces: choose a coarser resolution or a shorter stroke");
      }
    }
    return !replaced_.empty();
  }

  void follow() {
    const Stopwatch watch(step_.figures.update_tree_s);
    for (const auto& r : replaced_) {
      step_.body.tree.replace(step_.body.mesh, {r.gone.data(), r.gone_count}, {r.born.data(), r.born_count});
      step_.edited.insert(step_.edited.end(), r.born.begin(), r.born.begin() + r.born_count);
      const size_t made = size_t{r.born_count} - r.gone_count;
      step_.figures.faces_made += made;
      step_.body.pieces[step_.body.mesh.data(r.born[0]).piece].faces += made;
    }
  }

 private:
  bool must_split(FaceId f) const {
    const Mesh& mesh = step_.body.mesh;
    const OneToFour& refinement = step_.body.refinement;
    if (fine_enough(f)) return false;
    const Triangle face = mesh.triangle(f), element = refinement.triangle(mesh, f);
    const auto touched = [&](const SweptCylinder& part) { return part.touches(face); };
    const auto within = [&](const SweptCylinder& part) { return part.contains(element); };
    return std::any_of(step_.beam.begin(), step_.beam.end(), touched) &&
           std::none_of(step_.beam.begin(), step_.beam.end(), within) && refinement.can_split(mesh, f);
  }

  bool fine_enough(FaceId f) const {
    const Mesh& mesh = step_.body.mesh;
    const Resolution& r = settings_.resolution;
    const int level = mesh.data(f).level;
    if (level >= Resolution::kLargestDepth) return true;
    if (r.rule == Resolution::Rule::kDepth) return level >= r.depth;
    return longest_edge2(step_.body.refinement.triangle(mesh, f)) <= r.target_edge * r.target_edge;
  }

  BodyStep& step_;
  const CutSettings& settings_;
  const Progress& progress_;
  size_t splits_ = 0;
  std::vector<OneToFour::Replacement> replaced_;
};

}  // namespace

Result<bool> refine(BodyStep& step, const CutSettings& settings, const Progress& progress) {
  Refinement refinement(step, settings, progress);
  Result<bool> done = [&] {
    const Stopwatch watch(step.figures.refine_s);
    return refinement.run();
  }();
  refinement.follow();
  return done;
}

}  // namespace kerf
