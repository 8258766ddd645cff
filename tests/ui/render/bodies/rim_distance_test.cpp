#include "ui/render/bodies/rim_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/made_meshes.h"
#include "tests/support/runs.h"

namespace kerf {
namespace {

constexpr float kWidthOfHeat = 0.2f;

float distance_from_segment(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 along = b - a;
  const float t = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0f, 1.0f);
  return glm::distance(p, a + t * along);
}

// A square of 2 n^2 faces in y = 0, from (0, 0) to (1, 1).
Mesh square(uint32_t n) {
  Soup soup;
  for (uint32_t i = 0; i <= n; ++i) {
    for (uint32_t k = 0; k <= n; ++k) soup.positions.push_back({double(i) / n, 0, double(k) / n});
  }
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t k = 0; k < n; ++k) {
      const uint32_t a = i * (n + 1) + k, b = a + n + 1;
      soup.triangles.push_back({a, a + 1, b});
      soup.triangles.push_back({b, a + 1, b + 1});
    }
  }
  soup.faces_in_file = soup.triangles_in_file = soup.triangles.size();
  return test::build(soup).mesh;
}

// A plate of 2 n^2 faces from which tests cut, with the rims that are kept up.
class CutPlate {
 public:
  explicit CutPlate(uint32_t n)
      : mesh_(square(n)),
        frame_(FloatFrame::around({0, 0, 0}, {1, 0, 1})),
        bases_(mesh_, frame_),
        rims_(kWidthOfHeat) {}

  void remove(FaceId f) {
    for (const VertexId v : mesh_.corners(f)) changed_.push_back(v);
    mesh_.remove_face(f);
  }
  void split(FaceId f) {
    const auto corners = mesh_.corners(f);
    std::vector<Mesh::FaceSplit> splits;
    mesh_.split_edge(f, corners[0], corners[1], splits);
    for (const Mesh::FaceSplit& s : splits) {
      for (const FaceId part : {s.kept, s.added}) {
        for (const VertexId v : mesh_.corners(part)) changed_.push_back(v);
      }
    }
  }
  std::vector<VertexId> update() {
    std::vector<VertexId> affected;
    rims_.update(mesh_, bases_, frame_, changed_, affected);
    changed_.clear();
    return affected;
  }

  // By a search of all sides of all faces; the boundary of the plate is no rim.
  float searched(VertexId v) const {
    float least = RimDistance::kFar;
    std::vector<Mesh::Side> sides;
    for (uint32_t f = 0; f < mesh_.face_slots(); ++f) {
      if (!mesh_.is_live(FaceId(f))) continue;
      const auto corners = mesh_.corners(FaceId(f));
      for (size_t i = 0; i < 3; ++i) {
        sides.clear();
        mesh_.append_edge_sides(FaceId(f), corners[i], corners[(i + 1) % 3], sides);
        const glm::vec3 from = at(corners[i]), to = at(corners[(i + 1) % 3]);
        if (!sides.empty() || on_the_border(from, to)) continue;
        least = std::min(least, distance_from_segment(at(v), from, to) + 0.15f * glm::distance(from, to));
      }
    }
    return least;
  }

  std::vector<VertexId> vertices() const {
    std::vector<VertexId> all;
    for (uint32_t f = 0; f < mesh_.face_slots(); ++f) {
      if (!mesh_.is_live(FaceId(f))) continue;
      for (const VertexId v : mesh_.corners(FaceId(f))) all.push_back(v);
    }
    return all;
  }
  FaceId random_face(std::mt19937& random) const {
    FaceId f;
    do {
      f = FaceId(static_cast<uint32_t>(random() % mesh_.face_slots()));
    } while (!mesh_.is_live(f));
    return f;
  }
  float of(VertexId v) const { return rims_.of(v); }
  bool any() const { return rims_.any(); }

 private:
  glm::vec3 at(VertexId v) const { return frame_.to_float(mesh_.position(v)); }
  bool on_the_border(const glm::vec3& from, const glm::vec3& to) const {
    const glm::vec3 low = frame_.to_float({0, 0, 0}), high = frame_.to_float({1, 0, 1});
    for (const int axis : {0, 2}) {
      for (const float border : {low[axis], high[axis]}) {
        if (from[axis] == border && to[axis] == border) return true;
      }
    }
    return false;
  }

  Mesh mesh_;
  FloatFrame frame_;
  BaseFaces bases_;
  RimDistance rims_;
  std::vector<VertexId> changed_;
};

TEST(RimDistance, the_boundary_of_a_loaded_mesh_is_no_rim) {
  CutPlate plate(4);
  plate.split(FaceId(0));
  plate.split(FaceId(7));
  plate.update();
  EXPECT_FALSE(plate.any());
  for (const VertexId v : plate.vertices()) EXPECT_EQ(plate.of(v), RimDistance::kFar);
}

// A vertex learns of a rim from its neighbours, so that it may miss the nearest side by a little.
TEST(RimDistance, matches_brute_force_after_any_splits_and_removals) {
  for (uint64_t seed = 1; seed <= runs(20); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(static_cast<uint32_t>(seed));
    CutPlate plate(16);
    for (int step = 0; step < 12; ++step) {
      for (int i = 0; i < 10; ++i) plate.split(plate.random_face(random));
      for (int i = 0; i < 3; ++i) plate.remove(plate.random_face(random));
      plate.update();
    }
    for (const VertexId v : plate.vertices()) {
      const float expected = plate.searched(v);
      if (expected > 0.8f * kWidthOfHeat) {
        EXPECT_GT(plate.of(v), 0.79f * kWidthOfHeat);
      } else {
        EXPECT_GE(plate.of(v), expected * 0.999f);
        EXPECT_LE(plate.of(v), expected + 0.2f * kWidthOfHeat);
      }
    }
  }
}

}  // namespace
}  // namespace kerf
