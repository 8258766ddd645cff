#include "tests/support/solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/deterministic_math.h"
#include "core/edit/separation.h"
#include "core/mesh/measures.h"
#include "tests/support/strokes.h"

namespace kerf::test {

Soup extruded(const Soup& sheet, double height) {
  Soup solid;
  const auto count = static_cast<uint32_t>(sheet.positions.size());
  for (const double y : {0.0, height}) {
    for (const Vec3& p : sheet.positions) solid.positions.push_back(p + Vec3(0, y, 0));
  }
  std::map<std::pair<uint32_t, uint32_t>, int> sides;
  for (auto [a, b, c] : sheet.triangles) {
    const Vec3 &p = sheet.positions[a], &q = sheet.positions[b], &r = sheet.positions[c];
    if (glm::cross(q - p, r - p).y < 0) std::swap(b, c);
    solid.triangles.push_back({a, c, b});
    solid.triangles.push_back({a + count, b + count, c + count});
    ++sides[{a, b}], ++sides[{b, c}], ++sides[{c, a}];
  }
  for (const auto& [side, times] : sides) {
    const auto [a, b] = side;
    if (sides.contains({b, a})) continue;
    solid.triangles.push_back({a, b, b + count});
    solid.triangles.push_back({a, b + count, a + count});
  }
  return solid;
}

namespace {

// A square of so many cells without every cell in whose row and column there is one.
Soup grid_with_holes(int cells, double size) {
  Soup soup = grid(cells, size);
  const double cell = size / cells;
  std::erase_if(soup.triangles, [&](const auto& t) {
    const Vec3 middle = (soup.positions[t[0]] + soup.positions[t[1]] + soup.positions[t[2]]) / 3.0;
    const auto place = [&](double x) { return static_cast<int>(std::floor((x + 0.5 * size) / cell)); };
    return place(middle.x) % 3 == 1 && place(middle.z) % 3 == 1;
  });
  return soup;
}

// A tube of this radius along a trefoil knot of about three metres.
Soup trefoil(int rings, int sectors, double radius) {
  Soup soup;
  const auto at = [](double t) {
    return 0.25 * Vec3(std::sin(t) + 2 * std::sin(2 * t), std::sin(3 * t), std::cos(t) - 2 * std::cos(2 * t));
  };
  const auto corner = [&](int ring, int sector) {
    return static_cast<uint32_t>(ring % rings * sectors + sector % sectors);
  };
  for (int i = 0; i < rings; ++i) {
    const double t = 2 * kPi * i / rings, step = 1e-4;
    const Vec3 along = glm::normalize(at(t + step) - at(t - step));
    const Vec3 right = glm::normalize(glm::cross(along, Vec3(0, 1, 0))), up = glm::cross(right, along);
    for (int k = 0; k < sectors; ++k) {
      const double angle = 2 * kPi * k / sectors;
      soup.positions.push_back(at(t) + radius * (std::cos(angle) * right + std::sin(angle) * up));
      soup.triangles.push_back({corner(i, k), corner(i + 1, k), corner(i + 1, k + 1)});
      soup.triangles.push_back({corner(i, k), corner(i + 1, k + 1), corner(i, k + 1)});
    }
  }
  return soup;
}

Soup facing_outside(Soup soup) {
  const Mesh mesh = build(soup).mesh;
  const EnclosedVolume enclosed = enclosed_volume(mesh, Vec3(0));
  EXPECT_TRUE(enclosed.closed);
  return enclosed.volume > 0 ? soup : inside_out(std::move(soup));
}

}  // namespace

std::vector<NamedSoup> generated_solids() {
  const auto ball = [](double radius) { return facing_outside(sphere(12, 18, radius)); };
  const Soup ring = facing_outside(torus(24, 12, 0.4, 0.15));
  return {{"box", facing_outside(brick({1, 0.6, 0.8}))},
          {"box of many faces", extruded(grid(7, 1), 0.4)},
          {"ball", ball(0.5)},
          {"ring", ring},
          {"tube", facing_outside(pipe(24, 0.25, 0.5, 0.8))},
          {"plate with holes", extruded(grid_with_holes(9, 1), 0.1)},
          {"two balls", both(ball(0.4), moved(ball(0.3), {0.9, 0.1, 0}, 1))},
          {"hollow ball", both(ball(0.5), inside_out(ball(0.35)))},
          {"nested balls", both(both(ball(0.5), inside_out(ball(0.35))), ball(0.2))},
          {"knot", facing_outside(trefoil(72, 12, 0.12))}};
}

SolidStroke straight_stroke(const Vec3& from, const Vec3& to, const Vec3& direction, double radius,
                            Interval range) {
  SolidStroke stroke;
  stroke.name = "straight";
  stroke.settings.laser.radius = radius;
  stroke.settings.laser.range = range;
  stroke.settings.resolution.target_edge = radius;
  stroke.settings.resolution.rim = Rim::kSmooth;
  stroke.poses = {{from, direction}, {to, direction}};
  return stroke;
}

SolidStroke random_solid_stroke(const World& world, Random& random) {
  const World::Bounds bounds = world.bounds();
  const double size = bounds.diagonal(), radius = size * random.uniform(0.008, 0.05);
  const Vec3 middle = 0.5 * (bounds.min + bounds.max);
  constexpr Vec3 kAxes[] = {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}};
  const Vec3 axis = random.below(3) == 0 ? kAxes[random.below(3)] : random_direction(random);
  const Vec3 right = across(axis), up = glm::cross(axis, right);
  const auto at = [&](double x, double y) { return middle - size * axis + size * (x * right + y * up); };
  const auto anywhere = [&](double reach) {
    return at(random.uniform(-reach, reach), random.uniform(-reach, reach));
  };
  const double heading = random.uniform(-kPi, kPi);
  const auto ahead = [&](double length, double turn = 0) {
    return length * size * (std::cos(heading + turn) * right + std::sin(heading + turn) * up);
  };
  SolidStroke stroke = straight_stroke({}, {}, axis, radius, {0, 2 * size});
  std::vector<Vec3> origins;
  switch (random.below(8)) {
    case 0:
      stroke.name = "through";
      origins = {anywhere(0.2) - ahead(0.8)};
      origins.push_back(origins[0] + ahead(1.6));
      break;
    case 1:
      stroke.name = "slit";
      origins = {anywhere(0.25), anywhere(0.25)};
      break;
    case 2:
      stroke.name = "drilled";
      origins = {anywhere(0.3)};
      break;
    case 3:
      stroke.name = "blind";
      stroke.settings.laser.range.high = size * random.uniform(0.8, 1.2);
      origins = {anywhere(0.2)};
      if (random.below(2) == 0) origins.push_back(anywhere(0.2));
      break;
    case 4: {
      stroke.name = "grazing";
      const double aside = random.uniform(0.2, 0.5);
      origins = {at(0, 0) + ahead(aside, kPi / 2) - ahead(0.7)};
      origins.push_back(origins[0] + ahead(1.4));
      break;
    }
    case 5: {
      stroke.name = "circle";
      const Vec3 centre = anywhere(0.15);
      const double wide = random.uniform(0.04, 0.25);
      constexpr int kParts = 48;
      for (int i = 0; i <= kParts; ++i)
        origins.push_back(centre + ahead(wide, 2 * kPi * (i % kParts) / kParts));
      break;
    }
    case 6:
      stroke.name = "over itself";
      for (uint64_t i = 4 + random.below(3); i > 0; --i) origins.push_back(anywhere(0.35));
      break;
    default: {
      stroke.name = "fan";
      const Vec3 point = anywhere(0.1);
      const uint64_t rays = 2 + random.below(3);
      for (uint64_t i = 0; i < rays; ++i) {
        origins.push_back(point);
        origins.push_back(point + ahead(random.uniform(0.2, 0.7), random.uniform(-kPi, kPi)));
      }
    }
  }
  stroke.poses.clear();
  for (const Vec3& o : origins) stroke.poses.push_back({o, axis});
  return stroke;
}

