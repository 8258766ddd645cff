#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "core/cut/rim_stages_internal.h"
#include "core/document/document.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/real_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

constexpr double kDegree = 3.14159265358979 / 180;

CutSettings smooth_settings(double radius, double target_edge) {
  CutSettings settings;
  settings.laser.radius = radius;
  settings.laser.range = {0, 100};
  settings.resolution.target_edge = target_edge;
  settings.resolution.rim = Rim::kSmooth;
  return settings;
}

void draw(Document& document, const CutSettings& settings, const std::vector<Pose>& poses, size_t steps = 1) {
  document.apply(BeginStroke{settings, poses[0]});
  for (size_t i = 1; i < poses.size(); ++i) document.apply(MoveBeam{poses[i]});
  document.apply(EndStroke{});
  const size_t moves = document.waiting();
  for (size_t i = 0; i < steps; ++i) {
    ASSERT_TRUE(run_moves(document, moves * (i + 1) / steps - moves * i / steps).ok());
  }
  ASSERT_FALSE(document.queue().pending().next_move(document.world()).has_value());
  while (document.waiting() > 0) ASSERT_TRUE(document.step(1).ok());
}

Vec3 unit_normal(const Triangle& t) { return glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0])); }

// What beams have swept, asked the slow way: every part for every point.
class Swept {
 public:
  void add(const CutSettings& settings, const std::vector<Pose>& poses, double reach) {
    for (size_t i = 0; i < poses.size(); ++i) {
      for (const BeamMove& m :
           subdivide({poses[i > 0 ? i - 1 : 0], poses[i]}, settings.laser.radius / 4, reach)) {
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

// Cuts a soup with smooth rims along each list of poses in turn and looks at all that is left.
RimNumbers cut_smoothly(const Soup& soup, const CutSettings& settings,
                        const std::vector<std::vector<Pose>>& strokes, double* area_lost = nullptr) {
  World world = world_of(soup);
  const Mesh base = only_body(world).mesh;
  Document document(std::move(world));
  Swept swept;
  for (const auto& poses : strokes) {
    draw(document, settings, poses);
    swept.add(settings, poses, 3);
  }
  const Body& body = document.world().body(document.world().ids()[0]);
  EXPECT_EQ(find_fault(body.mesh), "");
  EXPECT_EQ(body.tree.leaf_count(), body.mesh.live_faces());
  if (area_lost != nullptr) *area_lost = live_area(base) - live_area(body.mesh);
  return rim_numbers(body.mesh, base, swept, settings.laser.radius);
}

void expect_smooth(const RimNumbers& n, double smallest_angle) {
  EXPECT_GT(n.rim_edges, 20u);
  EXPECT_LE(n.farthest, 0.01) << n;
  EXPECT_LE(n.deepest, 0.01) << n;
  EXPECT_LE(n.largest_turn, 3 * kDegree) << n;
  EXPECT_GE(n.smallest_angle, smallest_angle * kDegree) << n;
}

// A random radius, finest edge r/4, a scheme by turns.
CutSettings settings_for(uint64_t seed, Random& random) {
  const double r = random.uniform(0.012, 0.035);
  CutSettings settings = smooth_settings(r, r / 4);
  settings.resolution.scheme = seed % 2 == 0 ? Scheme::kLongestEdge : Scheme::kOneToFour;
  return settings;
}

TEST(SmoothRim, follows_the_beam_boundary_for_straight_and_point_strokes_on_plates) {
  for (uint64_t seed = 1; seed <= runs(24); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double size = random.uniform(0.8, 2);
    const CutSettings settings = settings_for(seed, random);
    const auto poses = random_poses(random, size, false, seed % 3 == 0 ? 1 : 2);
    const double r = settings.laser.radius, length = glm::length(poses.back().origin - poses[0].origin);
    double lost = 0;
    expect_smooth(cut_smoothly(plate(size), settings, {poses}, &lost), 3);
    const double ratio = lost / (2 * r * length + 3.14159265358979 * r * r);
    EXPECT_GE(ratio, 0.998);
    EXPECT_LE(ratio, 1.002);
  }
}

TEST(SmoothRim, follows_the_beam_boundary_for_tilted_strokes_and_across_old_slits) {
  for (uint64_t seed = 1; seed <= runs(16); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const CutSettings settings = settings_for(seed, random);
    expect_smooth(cut_smoothly(plate(1), settings, {random_poses(random, 1, true, 2)}), 3);
    expect_smooth(cut_smoothly(plate(1), settings, {random_poses(random, 1, false, 4)}), 3);
    expect_smooth(cut_smoothly(plate(1), settings,
                               {random_poses(random, 1, false, 2), random_poses(random, 1, false, 2)}),
                  3);
  }
}

TEST(SmoothRim, follows_the_beam_boundary_where_a_plunging_beam_ends_on_the_surface) {
  const Vec3 down(0, -1, 0);
  expect_smooth(cut_smoothly(plate(1), smooth_settings(0.03, 0.0075),
                             {{{{0.013, 1, 0.02}, down}, {{0.013, 0, 0.02}, down}}}),
                3);
}

TEST(SmoothRim, preserves_the_area_fraction_of_each_base_face) {
  for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
    CutSettings settings = smooth_settings(0.02, 0.005);
    settings.resolution.scheme = scheme;
    Document document(world_of(plate(1)));
    draw(document, settings, {{{-0.3, 1, 0.1}, {0, -1, 0}}, {{0.3, 1, 0.13}, {0, -1, 0}}});
    const Mesh& mesh = document.world().body(document.world().ids()[0]).mesh;
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (!mesh.is_live(FaceId(f))) continue;
      const double halvings = std::log2(0.5 / triangle_area(mesh.triangle(FaceId(f))));
      EXPECT_NEAR(mesh.data(FaceId(f)).halvings, halvings, 1.6);
    }
  }
}

TEST(SmoothRim, follows_mesh_edges_that_coincide_with_its_boundary) {
  for (const double off : {0.0, 1.0, -1.0}) {
    SCOPED_TRACE(off);
    const CutSettings settings = smooth_settings(0.02, 0.005);
    const double z = -0.125 + off * settings.laser.radius;
    expect_smooth(
        cut_smoothly(grid(8, 1), settings, {{{{-0.3, 1, z}, {0, -1, 0}}, {{0.3, 1, z}, {0, -1, 0}}}}), 3);
  }
}

TEST(SmoothRim, is_smooth_even_with_unrefined_faces) {
  for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
    CutSettings settings = smooth_settings(0.02, 0);
    settings.resolution = {
        .scheme = scheme, .rule = Resolution::Rule::kDepth, .depth = 0, .rim = Rim::kSmooth};
    expect_smooth(
        cut_smoothly(plate(1), settings, {{{{-0.3, 1, 0.1}, {0, -1, 0}}, {{0.3, 1, 0.13}, {0, -1, 0}}}}), 2);
  }
}

double distance_to_triangle(const Vec3& p, const Triangle& t) {
  const Vec3 n = unit_normal(t);
  const double height = glm::dot(p - t[0], n);
  const Vec3 foot = p - height * n;
  bool in = true;
  double edge = 1e300;
  for (int i = 0; i < 3; ++i) {
    const Vec3 a = t[i], e = t[(i + 1) % 3] - a;
    in = in && glm::dot(glm::cross(e, foot - a), n) >= 0;
    const double s = std::clamp(glm::dot(p - a, e) / glm::dot(e, e), 0.0, 1.0);
    edge = std::min(edge, glm::length(p - (a + s * e)));
  }
  return in ? std::abs(height) : edge;
}

double distance_to_surface(const Vec3& p, const Mesh& mesh) {
  double least = 1e300;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f)
    least = std::min(least, distance_to_triangle(p, mesh.triangle(FaceId(f))));
  return least;
}

