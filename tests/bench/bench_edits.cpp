#include <algorithm>
#include <optional>

#include "core/mesh/refinement.h"
#include "core/tree/aabb_tree.h"
#include "core/tree/tree_internal.h"
#include "tests/bench/sections.h"
#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

constexpr double kFaceBar = 60;             // ns a new face
constexpr double kRebuildBar = 1.0 / 5000;  // of Embree's low quality
constexpr uint32_t kManyFaces = 1000000;    // from which that is asked
constexpr double kSlitBar = 1.15, kElsewhereBar = 1.05;
constexpr int kDeepest = 4;  // splits in four

// A cut by four rays a step: the faces that they cross are split until they are fine, and the finest go. The
// tree hears of a step's splits together, then of its removals.
class Cut {
 public:
  explicit Cut(const Subject& s) : mesh(s.mesh), tree(s.mesh), reach_(s.reach()) {}

  void step(std::span<const Pose> rays) {
    find(rays);
    refine(rays);
    follow();
    remove(rays);
  }

  Mesh mesh;
  AabbTree tree;
  double tree_seconds = 0;
  size_t new_faces = 0;  // that the tree was told of as born

 private:
  void find(std::span<const Pose> rays) {
    waiting_.clear();
    for (const Pose& ray : rays) {
      hits_.clear();
      tree.crossings(mesh, ray, {0, reach_}, hits_);
      for (const RayHit& hit : hits_) waiting_.push_back(hit.face);
    }
  }

  bool crossed(std::span<const Pose> rays, FaceId f) const {
    const Triangle t = mesh.triangle(f);
    return std::any_of(rays.begin(), rays.end(),
                       [&](const Pose& ray) { return ShearedRay(ray).cross(t).has_value(); });
  }

  void refine(std::span<const Pose> rays) {
    replaced_.clear();
    fine_.clear();
    while (!waiting_.empty()) {
      const FaceId f = waiting_.back();
      waiting_.pop_back();
      if (!crossed(rays, f)) continue;
      if (mesh.data(f).halvings >= 2 * kDeepest) {
        fine_.push_back(f);
        continue;
      }
      const size_t first = replaced_.size();
      refinement_.split(mesh, f, replaced_);
      for (size_t i = first; i < replaced_.size(); ++i) {
        const auto& r = replaced_[i];
        waiting_.insert(waiting_.end(), r.added.begin(), r.added.begin() + r.added_count);
      }
    }
  }

  void follow() {
    for (const auto& r : replaced_) new_faces += r.added_count;
    tree_seconds += seconds_of([&] { tree.replace(mesh, replaced_); });
  }

  void remove(std::span<const Pose> rays) {
    removed_.clear();
    for (const FaceId f : fine_) {
      if (!mesh.is_live(f) || !crossed(rays, f)) continue;
      const auto element = refinement_.element(mesh, f);
      refinement_.forget(mesh, f);
      for (int i = 0; i < element.face_count; ++i) {
        mesh.remove_face(element.faces[i]);
        removed_.push_back(element.faces[i]);
      }
    }
    tree_seconds += seconds_of([&] {
      for (const FaceId f : removed_) tree.remove(f);
    });
  }

  OneToFour refinement_;
  double reach_;
  std::vector<FaceId> waiting_, fine_, removed_;
  std::vector<RayHit> hits_;
  std::vector<Replacement> replaced_;
};

Pair query_both(const AabbTree& grown, const AabbTree& fresh, const Mesh& mesh, std::span<const Pose> rays,
                double reach, int times) {
  std::vector<RayHit> hits;
  const auto ask = [&](const AabbTree& tree) {
    for (const Pose& ray : rays) {
      hits.clear();
      tree.crossings(mesh, ray, {0, reach}, hits);
    }
  };
  return in_turn(
      times, [&] { ask(grown); }, [&] { ask(fresh); });
}

}  // namespace

void bench_edits(const Subject& s, const Effort& effort, const Report& report) {
  const std::vector<Pose> rays = sweep_rays(s, effort.edit_steps);
  std::optional<Cut> made;
  std::vector<double> tree_seconds;
  for (int i = 0; i < effort.build_times; ++i) {
    made.emplace(s);
    for (size_t at = 0; at < rays.size(); at += 4) made->step(std::span(rays).subspan(at, 4));
    tree_seconds.push_back(made->tree_seconds);
  }
  const Cut& cut = *made;
  const double overhead = 2 * effort.edit_steps * median([] {
                            std::vector<double> empty;
                            for (int i = 0; i < 101; ++i) empty.push_back(seconds_of([] {}));
                            return empty;
                          }());
  const double seconds = median(tree_seconds) - overhead;
  report({"edits, per new face / limit", s.name, "ns", seconds * kNano / static_cast<double>(cut.new_faces),
          kFaceBar, 1.0});
  if (has_embree()) {
    const double rebuild = make_embree(arrays_of(cut.mesh), EmbreeQuality::kLow)->build_seconds();
    report({"edit of one step / rebuild, Embree low", s.name, "us", 1e6 * seconds / effort.edit_steps,
            1e6 * rebuild, s.mesh.live_faces() > kManyFaces ? std::optional(kRebuildBar) : std::nullopt});
  }
  const AabbTree fresh(cut.mesh);
  const auto row = [&](const char* name, std::span<const Pose> asked, double bar) {
    const Pair t = query_both(cut.tree, fresh, cut.mesh, asked, s.reach(), effort.times);
    const double count = static_cast<double>(asked.size());
    report({name, s.name, "ns/ray", t.ours * kNano / count, t.peer * kNano / count, bar});
  };
  row("all hits in the slit after a cut / rebuilt tree", rays, kSlitBar);
  row("all hits elsewhere after a cut / rebuilt tree", random_chords(s, effort.steps), kElsewhereBar);
}

}  // namespace kerf::bench