namespace {

EnclosedVolume enclosed_by(const Body& body) { return enclosed_volume(body.mesh, body.middle()); }

// How often the faces of a body wind around a point.
int winding_at(const Body& body, const Vec3& p) {
  const Vec3 direction = glm::normalize(Vec3(0.31, 0.52, 0.79));
  std::vector<RayHit> hits;
  body.tree.crossings(body.mesh, {p, direction}, {0, std::numeric_limits<double>::max()}, hits);
  int winding = 0;
  for (const RayHit& hit : hits) {
    const Triangle t = body.mesh.triangle(hit.face);
    winding += glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), direction) > 0 ? 1 : -1;
  }
  return winding;
}

World as_solid(World world) {
  only_body(world).solid = true;
  return world;
}

}  // namespace

SolidCut::SolidCut(World world)
    : document_(as_solid(std::move(world))), loaded_(body()), volume_(enclosed_by(loaded_).volume) {
  EXPECT_TRUE(enclosed_by(loaded_).closed);
  EXPECT_GT(volume_, 0);
}

bool SolidCut::draw(const SolidStroke& stroke, Random& random) {
  document_.apply(BeginStroke{stroke.settings, stroke.poses[0]});
  for (size_t i = 1; i < stroke.poses.size(); ++i) document_.apply(MoveBeam{stroke.poses[i]});
  document_.apply(EndStroke{});
  const Result<StepResult> cut = run_all(document_);
  EXPECT_TRUE(cut.ok());
  if (!cut) return false;
  const double reach = 4 * stroke.settings.laser.range.high, radius = stroke.settings.laser.radius;
  for (size_t i = 0; i < stroke.poses.size(); ++i) {
    for (const BeamMove& m : subdivide({stroke.poses[i > 0 ? i - 1 : 0], stroke.poses[i]}, radius, reach))
      swept_.emplace_back(m.from, m.to, radius, stroke.settings.laser.range);
  }
  removed_ += cut->delta.solid.removed_volume;
  for (const LeftOpen& open : cut->delta.left_open) reasons_.push_back(open.why);
  if (!cut->delta.left_open.empty()) return false;

  std::vector<Mesh::Side> open;
  body().mesh.append_open_sides(open);
  EXPECT_TRUE(open.empty()) << "an open side that nothing was said of";
  const EnclosedVolume enclosed = enclosed_by(body());
  EXPECT_TRUE(enclosed.closed);
  EXPECT_NEAR(enclosed.volume + removed_, volume_, 1e-6 * volume_);
  specks_ = 0;
  const std::vector<bool> closed = closed_pieces(body().mesh, body().pieces.size());
  for (uint32_t label = 0; label < closed.size(); ++label) {
    if (body().pieces[label].faces == 0) continue;
    EXPECT_TRUE(closed[label]) << "piece " << label;
    const EnclosedVolume own = enclosed_volume(body().mesh, body().faces_of(label), body().middle());
    EXPECT_GT(own.volume, -1e-12 * volume_) << "piece " << label;
    specks_ += own.volume <= 1e-9 * radius * radius * radius;
  }
  expect_points_inside_as_before(radius, random);
  return true;
}