TEST(SmoothRim, stays_on_the_original_surface_of_curved_meshes) {
  for (const Soup& soup : {sphere(12, 16, 0.5), sphere(40, 50, 0.5), torus(24, 16, 0.4, 0.15)}) {
    for (uint64_t seed = 1; seed <= runs(4); ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Random random(seed);
      const CutSettings settings = settings_for(seed, random);
      const double r = settings.laser.radius;
      World world = world_of(soup);
      const Mesh base = only_body(world).mesh;
      Document document(std::move(world));
      draw(document, settings, random_poses(random, 0.8, seed % 2 == 0, 2));
      const Mesh& mesh = document.world().body(document.world().ids()[0]).mesh;
      EXPECT_EQ(find_fault(mesh), "");
      std::vector<Mesh::Side> sides;
      double farthest = 0;
      for (uint32_t i = 0; i < mesh.face_slots(); ++i) {
        const FaceId f(i);
        if (!mesh.is_live(f)) continue;
        const auto c = mesh.corners(f);
        for (int k = 0; k < 3; ++k) {
          sides.clear();
          mesh.append_edge_sides(f, c[k], c[(k + 1) % 3], sides);
          if (!sides.empty()) continue;
          const Vec3 middle = 0.5 * (mesh.position(c[k]) + mesh.position(c[(k + 1) % 3]));
          farthest = std::max(farthest, distance_to_surface(middle, base));
        }
      }
      EXPECT_LE(farthest, 0.005 * r);
    }
  }
}

