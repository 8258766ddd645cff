#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/tree/aabb_tree.h"
#include "tests/bench/sections.h"
#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

constexpr double kSweepBar = 1.0, kChordBar = 1.1, kNearestBar = 1.2;
constexpr double kStepBar = 0.6, kStepBarManyFaces = 0.8;
constexpr uint32_t kStepManyFaces = 200000;

// Our tree asked the way a peer is.
class Queries {
 public:
  explicit Queries(const Subject& s) : subject_(s), tree_(s.mesh) {}

  size_t all_hits(std::span<const Pose> rays) {
    size_t hits = 0;
    for (const Pose& ray : rays) {
      found_[0].clear();
      tree_.crossings(subject_.mesh, ray, {0, subject_.reach()}, found_[0]);
      hits += found_[0].size();
    }
    return hits;
  }
  size_t all_hits_of_steps(std::span<const Pose> rays) {
    size_t hits = 0;
    for (size_t i = 0; i < rays.size(); i += 4) {
      for (auto& list : found_) list.clear();
      tree_.crossings(subject_.mesh, rays.subspan(i, 4), {0, subject_.reach()}, found_);
      for (const auto& list : found_) hits += list.size();
    }
    return hits;
  }
  size_t nearest_hits(std::span<const Pose> rays) {
    size_t hits = 0;
    for (const Pose& ray : rays) hits += tree_.nearest(subject_.mesh, ray, {0, subject_.reach()}).has_value();
    return hits;
  }
  size_t touched(std::span<const SweptCylinder> beams) {
    size_t faces = 0;
    for (const SweptCylinder& beam : beams) {
      touched_.clear();
      tree_.touched(subject_.mesh, beam, touched_);
      faces += touched_.size();
    }
    return faces;
  }

 private:
  const Subject& subject_;
  AabbTree tree_;
  std::vector<RayHit> found_[4];
  std::vector<FaceId> touched_;
};

// The beam that sweeps over each step to the next.
std::vector<SweptCylinder> beams_of(const Subject& s, std::span<const Pose> rays) {
  std::vector<SweptCylinder> beams;
  for (size_t i = 0; i + 4 < rays.size(); i += 4) {
    const auto middle = [&](size_t at) {
      return Pose{0.5 * (rays[at].origin + rays[at + 3].origin), rays[at].direction};
    };
    beams.emplace_back(middle(i), middle(i + 4), s.steps_apart() / 2, Interval{0, s.reach()});
  }
  return beams;
}

class QueryBench {
 public:
  QueryBench(const Subject& s, const Effort& effort, const Report& report)
      : subject_(s),
        effort_(effort),
        report_(report),
        queries_(s),
        sweep_(sweep_rays(s, effort.steps)),
        chords_(random_chords(s, 4 * effort.steps)),
        beams_(beams_of(s, sweep_)) {}

  void against(Peer& peer, const std::string& name, bool bars) {
    const double reach = subject_.reach();
    const auto bar = [&](double value) { return bars ? std::optional(value) : std::nullopt; };
    compare(
        "all hits, sweep", name, sweep_, bar(kSweepBar), [&] { return queries_.all_hits(sweep_); },
        [&] { return peer.all_hits(sweep_, reach); });
    compare(
        "all hits, random rays", name, chords_, bar(kChordBar), [&] { return queries_.all_hits(chords_); },
        [&] { return peer.all_hits(chords_, reach); });
    compare(
        "nearest hit, sweep", name, sweep_, bar(kNearestBar), [&] { return queries_.nearest_hits(sweep_); },
        [&] { return peer.nearest_hits(sweep_, reach); });
    compare(
        "nearest hit, random rays", name, chords_, bar(kNearestBar),
        [&] { return queries_.nearest_hits(chords_); }, [&] { return peer.nearest_hits(chords_, reach); });
    const bool many = subject_.mesh.live_faces() > kStepManyFaces;
    compare(
        "four parallel rays in one traversal", name, sweep_, bar(many ? kStepBarManyFaces : kStepBar),
        [&] { return queries_.all_hits_of_steps(sweep_); }, [&] { return peer.all_hits(sweep_, reach); });
  }

  // What a face found costs, beside the four rays of its step.
  void touched_against(Peer& peer, const std::string& name) {
    size_t faces = 0;
    const Pair t = in_turn(
        effort_.times, [&] { faces = queries_.touched(beams_); },
        [&] { peer.all_hits(sweep_, subject_.reach()); });
    report_({"faces touched by the beam, per face found / four rays, " + name, subject_.name, "ns",
             t.ours * kNano / static_cast<double>(std::max<size_t>(1, faces)), t.peer * kNano / effort_.steps,
             std::nullopt});
  }

 private:
  template <typename Ours, typename Theirs>
  void compare(const std::string& what, const std::string& peer, const std::vector<Pose>& rays,
               std::optional<double> bar, Ours ours, Theirs theirs) {
    size_t our_hits = 0, their_hits = 0;
    const Pair t = in_turn(
        effort_.times, [&] { our_hits = ours(); }, [&] { their_hits = theirs(); });
    const double count = static_cast<double>(rays.size());
    report_(
        {what + " / " + peer, subject_.name, "ns/ray", t.ours * kNano / count, t.peer * kNano / count, bar});
    const double differ = std::abs(static_cast<double>(our_hits) - static_cast<double>(their_hits));
    if (differ > 0.001 * static_cast<double>(our_hits) + 8)
      std::printf("  note: %zu hits, the peer has %zu\n", our_hits, their_hits);
  }

  const Subject& subject_;
  const Effort& effort_;
  const Report& report_;
  Queries queries_;
  std::vector<Pose> sweep_, chords_;
  std::vector<SweptCylinder> beams_;
};

}  // namespace

void bench_queries(const Subject& s, const Effort& effort, const Report& report) {
  QueryBench bench(s, effort, report);
  if (has_embree()) {
    const auto medium = make_embree(s.arrays, EmbreeQuality::kMedium);
    bench.against(*medium, "Embree medium", true);
    bench.touched_against(*medium, "Embree medium");
    bench.against(*make_embree(s.arrays, EmbreeQuality::kMediumRobust), "Embree medium, robust", false);
  }
  if (has_cgal()) bench.against(*make_cgal(s.arrays), "CGAL", false);
}

}  // namespace kerf::bench
