#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/document/document.h"
#include "core/world/state_hash.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/real_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

constexpr double kDegree = 3.14159265358979 / 180;

CutSettings smooth_settings(double radius, double target_edge) {
  CutSettings settings;
  settings.laser.radius = radius;
  settings.laser.range = {0, 100};
  settings.resolution.target_edge = target_edge;
  settings.rim = Rim::kSmooth;
  return settings;
}

void draw(Document& document, const CutSettings& settings, const std::vector<Pose>& poses, size_t steps = 1) {
  document.apply(BeginStroke{settings, poses[0]});
  for (size_t i = 1; i < poses.size(); ++i) document.apply(MoveStroke{poses[i]});
  document.apply(EndStroke{});
  const size_t moves = document.waiting();
  for (size_t i = 0; i < steps; ++i) {
    ASSERT_TRUE(document.step(moves * (i + 1) / steps - moves * i / steps).ok());
  }
  ASSERT_EQ(document.waiting(), 0u);
}

double live_area(const Mesh& mesh) {
  double area = 0;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f))) area += triangle_area(mesh.triangle(FaceId(f)));
  }
  return area;
}

Vec3 unit_normal(const Triangle& t) { return glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0])); }

// What beams have swept, asked the slow way: every part for every point.
class Swept {
 public:
  void add(const CutSettings& settings, const std::vector<Pose>& poses, double reach) {
    for (size_t i = 0; i < poses.size(); ++i) {
      for (const BeamMove& m : walk(poses[i > 0 ? i - 1 : 0], poses[i], settings.laser.radius / 4, reach)) {
        parts_.emplace_back(m.from, m.to, settings.laser.radius, settings.laser.range);
      }
    }
  }
  double distance(const Vec3& p) const {
    double least = 1e300;
    for (const SweptCylinder& part : parts_) least = std::min(least, part.signed_distance(p));
    return least;
  }

 private:
  std::vector<SweptCylinder> parts_;
};

struct RimNumbers {
  double farthest = 0;        // of a point of a rim edge from the boundary, over the radius
  double deepest = 0;         // of the middle of a face that is left, inside the beam, over the radius
  double smallest_angle = 4;  // of a face with a corner on the rim, radians
  double largest_turn = 0;    // of a normal against its base face, radians
  size_t rim_edges = 0;
};

// Of a body that was cut; `base` is its mesh as loaded. Edges of one face that lie on none of the base are
// rim.
RimNumbers rim_numbers(const Mesh& mesh, const Mesh& base, const Swept& swept, double radius) {
  RimNumbers n;
  std::vector<Mesh::Side> sides;
  std::vector<bool> base_rim(base.face_slots());
  for (uint32_t f = 0; f < base.face_slots(); ++f) {
    const auto c = base.corners(FaceId(f));
    for (int i = 0; i < 3; ++i) {
      sides.clear();
      base.append_edge_sides(FaceId(f), c[i], c[(i + 1) % 3], sides);
      if (sides.empty()) base_rim[f] = true;
    }
  }
  const auto on_base_rim = [&](FaceId b, const Vec3& p, const Vec3& q) {
    if (!base_rim[b.index]) return false;
    const Triangle t = base.triangle(b);
    for (int i = 0; i < 3; ++i) {
      const Vec3 e = glm::normalize(t[(i + 1) % 3] - t[i]);
      const double off = std::max(glm::length(glm::cross(p - t[i], e)), glm::length(glm::cross(q - t[i], e)));
      if (off < 0.002 * radius) return true;
    }
    return false;
  };
  for (uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const FaceId f(i);
    if (!mesh.is_live(f)) continue;
    const Triangle t = mesh.triangle(f);
    const auto c = mesh.corners(f);
    const FaceId b = mesh.data(f).base;
    const Triangle base_t = base.triangle(b);
    n.largest_turn =
        std::max(n.largest_turn, std::acos(std::min(1.0, glm::dot(unit_normal(t), unit_normal(base_t)))));
    bool on_rim = false;
    for (int k = 0; k < 3; ++k) on_rim = on_rim || std::abs(swept.distance(t[k])) < 0.01 * radius;
    if (on_rim && std::acos(largest_cosine(t)) < 3 * kDegree && std::getenv("DBG")) {
      std::cout << "   face " << i << " angle " << std::acos(largest_cosine(t)) / kDegree << " h " << int(mesh.data(f).halvings);
      for (int k = 0; k < 3; ++k) std::cout << " d " << swept.distance(t[k]) / radius << " e " << glm::length(t[(k + 1) % 3] - t[k]) / radius;
      std::cout << "\n";
    }
    if (on_rim) n.smallest_angle = std::min(n.smallest_angle, std::acos(largest_cosine(t)));
    n.deepest = std::max(n.deepest, -swept.distance((t[0] + t[1] + t[2]) / 3.0) / radius);
    for (int k = 0; k < 3; ++k) {
      sides.clear();
      mesh.append_edge_sides(f, c[k], c[(k + 1) % 3], sides);
      if (!sides.empty() || on_base_rim(b, t[k], t[(k + 1) % 3])) continue;
      ++n.rim_edges;
      for (int s = 0; s <= 10; ++s) {
        const double d = std::abs(swept.distance(t[k] + 0.1 * s * (t[(k + 1) % 3] - t[k])));
        n.farthest = std::max(n.farthest, d / radius);
        if (d / radius > 0.01 && std::getenv("DBG")) std::cout << "    far " << d / radius << " at " << (t[k] + 0.1 * s * (t[(k + 1) % 3] - t[k])).x << " " <<  (t[k] + 0.1 * s * (t[(k + 1) % 3] - t[k])).z << " edge " << glm::length(t[(k + 1) % 3] - t[k]) / radius << " ends " << swept.distance(t[k]) / radius << " " << swept.distance(t[(k+1)%3]) / radius << " r " << radius <<"\n";
      }
    }
  }
  return n;
}