// Asks the tree for every corner of every face.
void expect_tree_finds_every_face(const Body& cut) {
  AabbTree tree = cut.tree;
  std::vector<FaceId> found;
  for (uint32_t f = 0; f < cut.mesh.face_slots(); ++f) {
    if (!cut.mesh.is_live(FaceId(f))) continue;
    for (const Vec3& p : cut.mesh.triangle(FaceId(f))) {
      const Pose down{p + Vec3(0, 1, 0), {0, -1, 0}};
      found.clear();
      tree.touched(cut.mesh, SweptCylinder(down, down, 1e-6, {0, 2}), found);
      ASSERT_NE(std::find(found.begin(), found.end(), FaceId(f)), found.end()) << "face " << f;
    }
  }
}

// The work asks whether to go on, and is stopped once at each of those places.
TEST(SmoothRim, leaves_a_valid_mesh_and_tree_when_interrupted) {
  for (uint64_t seed = 1; seed <= runs(24); ++seed) {
    for (int answers = 1;; ++answers) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", answers " + std::to_string(answers));
      Random random(seed);
      const CutSettings settings = settings_for(seed, random);
      const auto poses = random_poses(random, 1, false, 2);
      Document document(world_of(plate(1)));
      document.apply(BeginStroke{settings, poses[0]});
      document.apply(MoveBeam{poses[1]});
      document.apply(EndStroke{});
      ASSERT_TRUE(run_moves(document, document.waiting() - 1).ok());
      int left = answers;
      const Progress stop{[&](double) { return left-- > 0; }};
      if (document.step(1, &stop).ok()) break;
      const Body& body = document.world().body(document.world().ids()[0]);
      EXPECT_EQ(find_fault(body.mesh), "");
      expect_tree_finds_every_face(body);
    }
  }
}

TEST(SmoothRim, fails_if_it_would_create_too_many_faces) {
  CutSettings settings = smooth_settings(0.03, 0.0075);
  const BeamMove stroke{{{-0.2, 1, 0}, {0, -1, 0}}, {{0.2, 1, 0.05}, {0, -1, 0}}};
  World world = world_of(plate(1));
  ASSERT_TRUE(cut_whole(world, settings, subdivide(stroke, settings.laser.radius, 2)).ok());
  settings.faces_per_step = 1;
  size_t max_faces = 0;
  World closed = world;
  UnfinishedRim unfinished;
  do {
    ASSERT_TRUE(rim_step(closed, settings, {&stroke, 1}, {}, unfinished).ok());
    max_faces = std::max<size_t>(max_faces, only_body(closed).mesh.live_faces());
  } while (unfinished.begun());
  for (const size_t fewer : {size_t{0}, size_t{1}}) {
    World limited = world;
    settings.max_faces = max_faces - fewer;
    EXPECT_EQ(close_rim(limited, settings, {&stroke, 1}).ok(), fewer == 0);
    EXPECT_EQ(find_fault(only_body(limited).mesh), "");
  }
}

TEST(SmoothRim, is_the_same_in_1_10_and_1000_steps) {
  for (uint64_t seed = 1; seed <= runs(4); ++seed) {
    uint64_t hash = 0;
    for (const size_t steps : {size_t{1}, size_t{10}, size_t{1000}}) {
      Random random(seed);
      const CutSettings settings = settings_for(seed, random);
      Document document(world_of(seed % 2 == 0 ? plate(1) : sphere(20, 24, 0.5)));
      draw(document, settings, random_poses(random, 1, seed > 2, 2), steps);
      if (steps == 1) hash = state_hash(document.world());
      EXPECT_EQ(state_hash(document.world()), hash) << "seed " << seed << ", steps " << steps;
    }
  }
}

