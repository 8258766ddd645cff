#include "core/document/piece_looks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <utility>

#include "core/document/document.h"
#include "core/document/extract.h"
#include "core/edit/detach.h"
#include "core/mesh/looks.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/remesh/remeshed.h"
#include "core/world/body_mass.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

// UVs and normals that are linear in the position: in one set for all faces, in the other with a seam at
// every other face.
struct LinearLooks {
  Vec3 low, size;

  explicit LinearLooks(const Soup& soup) : low(soup.positions[0]), size(0) {
    Vec3 high = low;
    for (const Vec3& p : soup.positions) low = glm::min(low, p), high = glm::max(high, p);
    size = glm::max(high - low, Vec3(1e-300));
  }
  glm::dvec2 uv(const Vec3& p) const {
    const Vec3 s = (p - low) / size;
    return {2 * s.x + 0.25 * s.y - 0.5, 1 - s.z + 0.5 * s.y};
  }
  Vec3 normal(const Vec3& p) const { return Vec3(1, 2, 3) + (p - low) / size; }
};

Soup with_looks(Soup soup) {
  const LinearLooks linear(soup);
  LookChannel<glm::vec2> plain, seams;
  for (const Vec3& p : soup.positions) {
    plain.values.emplace_back(linear.uv(p));
    soup.looks.normals.values.emplace_back(linear.normal(p));
  }
  plain.corners = soup.looks.normals.corners = soup.triangles;
  soup.looks.attributes = {{"quality", 1, {{}, soup.triangles}}};
  soup.looks.tangents.corners = soup.triangles;
  for (const Vec3& p : soup.positions) {
    soup.looks.attributes[0].channel.values.emplace_back(linear.uv(p).x, 0, 0, 0);
    soup.looks.tangents.values.emplace_back(glm::vec3(linear.normal(p)), -1);
  }
  for (uint32_t t = 0; t < soup.triangles.size(); ++t) {
    const uint32_t next = 3 * t;
    seams.corners.push_back({next, next + 1, next + 2});
    for (const uint32_t v : soup.triangles[t])
      seams.values.emplace_back(t % 2 == 0 ? linear.uv(soup.positions[v]) : -linear.uv(soup.positions[v]));
  }
  soup.looks.uv_sets = {plain, seams};
  soup.keeps_corners = true;
  return soup;
}

std::vector<FaceId> live_faces(const Mesh& mesh) {
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f))) faces.emplace_back(f);
  }
  return faces;
}

double distance_from(const Body& body, FaceId loaded, const Vec3& p) {
  const Triangle t = body.looks->triangle(loaded);
  const Vec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length = glm::length(n);
  return length > 0 ? std::abs(glm::dot(n, p - t[0])) / length : 0;
}