double SolidCut::distance_from_swept(const Vec3& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const SweptCylinder& part : swept_) least = std::min(least, part.signed_distance(p));
  return least;
}

// Near a boundary, where either may be, none is asked.
void SolidCut::expect_points_inside_as_before(double radius, Random& random) const {
  constexpr int kPoints = 200;
  const Vec3 low = loaded_.loaded.min, high = loaded_.loaded.max;
  for (int i = 0; i < kPoints; ++i) {
    Vec3 p(random.uniform(low.x, high.x), random.uniform(low.y, high.y), random.uniform(low.z, high.z));
    if (i % 2 == 0) {  // close to what was swept
      const SweptCylinder& part = swept_[random.below(swept_.size())];
      for (int k = 0; k < 8 && std::abs(part.signed_distance(p)) > 0.5 * radius; ++k) {
        const Vec3 other(random.uniform(low.x, high.x), random.uniform(low.y, high.y),
                         random.uniform(low.z, high.z));
        if (std::abs(part.signed_distance(other)) < std::abs(part.signed_distance(p))) p = other;
      }
    }
    const double near = 0.03 * radius, distance = distance_from_swept(p);
    if (std::abs(distance) < near) continue;
    const int before = winding_at(loaded_, p), wanted = distance > 0 ? before : 0;
    if (winding_at(body(), p) == wanted) continue;
    bool inside_around = false, outside_around = false;
    for (int k = 0; k < 32; ++k) {
      const int winding = winding_at(loaded_, p + near * random_direction(random));
      (winding > 0 ? inside_around : outside_around) = true;
    }
    if (inside_around && outside_around) continue;
    EXPECT_EQ(winding_at(body(), p), wanted)
        << "at " << p.x << ' ' << p.y << ' ' << p.z << ", " << distance / radius << " radii from the swept";
    return;
  }
}

size_t SolidCut::solids() const {
  std::vector<uint32_t> label;
  const uint32_t parts = label_components(body().mesh, label);
  std::vector<std::vector<FaceId>> faces(parts);
  for (uint32_t f = 0; f < label.size(); ++f) {
    if (body().mesh.is_live(FaceId(f))) faces[label[f]].emplace_back(f);
  }
  return static_cast<size_t>(std::count_if(faces.begin(), faces.end(), [&](const auto& own) {
    return enclosed_volume(body().mesh, own, body().middle()).volume > 0;
  }));
}

}  // namespace kerf::test