struct Redrawn {
  uint32_t faces = 0;
  double area = 0;
};
Redrawn draw_in_parts(CutSettings settings, const Pose& from, const Pose& to, int parts) {
  std::vector<Pose> poses;
  for (int i = 0; i <= parts; ++i) {
    const double s = static_cast<double>(i) / parts;
    poses.push_back({from.origin + s * (to.origin - from.origin),
                     from.direction == to.direction
                         ? from.direction
                         : glm::normalize(from.direction + s * (to.direction - from.direction))});
  }
  Document document(world_of(plate(1)));
  draw(document, settings, poses);
  const Body& body = document.world().body(document.world().ids()[0]);
  return {body.mesh.live_faces(), live_area(body.mesh)};
}

TEST(Strokes, give_the_same_result_at_any_drawing_speed) {
  for (const Rim rim : {Rim::kFaces, Rim::kSmooth}) {
    for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
      CutSettings settings = smooth_settings(0.02, 0.005);
      settings.resolution.rim = rim;
      settings.resolution.scheme = scheme;
      const Pose a{{-0.3, 1, 0.013}, {0, -1, 0}}, b{{0.31, 1, 0.057}, {0, -1, 0}};
      const Pose tilted{{0.31, 1, 0.057}, glm::normalize(Vec3(0.2, -1, 0.1))};
      const Redrawn straight = draw_in_parts(settings, a, b, 1),
                    tilting = draw_in_parts(settings, a, tilted, 1);
      for (const int parts : {7, 64}) {
        const Redrawn again = draw_in_parts(settings, a, b, parts);
        EXPECT_EQ(again.faces, straight.faces);
        EXPECT_NEAR(again.area, straight.area, 1e-9);
        EXPECT_NEAR(1 - draw_in_parts(settings, a, tilted, parts).area, 1 - tilting.area,
                    0.01 * (1 - tilting.area));
      }
    }
  }
}

// Rim faces of CAD meshes, whose base faces are thin beyond any bound of ours: none is flipped or without
// area, and the rim is as true as elsewhere.
TEST(SmoothRim, is_conforming_and_accurate_on_real_meshes) {
  const auto files = real_meshes(6000);
  if (files.empty()) GTEST_SKIP() << kNoRealMeshes;
  uint64_t seed = 50;
  for (const auto& file : files) {
    SCOPED_TRACE(file.string() + ", seed " + std::to_string(++seed));
    World world = world_of_file(file);
    const Mesh base = only_body(world).mesh;
    Random random(seed);
    RandomStroke stroke = random_stroke(world, random, 0.012, false);
    stroke.settings.resolution.rim = Rim::kSmooth;
    stroke.settings.resolution.target_edge = stroke.settings.laser.radius;
    stroke.settings.max_faces = 200'000;
    Document document(std::move(world));
    document.apply(BeginStroke{stroke.settings, stroke.moves.front().from});
    document.apply(MoveBeam{stroke.moves[stroke.moves.size() / 4].to});
    document.apply(EndStroke{});
    if (!run_all(document).ok()) continue;  // as many faces as that would take long to look at
    const Mesh& mesh = document.world().body(document.world().ids()[0]).mesh;
    ASSERT_EQ(find_fault(mesh, true), "");
    for (uint32_t i = 0; i < mesh.face_slots(); ++i) {
      if (!mesh.is_live(FaceId(i))) continue;
      const Triangle t = mesh.triangle(FaceId(i)), b = base.triangle(mesh.data(FaceId(i)).base);
      const Vec3 n = glm::cross(t[1] - t[0], t[2] - t[0]), m = glm::cross(b[1] - b[0], b[2] - b[0]);
      const bool thin = largest_cosine(b) > 1 - 1e-9;
      if (!thin) ASSERT_GT(glm::dot(n, m), 0) << "face " << i;
    }
  }
}