// The largest errors of UVs and of unit normals over all bodies of a world.
struct LooksError {
  double uv = 0, normal = 0, attribute = 0, tangent = 0;
  size_t odd_signs = 0;  // of bitangents, neither 1 nor -1
  double first_uv = 0;   // of the set without seams
  double off_plane =
      0;  // largest excess of a UV over 1e-6 and three times the distance from the loaded plane
  size_t faces = 0;
};
LooksError error_of(const World& world, const LinearLooks& linear) {
  LooksError error;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const std::vector<FaceId> faces = live_faces(body.mesh);
    const CornerLooks looks = looks_of(body, faces, LookNormals::kSmooth);
    EXPECT_EQ(looks.uv_sets.size(), 2u);
    EXPECT_EQ(looks.normals.corners.size(), faces.size());
    for (size_t i = 0; i < faces.size(); ++i) {
      const auto corners = body.mesh.corners(faces[i]);
      const FaceId source = body.loaded_face(body.mesh.data(faces[i]).base);
      const bool is_odd = body.looks->number_in_file(source) % 2 != 0;
      for (size_t k = 0; k < 3; ++k) {
        const Vec3 p = body.mesh.position(corners[k]);
        for (size_t set = 0; set < 2; ++set) {
          const glm::dvec2 uv(looks.uv_sets[set].values[looks.uv_sets[set].corners[i][k]]);
          const double sign = set == 1 && is_odd ? -1 : 1;
          const double own = glm::length(uv - sign * linear.uv(p));
          error.uv = std::max(error.uv, own);
          if (set == 0) error.first_uv = std::max(error.first_uv, own);
          error.off_plane = std::max(error.off_plane, own - 1e-6 - 3 * distance_from(body, source, p));
        }
        const Vec3 n(looks.normals.values[looks.normals.corners[i][k]]);
        const Vec3 expected = body.placement.orientation * glm::normalize(linear.normal(p));
        error.normal = std::max(error.normal, std::min(glm::length(n - expected), glm::length(n + expected)));
        const auto& quality = looks.attributes[0].channel;
        error.attribute =
            std::max(error.attribute, std::abs(quality.values[quality.corners[i][k]].x - linear.uv(p).x));
        const glm::dvec4 t(looks.tangents.values[looks.tangents.corners[i][k]]);
        error.tangent = std::max(error.tangent, glm::length(Vec3(t) - expected));
        error.odd_signs += t.w != -1 && t.w != 1;
      }
    }
    error.faces += faces.size();
  }
  return error;
}

void draw(Document& document, const RandomStroke& stroke, const CutSettings& settings) {
  document.apply(BeginStroke{settings, stroke.moves.front().from});
  document.apply(MoveBeam{stroke.moves.back().to});
  document.apply(EndStroke{});
  ASSERT_TRUE(run_all(document).ok());
}

// Every split, removal and detached piece must evaluate the loaded triangle at the same point.
TEST(PieceLooks, match_the_loaded_faces_after_every_cut) {
  uint64_t seed = 0;
  for (const NamedSoup& made : mesh_classes()) {
    for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
      Random random(++seed);
      SCOPED_TRACE(made.name + ", seed " + std::to_string(seed));
      const LinearLooks linear(made.soup);
      Document document(world_of(with_looks(made.soup)));
      const RandomStroke stroke = random_stroke(document.world(), random, 0.05, true);
      CutSettings settings = stroke.settings;
      settings.resolution.scheme = scheme;
      settings.max_faces = 200'000;
      draw(document, stroke, settings);
      const LooksError error = error_of(document.world(), linear);
      EXPECT_LT(error.uv, 1e-6);
      EXPECT_LT(error.normal, 1e-6);
      EXPECT_LT(error.attribute, 1e-6);
      EXPECT_LT(error.tangent, 1e-6);
      EXPECT_EQ(error.odd_signs, 0u);
      document.apply(Undo{});
      ASSERT_TRUE(run_all(document).ok());
      EXPECT_LT(error_of(document.world(), linear).uv, 1e-6);
    }
  }
}

// Vertices that slide onto the rim leave the planes of some of their loaded faces, where the sheet is bent.
// There values continue over sides without a seam, or are those of the nearest point of the loaded plane.
TEST(PieceLooks, are_kept_on_a_smooth_rim_of_a_bent_sheet) {
  size_t exact = 0;
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const bool is_bent = seed % 2 != 0;
    Random random(seed);
    Soup sheet = grid(9, 1);
    for (Vec3& p : sheet.positions) p.y = is_bent ? 0.1 * std::sin(3 * p.x) : 0;
    const LinearLooks linear(sheet);
    Document document(world_of(with_looks(sheet)));
    const RandomStroke stroke = random_stroke(document.world(), random, 0.05, true);
    CutSettings settings = stroke.settings;
    settings.resolution.rim = Rim::kSmooth;
    draw(document, stroke, settings);
    const LooksError error = error_of(document.world(), linear);
    EXPECT_LE(error.off_plane, 0);
    EXPECT_LT(is_bent ? 0 : error.uv, 1e-6);
    exact += is_bent && error.first_uv < 1e-6;
  }
  EXPECT_GE(exact, 5u);
}

