#include "core/tree/aabb_tree.h"
#include "tests/bench/sections.h"
#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

constexpr double kBuildBar = 1.5;  // of Embree's medium quality
constexpr double kBytesBar = 90;   // a face

struct Builds {
  std::vector<double> ours, medium, robust, cgal;
  double embree_bytes = 0;
};

Builds build_in_turn(const Subject& s, int times) {
  Builds b;
  for (int i = 0; i < times; ++i) {
    b.ours.push_back(seconds_of([&] { const AabbTree tree(s.mesh); }));
    if (!has_embree()) continue;
    const auto medium = make_embree(s.arrays, EmbreeQuality::kMedium);
    b.medium.push_back(medium->build_seconds());
    b.embree_bytes = medium->bytes();
    b.robust.push_back(make_embree(s.arrays, EmbreeQuality::kMediumRobust)->build_seconds());
    if (has_cgal()) b.cgal.push_back(make_cgal(s.arrays)->build_seconds());
  }
  return b;
}

}  // namespace

void bench_build(const Subject& s, const Effort& effort, const Report& report) {
  const double faces = s.mesh.live_faces();
  const double bytes = static_cast<double>(AabbTree(s.mesh).bytes()) / faces;
  const Builds b = build_in_turn(s, effort.build_times);
  const double ours = median(b.ours) * kNano / faces;
  const auto row = [&](const char* name, const std::vector<double>& peer, std::optional<double> bar) {
    if (!peer.empty()) report({name, s.name, "ns/face", ours, median(peer) * kNano / faces, bar});
  };
  row("build / Embree medium", b.medium, kBuildBar);
  row("build / Embree medium, robust", b.robust, std::nullopt);
  row("build / CGAL", b.cgal, std::nullopt);
  report({"memory / limit", s.name, "B/face", bytes, kBytesBar, 1.0});
  if (has_embree()) {
    report({"memory / Embree medium", s.name, "B/face", bytes, b.embree_bytes / faces, std::nullopt});
  }
}

}  // namespace kerf::bench
