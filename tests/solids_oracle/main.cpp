// Compares what straight strokes leave of generated solids with CGAL's difference of each solid and the
// volume that the beam swept: the same number of pieces, and volumes within 0.1 %. Says so line by line, and
// exits with 1 where they differ.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "core/base/deterministic_math.h"
#include "core/edit/separation.h"
#include "core/mesh/measures.h"
#include "tests/solids_oracle/cgal_difference.h"
#include "tests/support/solids.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// The volume that a beam sweeps on a straight move: a stadium along its direction.
Soup stadium_prism(const SolidStroke& stroke) {
  constexpr int kHalf = 180;  // edges of half a circle
  const Laser& laser = stroke.settings.laser;
  const Pose &from = stroke.poses.front(), &to = stroke.poses.back();
  const Vec3 along = glm::normalize(to.origin - from.origin), left = glm::cross(from.direction, along);
  Soup prism;
  for (const double depth : {laser.range.low, laser.range.high}) {
    for (int i = 0; i < 2 * (kHalf + 1); ++i) {
      const bool at_end = i <= kHalf;
      const double angle = -kPi / 2 + kPi * (at_end ? i : i - 1) / kHalf;
      prism.positions.push_back((at_end ? to : from).origin + depth * from.direction +
                                laser.radius * (std::cos(angle) * along + std::sin(angle) * left));
    }
  }
  const auto count = static_cast<uint32_t>(prism.positions.size() / 2);
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t next = (i + 1) % count;
    prism.triangles.push_back({i, next, next + count});
    prism.triangles.push_back({i, next + count, i + count});
    if (i == 0 || next == 0) continue;
    prism.triangles.push_back({0, next, i});
    prism.triangles.push_back({count, count + i, count + next});
  }
  return prism;
}

// Welded, as CGAL wants it.
Soup soup_of(const Mesh& mesh) {
  Soup soup;
  for (uint32_t v = 0; v < mesh.vertex_slots(); ++v) soup.positions.push_back(mesh.position(VertexId(v)));
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    const auto c = mesh.corners(FaceId(f));
    soup.triangles.push_back({c[0].index, c[1].index, c[2].index});
  }
  return soup;
}

std::vector<double> volumes_of_parts(const Body& body) {
  std::vector<uint32_t> label;
  std::vector<std::vector<FaceId>> faces(label_components(body.mesh, label));
  for (uint32_t f = 0; f < label.size(); ++f) {
    if (body.mesh.is_live(FaceId(f))) faces[label[f]].emplace_back(f);
  }
  std::vector<double> volumes;
  for (const auto& own : faces) volumes.push_back(enclosed_volume(body.mesh, own, body.middle()).volume);
  return volumes;
}

SolidStroke random_straight_stroke(const World& world, Random& random) {
  for (;;) {
    SolidStroke stroke = random_solid_stroke(world, random);
    if (stroke.poses.size() == 2 && stroke.name != "fan" && stroke.name != "grazing") return stroke;
  }
}

// Whether both have the same volume and as many pieces, but for specks.
bool agree(const std::vector<double>& ours, const std::vector<double>& theirs, double whole) {
  const auto pieces = [&](const std::vector<double>& volumes) {
    return std::count_if(volumes.begin(), volumes.end(), [&](double v) { return v > 1e-6 * whole; });
  };
  const double a = std::accumulate(ours.begin(), ours.end(), 0.0);
  const double b = std::accumulate(theirs.begin(), theirs.end(), 0.0);
  std::printf("%zd pieces of %.9g m^3, by CGAL %zd of %.9g m^3\n", pieces(ours), a, pieces(theirs), b);
  return pieces(ours) == pieces(theirs) && std::abs(a - b) <= 1e-3 * whole;
}

int compare() {
  size_t compared = 0, differ = 0, left_open = 0;
  const std::vector<NamedSoup> solids = generated_solids();
  for (uint64_t seed = 1; compared < 40; ++seed) {
    Random random(seed);
    const auto& [name, soup] = solids[seed % solids.size()];
    SolidCut cut(world_of(soup));
    const SolidStroke stroke = random_straight_stroke(cut.document().world(), random);
    const Soup whole_soup = soup_of(cut.body().mesh);
    const std::vector<double> before = volumes_of_parts(cut.body());
    if (!cut.draw(stroke, random)) {
      ++left_open;
      continue;
    }
    ++compared;
    std::printf("%s, seed %zu, %s: ", name.c_str(), static_cast<size_t>(seed), stroke.name.c_str());
    const double whole = std::accumulate(before.begin(), before.end(), 0.0);
    differ +=
        !agree(volumes_of_parts(cut.body()), volumes_of_difference(whole_soup, stadium_prism(stroke)), whole);
  }
  std::printf("%zu of %zu differ; %zu more were left open\n", differ, compared, left_open);
  return differ > 0 || testing::Test::HasFailure() ? 1 : 0;
}

}  // namespace
}  // namespace kerf::test

int main(int count, char** arguments) {
  testing::InitGoogleTest(&count, arguments);
  return kerf::test::compare();
}