TEST(PieceLooks, follow_detached_and_turned_bodies) {
  const Soup two = both(sphere(8, 12, 1), moved(sphere(8, 12, 1), {4, 0, 0}, 1));
  const LinearLooks linear(two);
  World world = world_of(with_looks(two));
  Body& body = world.body(world.ids()[0]);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (body.mesh.position(body.mesh.corners(FaceId(f))[0]).x > 2) body.mesh.edit_data(FaceId(f)).piece = 1;
  }
  const std::vector<FaceId> faces = body.faces_of(1);
  ASSERT_FALSE(faces.empty());
  const Body copy = [&] {
    Body detached =
        make_body("part", BuiltMesh{extract_mesh(body.mesh, faces), body.loaded, {}, {}, body.looks});
    for (uint32_t f = 0; f < faces.size(); ++f)
      detached.loaded_faces.push_back(body.mesh.data(faces[f]).base);
    detached.placement.orientation = glm::normalize(glm::dquat(1, 0.5, -0.25, 0.125));
    return detached;
  }();
  World other;
  other.add(copy);
  const LooksError error = error_of(other, linear);
  EXPECT_EQ(error.faces, faces.size());
  EXPECT_LT(error.uv, 1e-6);
  EXPECT_LT(error.normal, 1e-6);
}

// A flat sheet keeps functions that are linear in the position, and a jump between two halves.
TEST(PieceLooks, match_the_previous_surface_after_remeshing) {
  const Soup flat = grid(16, 1);
  const LinearLooks linear(flat);
  Soup soup = with_looks(flat);
  auto& halves = soup.looks.uv_sets[1];
  halves = soup.looks.uv_sets[0];
  const auto vertices = static_cast<uint32_t>(flat.positions.size());
  for (const Vec3& p : flat.positions) halves.values.emplace_back(glm::vec2(5) + glm::vec2(linear.uv(p)));
  const double middle = 0.5 * (linear.low.x + linear.low.x + linear.size.x);
  for (auto& corners : halves.corners) {
    double x = 0;
    for (const uint32_t v : corners) x += flat.positions[v].x / 3;
    for (uint32_t& v : corners) v += x > middle ? vertices : 0;
  }
  for (const Command& command : {Command(SimplifyPiece{{}, {.faces = 60}}), Command(SubdividePiece{})}) {
    World world = world_of(soup);
    const PieceId piece{world.ids()[0], 0};
    Command own = command;
    std::visit(
        [&](auto& c) {
          if constexpr (requires { c.piece; }) c.piece = piece;
        },
        own);
    Document document(std::move(world));
    const auto done = document.apply(own);
    ASSERT_TRUE(done.ok()) << done.error().message;
    const Body& body = document.world().body(document.world().ids()[0]);
    EXPECT_NE(body.mesh.live_faces(), soup.triangles.size());
    ASSERT_NE(body.looks, nullptr);
    const std::vector<FaceId> faces = live_faces(body.mesh);
    const CornerLooks looks = looks_of(body, faces, LookNormals::kSmooth);
    const auto& quality = looks.attributes.at(0).channel;
    size_t lower = 0, upper = 0;
    for (size_t i = 0; i < faces.size(); ++i) {
      const Triangle t = body.mesh.triangle(faces[i]);
      for (size_t k = 0; k < 3; ++k) {
        const glm::vec2 uv = looks.uv_sets[0].values[looks.uv_sets[0].corners[i][k]],
                        half = looks.uv_sets[1].values[looks.uv_sets[1].corners[i][k]];
        const glm::vec2 wanted(linear.uv(t[k]));
        EXPECT_LT(glm::length(uv - wanted), 1e-5f);
        EXPECT_NEAR(quality.values[quality.corners[i][k]].x, wanted.x, 1e-5);
        EXPECT_EQ(looks.tangents.values[looks.tangents.corners[i][k]].w, -1);
        (glm::length(half - wanted) < 1e-5f ? lower : upper) += 1;
        EXPECT_LT(std::min(glm::length(half - wanted), glm::length(half - wanted - glm::vec2(5))), 1e-5f);
      }
    }
    EXPECT_GT(lower, faces.size());
    EXPECT_GT(upper, faces.size());
  }
}