std::ostream& operator<<(std::ostream& out, const RimNumbers& n) {
  return out << "rim edges " << n.rim_edges << ", farthest " << n.farthest << " r, deepest " << n.deepest
             << " r, smallest angle " << n.smallest_angle / kDegree << ", largest turn "
             << n.largest_turn / kDegree;
}

std::vector<Pose> random_poses(Random& random, double size, bool tilt, int count) {
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i) {
    Vec3 direction(0, -1, 0);
    if (tilt)
      direction = glm::normalize(direction + Vec3(random.uniform(-0.4, 0.4), 0, random.uniform(-0.4, 0.4)));
    const Vec3 at(random.uniform(-0.35, 0.35) * size, 0, random.uniform(-0.35, 0.35) * size);
    poses.push_back({at - direction, direction});
  }
  return poses;
}

TEST(SmoothRim, explore) {
  for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
    for (int kind = 0; kind < 4; ++kind) {
      RimNumbers worst;
      double least_ratio = 9, most_ratio = 0;
      for (uint64_t seed = 1; seed <= 30; ++seed) {
        Random random(seed);
        const double size = random.uniform(0.8, 2), r = random.uniform(0.012, 0.035);
        CutSettings settings = smooth_settings(r, r / 4);
        settings.resolution.scheme = scheme;
        const auto poses = random_poses(random, size, kind == 1, kind == 2 ? 5 : kind == 3 ? 1 : 2);
        World world = world_of(plate(size));
        const Mesh base = only_body(world).mesh;
        Document document(std::move(world));
        draw(document, settings, poses);
        Swept swept;
        swept.add(settings, poses, 3);
        const Body& body = document.world().body(document.world().ids()[0]);
        EXPECT_EQ(find_fault(body.mesh), "") << seed;
        const RimNumbers n = rim_numbers(body.mesh, base, swept, r);
        if (kind == 0 || kind == 3) {
          const double length = poses.size() > 1 ? glm::length(poses[1].origin - poses[0].origin) : 0;
          const double ratio =
              (size * size - live_area(body.mesh)) / (2 * r * length + 3.14159265358979 * r * r);
          least_ratio = std::min(least_ratio, ratio);
          most_ratio = std::max(most_ratio, ratio);
        }
        if (n.smallest_angle < 3 * kDegree || n.farthest > 0.01)
          std::cout << "  seed " << seed << ": " << n << "\n";
        worst.rim_edges += n.rim_edges;
        worst.farthest = std::max(worst.farthest, n.farthest);
        worst.deepest = std::max(worst.deepest, n.deepest);
        worst.smallest_angle = std::min(worst.smallest_angle, n.smallest_angle);
        worst.largest_turn = std::max(worst.largest_turn, n.largest_turn);
      }
      std::cout << "scheme " << int(scheme) << " kind " << kind << ": " << worst << " area " << least_ratio
                << " " << most_ratio << "\n";
    }
  }
}

}  // namespace
}  // namespace kerf::test
