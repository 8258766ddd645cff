#include "tests/bench/subject.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "core/base/random.h"
#include "core/mesh/mesh_file.h"

namespace kerf::bench {

namespace {

constexpr double kPi = 3.141592653589793;
constexpr double kRingsPerSector = 46.0 / 30, kRingsPerSectorOfKnot = 12;
constexpr double kStep = 1e-5;  // along the middle of the knot, for its direction

std::filesystem::path file_of(const std::string& name) {
  const char* folder = std::getenv("KERF_TEST_MESHES");
  const auto real = std::filesystem::path(folder ? folder : ".") / "real";
  return name == "bunny" ? real / "classic" / "bunny.off" : real / "derived" / "big_bunny_x16.ply";
}

using Along = std::function<Vec3(double, double)>;  // both in 0 .. 2 pi

// A closed surface of 2 * rings * sectors faces.
Soup closed_surface(int rings, int sectors, const Along& at) {
  Soup soup;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sectors; ++j)
      soup.positions.push_back(at(2 * kPi * i / rings, 2 * kPi * j / sectors));
  }
  const auto index = [&](int i, int j) { return static_cast<uint32_t>(i % rings * sectors + j % sectors); };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sectors; ++j) {
      soup.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      soup.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
    }
  }
  return soup;
}

Soup soup_of(const std::string& name) {
  if (name == "tiny") return knobbly_torus(768);
  if (name == "torus") return knobbly_torus(276000);
  auto soup = read_mesh(file_of(name));
  return soup ? std::move(*soup) : Soup{};
}

void across(const Vec3& d, Vec3& u, Vec3& w) {
  u = glm::normalize(glm::cross(d, std::abs(d.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
  w = glm::cross(d, u);
}

}  // namespace

Soup knobbly_torus(size_t faces) {
  const int rings =
      static_cast<int>(std::lround(std::sqrt(static_cast<double>(faces) * kRingsPerSector / 2)));
  return closed_surface(rings, static_cast<int>(faces / 2) / rings, [](double u, double v) {
    const double thick = 0.3 + 0.03 * std::sin(9 * u) * std::sin(7 * v) + 0.01 * std::sin(31 * u + 23 * v);
    const double from_axis = 1 + thick * std::cos(v);
    return Vec3(from_axis * std::cos(u), thick * std::sin(v), from_axis * std::sin(u));
  });
}

Vec3 TrefoilKnot::middle(double u) const {
  const double from_axis = 1 + 0.5 * std::cos(3 * u);
  return {from_axis * std::cos(2 * u), 0.5 * std::sin(3 * u), from_axis * std::sin(2 * u)};
}

// The middle runs on a torus, whose normal is perpendicular to it.
Soup TrefoilKnot::soup(size_t faces) const {
  const int sectors =
      static_cast<int>(std::lround(std::sqrt(static_cast<double>(faces) / 2 / kRingsPerSectorOfKnot)));
  return closed_surface(static_cast<int>(faces / 2) / sectors, sectors, [this](double u, double v) {
    const Vec3 normal(std::cos(3 * u) * std::cos(2 * u), std::sin(3 * u), std::cos(3 * u) * std::sin(2 * u));
    const Vec3 along = glm::normalize(middle(u + kStep) - middle(u - kStep));
    const Vec3 other = glm::normalize(glm::cross(along, normal));
    return middle(u) + radius * (std::cos(v) * glm::cross(other, along) + std::sin(v) * other);
  });
}

std::vector<std::string> subject_names(bool tiny) {
  if (tiny) return {"tiny"};
  std::vector<std::string> names{"torus"};
  for (const char* name : {"bunny", "big_bunny"}) {
    if (std::filesystem::exists(file_of(name))) names.emplace_back(name);
  }
  return names;
}

Subject make_subject(const std::string& name) {
  Subject s;
  s.name = name;
  auto built = build_mesh(soup_of(name));
  if (!built) return s;
  s.centre = 0.5 * built->report.min + 0.5 * built->report.max;
  s.radius = 0.5 * glm::length(built->report.max - built->report.min);
  s.mesh = std::move(built->mesh);
  s.arrays = arrays_of(s.mesh);
  return s;
}

TriangleArrays arrays_of(const Mesh& mesh) {
  TriangleArrays arrays;
  for (uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
    const Vec3 p = mesh.position(VertexId(v));
    for (int k = 0; k < 3; ++k) arrays.positions.push_back(static_cast<float>(p[k]));
  }
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    for (const VertexId v : mesh.corners(FaceId(f))) arrays.corners.push_back(v.index);
  }
  return arrays;
}

std::vector<Pose> sweep_rays(const Subject& s, int steps) {
  std::vector<Pose> rays;
  for (int i = 0; i < steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Vec3 d = glm::normalize(Vec3(0.4 * std::sin(2 * kPi * t), -1, 0.3 * std::cos(2 * kPi * t)));
    const Vec3 middle = s.centre + 0.75 * s.radius * Vec3(std::sin(6 * kPi * t), 0, std::sin(10 * kPi * t));
    Vec3 u, w;
    across(d, u, w);
    for (int r = 0; r < 4; ++r) {
      const Vec3 offset = (0.5 * s.steps_apart()) * ((r & 1 ? 1.0 : -1.0) * u + (r & 2 ? 1.0 : -1.0) * w);
      rays.push_back({middle + offset - 2 * s.radius * d, d});
    }
  }
  return rays;
}

Vec3 random_direction(Random& random) {
  for (;;) {
    const Vec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const double length2 = glm::dot(v, v);
    if (length2 > 1e-3 && length2 <= 1) return v / std::sqrt(length2);
  }
}

std::vector<Pose> random_chords(const Subject& s, int count) {
  Random random(7);
  std::vector<Pose> rays;
  for (int i = 0; i < count; ++i) {
    const Vec3 a = s.centre + s.radius * random_direction(random),
               b = s.centre + s.radius * random_direction(random);
    rays.push_back({a, glm::normalize(b - a)});
  }
  return rays;
}

Pose slit_pose(const Subject& s, double share) {
  const Vec3 d = glm::normalize(Vec3(0.1, -1, 0.05));
  const Vec3 middle = s.centre + 0.9 * s.radius * Vec3(2 * share - 1, 0, 0.1 * std::sin(6 * share));
  return {middle - 2 * s.radius * d, d};
}

}  // namespace kerf::bench