TEST(PieceLooks, do_not_affect_the_cut_or_its_hash_and_use_no_memory_per_new_face) {
  Random random(3);
  const Soup plain = sphere(24, 32, 1);
  Document without(world_of(plain)), with(world_of(with_looks(plain)));
  const Looks* loaded = with.world().body(with.world().ids()[0]).looks.get();
  const RandomStroke stroke = random_stroke(without.world(), random, 0.1, false);
  for (Document* document : {&without, &with}) draw(*document, stroke, stroke.settings);
  EXPECT_EQ(state_hash(without.world()), state_hash(with.world()));
  EXPECT_EQ(without.world().body(without.world().ids()[0]).looks, nullptr);
  EXPECT_EQ(with.world().body(with.world().ids()[0]).looks.get(), loaded);
}

TEST(PieceLooks, use_at_most_60_bytes_per_loaded_face) {
  Soup soup = with_looks(sphere(64, 96, 1));
  soup.looks.uv_sets.resize(1);
  soup.looks.tangents = {};
  soup.looks.attributes.clear();
  const BuiltMesh built = build(soup);
  EXPECT_LE(built.looks->bytes(), 60 * size_t{built.report.faces});
}

// A face that the mesh turned keeps a normal that was right, and turns one that agreed with the file.
TEST(PieceLooks, flip_normals_with_flipped_faces) {
  for (const bool outward : {true, false}) {
    Soup soup = sphere(8, 12, 1);
    Random random(5);
    std::vector<bool> reversed;
    for (Soup::Triangle& t : soup.triangles) {
      reversed.push_back(random.below(2) == 0);
      if (reversed.back()) std::swap(t[0], t[1]);
    }
    for (uint32_t t = 0; t < soup.triangles.size(); ++t) {
      for (const uint32_t v : soup.triangles[t]) {
        const double sign = outward || !reversed[t] ? 1 : -1;
        soup.looks.normals.values.emplace_back(sign * glm::normalize(soup.positions[v]));
        soup.looks.tangents.values.emplace_back(1, 0, 0, 1);
      }
      soup.looks.normals.corners.push_back({3 * t, 3 * t + 1, 3 * t + 2});
      soup.looks.tangents.corners.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    World world = world_of(soup);
    const Body& body = world.body(world.ids()[0]);
    const std::vector<FaceId> faces = live_faces(body.mesh);
    const CornerLooks looks = looks_of(body, faces, LookNormals::kSmooth);
    for (size_t i = 0; i < faces.size(); ++i) {
      for (size_t k = 0; k < 3; ++k) {
        const Vec3 p = body.mesh.position(body.mesh.corners(faces[i])[k]);
        EXPECT_GT(glm::dot(Vec3(looks.normals.values[looks.normals.corners[i][k]]), p), 0.9);
        // The sign of the bitangent changes with the normal, so that the bitangent stays.
        EXPECT_EQ(looks.tangents.values[looks.tangents.corners[i][k]],
                  glm::vec4(1, 0, 0, outward || !reversed[i] ? 1 : -1));
      }
    }
  }
}

// Half of the shortest edge at each vertex.
std::vector<double> room_around(const Soup& soup) {
  std::vector<double> room(soup.positions.size(), 1e300);
  for (const Soup::Triangle& t : soup.triangles) {
    for (size_t i = 0; i < 3; ++i) {
      const uint32_t from = t[i], to = t[(i + 1) % 3];
      const double half = 0.5 * glm::length(soup.positions[to] - soup.positions[from]);
      room[from] = std::min(room[from], half);
      room[to] = std::min(room[to], half);
    }
  }
  return room;
}

// A sphere of radius 1. The UVs of each half are angles from its pole on the x axis, moved at random and
// scaled unevenly, so that the stretch varies between the faces and the middle is a seam.
Soup in_two_halves(Soup soup, Random& random) {
  const std::vector<double> room = room_around(soup);
  const auto vertices = static_cast<uint32_t>(soup.positions.size());
  LookChannel<glm::vec2> uvs;
  for (const double side : {-1.0, 1.0}) {
    for (uint32_t v = 0; v < vertices; ++v) {
      const Vec3& p = soup.positions[v];
      const glm::dvec2 across(p.z, p.y), jitter(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
      const double length = glm::length(across), angle = std::atan2(length, side * p.x);
      const glm::dvec2 uv = (length > 0 ? angle / length * across : across) + room[v] * jitter;
      uvs.values.emplace_back(side * (10 + uv.x), 3 * uv.y);
    }
  }
  for (const Soup::Triangle& t : soup.triangles) {
    uvs.corners.push_back(t);
    if (soup.positions[t[0]].x + soup.positions[t[1]].x + soup.positions[t[2]].x < 0) continue;
    for (uint32_t& v : uvs.corners.back()) v += vertices;
  }
  soup.looks.uv_sets = {uvs};
  return soup;
}

// A face and its UVs.
struct TexturedFace {
  Triangle corners;
  std::array<glm::dvec2, 3> uvs;

  double area() const { return glm::determinant(glm::dmat2(uvs[1] - uvs[0], uvs[2] - uvs[0])); }
  Vec3 weights(const glm::dvec2& uv) const {
    const glm::dvec2 w = glm::inverse(glm::dmat2(uvs[1] - uvs[0], uvs[2] - uvs[0])) * (uv - uvs[0]);
    return {1 - w.x - w.y, w.x, w.y};
  }
  Vec3 at(const Vec3& w) const { return w.x * corners[0] + w.y * corners[1] + w.z * corners[2]; }
  // The derivative of UVs by lengths in the plane of the face.
  glm::dmat2 derivative() const {
    const Vec3 u = corners[1] - corners[0], w = corners[2] - corners[0], x = glm::normalize(u),
               y = glm::normalize(w - glm::dot(w, x) * x);
    return glm::dmat2(uvs[1] - uvs[0], uvs[2] - uvs[0]) *
           glm::inverse(glm::dmat2(glm::dvec2(glm::length(u), 0), {glm::dot(w, x), glm::dot(w, y)}));
  }
};

std::vector<TexturedFace> textured_faces(const Body& body) {
  std::vector<TexturedFace> all;
  const std::vector<FaceId> faces = live_faces(body.mesh);
  const CornerLooks looks = looks_of(body, faces, LookNormals::kLoaded);
  for (size_t i = 0; i < faces.size(); ++i) {
    TexturedFace& face = all.emplace_back();
    face.corners = body.mesh.triangle(faces[i]);
    for (size_t k = 0; k < 3; ++k) face.uvs[k] = looks.uv_sets[0].values[looks.uv_sets[0].corners[i][k]];
  }
  return all;
}

// Returns the largest factor by which a map stretches or compresses.
double largest_factor(const glm::dmat2& map) {
  const glm::dmat2 squares = glm::transpose(map) * map;
  const double mean = 0.5 * (squares[0][0] + squares[1][1]),
               spread = std::hypot(0.5 * (squares[0][0] - squares[1][1]), squares[0][1]);
  return std::sqrt(std::max(mean + spread, 1 / (mean - spread)));
}

// Compares simplified faces at random points with the original faces that contain the same UV.
struct Stretch {
  double worst = 0;
  size_t mirrored = 0, compared = 0;
};
Stretch stretch_of(const std::vector<TexturedFace>& made, const std::vector<TexturedFace>& from,
                   Random& random) {
  Stretch stretch;
  for (const TexturedFace& face : made) {
    for (int sample = 0; sample < 12; ++sample) {
      Vec3 weights(random.unit(), random.unit(), random.unit());
      weights /= weights.x + weights.y + weights.z;
      const glm::dvec2 uv = weights.x * face.uvs[0] + weights.y * face.uvs[1] + weights.z * face.uvs[2];
      for (const TexturedFace& other : from) {
        const Vec3 w = other.weights(uv);
        if (!(std::min({w.x, w.y, w.z}) > 1e-6)) continue;
        ++stretch.compared;
        stretch.mirrored += other.area() * face.area() < 0;
        const glm::dmat2 map = glm::inverse(face.derivative()) * other.derivative();
        stretch.worst = std::max(stretch.worst, largest_factor(map));
      }
    }
  }
  return stretch;
}

TEST(PieceLooks, are_never_stretched_or_mirrored_by_simplification) {
  for (uint64_t seed = 1; seed <= runs(12); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const int rings = 12 + static_cast<int>(random.below(16));
    World world = world_of(in_two_halves(sphere(rings, 2 * rings, 1), random));
    const BodyId before = world.ids()[0];
    const std::vector<TexturedFace> from = textured_faces(world.body(before));
    Document document(std::move(world));
    ASSERT_TRUE(document.apply(SimplifyPiece{{before, 0}, {.faces = from.size() / 20}}).ok());
    const std::vector<TexturedFace> made = textured_faces(document.world().body(document.world().ids()[0]));
    EXPECT_LT(made.size(), from.size() / 2);
    const Stretch stretch = stretch_of(made, from, random);
    EXPECT_GT(stretch.compared, 11 * made.size());
    EXPECT_EQ(stretch.mirrored, 0u);
    EXPECT_LT(stretch.worst, kMaxUvStretch * (1 + 1e-6));
    EXPECT_GT(stretch.worst, 0.9 * kMaxUvStretch);
  }
}

// Both sides of the fold x = 0 have the same UVs, and no seam separates them.
TEST(PieceLooks, mirrored_at_a_fold_stay_on_their_sides) {
  Soup soup = grid(16, 1);
  LookChannel<glm::vec2> uvs{{}, soup.triangles};
  for (const Vec3& p : soup.positions) uvs.values.emplace_back(std::abs(p.x), p.z);
  soup.looks.uv_sets = {uvs};
  World world = world_of(soup);
  const BodyId before = world.ids()[0];
  Document document(std::move(world));
  ASSERT_TRUE(document.apply(SimplifyPiece{{before, 0}, {.faces = 1}}).ok());
  const std::vector<TexturedFace> made = textured_faces(document.world().body(document.world().ids()[0]));
  EXPECT_LT(made.size(), soup.triangles.size() / 2);
  for (const TexturedFace& face : made) {
    const auto [low, high] = std::minmax({face.corners[0].x, face.corners[1].x, face.corners[2].x});
    EXPECT_GE(low * high, 0);
  }
}

TEST(PieceLooks, of_an_even_texture_do_not_limit_simplification) {
  const Soup flat = grid(16, 1);
  std::vector<size_t> faces;
  for (const Soup& soup : {flat, with_looks(flat)}) {
    Soup own = soup;
    own.looks.uv_sets.resize(std::min<size_t>(own.looks.uv_sets.size(), 1));  // without seams
    World world = world_of(own);
    const BodyId before = world.ids()[0];
    Document document(std::move(world));
    ASSERT_TRUE(document.apply(SimplifyPiece{{before, 0}, {.faces = 60}}).ok());
    faces.push_back(document.world().body(document.world().ids()[0]).mesh.live_faces());
  }
  EXPECT_EQ(faces[0], faces[1]);
}

TEST(PieceLooks, match_on_both_sides_of_a_loaded_edge) {
  Random random(7);
  Document document(world_of(with_looks(sphere(12, 16, 1))));
  const RandomStroke stroke = random_stroke(document.world(), random, 0.05, true);
  draw(document, stroke, stroke.settings);
  const Body& body = document.world().body(document.world().ids()[0]);
  const std::vector<FaceId> faces = live_faces(body.mesh);
  const CornerLooks looks = looks_of(body, faces, LookNormals::kSmooth);
  std::map<uint32_t, glm::vec2> first;
  for (size_t i = 0; i < faces.size(); ++i) {
    const auto corners = body.mesh.corners(faces[i]);
    for (size_t k = 0; k < 3; ++k) {
      const glm::vec2 uv = looks.uv_sets[0].values[looks.uv_sets[0].corners[i][k]];
      EXPECT_EQ(first.try_emplace(corners[k].index, uv).first->second, uv);
    }
  }
}

TEST(PieceLooks, name_the_source_of_every_face) {
  Random random(9);
  Soup soup = both(grid(5, 1), moved(sphere(8, 12, 1), {4, 0, 0}, 1));
  soup.triangles.insert(soup.triangles.begin() + 3, Soup::Triangle{0, 0, 1});  // dropped
  soup.keeps_corners = true;
  Document document(world_of(soup));
  const RandomStroke stroke = random_stroke(document.world(), random, 0.1, true);
  draw(document, stroke, stroke.settings);
  const Body& body = document.world().body(document.world().ids()[0]);
  const std::vector<FaceId> faces = live_faces(body.mesh);
  const std::vector<FaceSource> sources = sources_of(body, faces);
  ASSERT_EQ(sources.size(), faces.size());
  for (size_t i = 0; i < faces.size(); ++i) {
    ASSERT_GE(sources[i].face, 0);
    const Soup::Triangle& from = soup.triangles[static_cast<size_t>(sources[i].face)];
    for (size_t k = 0; k < 3; ++k) {
      const Vec3& w = sources[i].barycentrics[k];
      Vec3 p(0);
      for (int c = 0; c < 3; ++c) p += w[c] * soup.positions[from[static_cast<size_t>(c)]];
      EXPECT_LT(glm::length(p - body.mesh.position(body.mesh.corners(faces[i])[k])), 1e-9);
    }
  }
}

TEST(PieceLooks, name_the_part_with_the_largest_area) {
  World world = world_of(sphere(8, 12, 1));
  const Body& body = world.body(world.ids()[0]);
  const std::vector<FaceId> faces = live_faces(body.mesh);
  const auto all = static_cast<uint32_t>(faces.size());
  const std::vector<MeshPart> parts{{"all", 0, all}, {"front", 0, all / 4}, {"back", all / 4, all}};
  EXPECT_EQ(part_name_of(body, parts, faces), "all");
  EXPECT_EQ(part_name_of(body, parts, std::span(faces).first(all / 4)), "front");
  EXPECT_EQ(part_name_of(body, parts, std::span(faces).last(all / 4)), "back");
  EXPECT_EQ(part_name_of(body, {}, faces), "");
  const std::vector<MeshPart> beyond{{"beyond", all, all + 4}};
  EXPECT_EQ(part_name_of(body, beyond, faces), "");
}

TEST(PieceLooks, name_a_part_by_area_and_not_by_faces) {
  Soup large;
  large.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  large.triangles = {{0, 1, 2}};
  for (const auto& [size, name] : {std::pair(0.65, "one"), std::pair(0.75, "many")}) {
    const World world = world_of(both(large, moved(grid(4, size), {5, 0, 0}, 1)));
    const Body& body = world.body(world.ids()[0]);
    EXPECT_EQ(
        part_name_of(body, std::vector<MeshPart>{{"one", 0, 1}, {"many", 1, 33}}, live_faces(body.mesh)),
        name);
  }
}

}  // namespace
}  // namespace kerf::test