TEST(SmoothRim, measures_the_smallest_angle_of_all_faces_created) {
  World world = world_of(plate(1));
  const CutSettings settings = smooth_settings(0.02, 0.005);
  const BeamMove move{{{-0.3, 1, 0.1}, {0, -1, 0}}, {{0.3, 1, 0.13}, {0, -1, 0}}};
  ASSERT_TRUE(cut_whole(world, settings, {&move, 1}).ok());
  const Progress unfinished{[](double done) {
    EXPECT_LT(done, 1);
    return true;
  }};
  const Result<StepResult> closed = close_rim(world, settings, {&move, 1}, {}, &unfinished);
  ASSERT_TRUE(closed.ok());
  double largest = -1;
  for (const BodyDelta& body : closed->delta.bodies) {
    for (const FaceId f : body.added)
      largest = std::max(largest, largest_cosine(world.body(body.body).mesh.triangle(f)));
  }
  EXPECT_GT(largest, 0.5);
  EXPECT_EQ(closed->statistics.largest_cosine, largest);
}

TEST(SmoothRim, moves_the_nearest_vertices_first) {
  CutSettings settings = smooth_settings(0.03, 0.0075);
  const BeamMove stroke{{{-0.2, 1, 0}, {0, -1, 0}}, {{0.2, 1, 0.05}, {0, -1, 0}}};
  World world = world_of(plate(1));
  ASSERT_TRUE(cut_whole(world, settings, subdivide(stroke, settings.laser.radius, 2)).ok());
  settings.faces_per_step = 1;
  UnfinishedRim unfinished;
  size_t waiting = 0;
  do {
    ASSERT_TRUE(rim_step(world, settings, {&stroke, 1}, {}, unfinished).ok());
    waiting = std::max(waiting, unfinished.snaps.size());
    EXPECT_TRUE(std::ranges::is_heap(unfinished.snaps, std::greater<>(), &RimSnap::share));
  } while (unfinished.begun());
  EXPECT_GT(waiting, 10u);
}

// The beam goes along z, over both borders, and nearly covers the two columns of cells beside x = 0.
TEST(SmoothRim, slides_vertices_at_the_border_of_a_sheet_along_it) {
  World world = world_of(grid(8, 1));
  const CutSettings settings = smooth_settings(0.12, 1);
  const BeamMove stroke{{{0, 1, -2}, {0, -1, 0}}, {{0, 1, 2}, {0, -1, 0}}};
  ASSERT_TRUE(cut_whole(world, settings, {&stroke, 1}).ok());
  ASSERT_TRUE(close_rim(world, settings, {&stroke, 1}).ok());
  const Mesh& mesh = only_body(world).mesh;
  EXPECT_NEAR(live_area(mesh), 1 - 0.24, 1e-9);
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    for (const Vec3& p : mesh.triangle(FaceId(f))) {
      if (std::abs(p.x) < 0.13) EXPECT_NEAR(std::abs(p.x), 0.12, 1e-9) << "at z = " << p.z;
    }
  }
}

// A triangle whose corners lie on the boundary, far from the origin: the beam goes over it, or around it.
TEST(RimState, judges_a_face_with_all_corners_on_the_boundary_by_its_middle) {
  const Vec3 at(10, 0, 10), above(0, 5, 0), down(0, -1, 0);
  for (const bool inside : {true, false}) {
    SCOPED_TRACE(inside);
    Soup soup;
    soup.positions = {at + Vec3(0, 0, 0.5), at + Vec3(1, 0, 0.5), at + Vec3(0.5, 0, -0.5)};
    soup.triangles = {{0, 1, 2}};
    soup.triangles_in_file = soup.faces_in_file = 1;
    World world = world_of(soup);
    const CutSettings settings = smooth_settings(0.5, 1);
    BodyStep step(world.ids()[0], only_body(world));
    UnfinishedRim work;
    RimState rim(step, settings, work);
    const auto add = [&](const Vec3& from, const Vec3& to) {
      rim.region.record_near(FaceId(0), static_cast<uint32_t>(rim.region.parts()));
      rim.region.add(SweptCylinder({at + above + from, down}, {at + above + to, down}, 0.5, {0, 10}));
    };
    if (inside) {
      add({0, 0, 0}, {1, 0, 0});
    } else {
      for (const Vec3& p : {Vec3(-0.5, 0, 0.5), Vec3(1.5, 0, 0.5), Vec3(0.5, 0, -1)}) add(p, p);
    }
    EXPECT_EQ(rim.distances_of(FaceId(0)), (std::array<double, 3>{0, 0, 0}));
    EXPECT_EQ(rim.inside(FaceId(0)), inside);
  }
}

}  // namespace
}  // namespace kerf::test
