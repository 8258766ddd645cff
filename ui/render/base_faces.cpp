#include "ui/render/base_faces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "core/base/hash.h"

namespace kerf {

namespace {

constexpr double kCreaseCosine = 0.8191520442889918;  // 35 degrees
constexpr size_t kLargestFan = 512;  // corners around a position; above it faces are shaded flat

struct Corner {
  uint64_t position = 0;  // hash of its bits
  uint32_t face = 0;
  uint8_t corner = 0;
  double angle = 0;
};

uint64_t position_hash(const Vec3& p) {
  return hash_combine(hash_combine(mix64(number_bits(p.x)), number_bits(p.y)), number_bits(p.z));
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

double angle_between(const glm::dvec3& u, const glm::dvec3& w) {
  return std::acos(std::clamp(glm::dot(unit_or_zero(u), unit_or_zero(w)), -1.0, 1.0));
}

glm::vec3 flat_normal(const std::array<glm::vec3, 3>& t) {
  const glm::dvec3 a(t[0]), b(t[1]), c(t[2]);
  const glm::dvec3 n = unit_or_zero(glm::cross(b - a, c - a));
  return n == glm::dvec3(0) ? glm::vec3(0, 1, 0) : glm::vec3(n);
}

// Weights of the three corners at p; the first corner alone where the triangle has no area.
glm::dvec3 barycentric(const std::array<glm::vec3, 3>& t, const glm::vec3& p) {
  const glm::dvec3 a(t[0]), u = glm::dvec3(t[1]) - a, w = glm::dvec3(t[2]) - a, d = glm::dvec3(p) - a;
  const glm::dvec3 n = glm::cross(u, w);
  const double area2 = glm::dot(n, n);
  if (!(area2 > 0)) return {1, 0, 0};
  const double second = glm::dot(glm::cross(d, w), n) / area2, third = glm::dot(glm::cross(u, d), n) / area2;
  return {1 - second - third, second, third};
}

// Sums around one position: each corner gathers the normals of those that are smooth to it.
void smooth_fan(std::span<const Corner> fan, const std::vector<glm::dvec3>& planes,
                const std::function<void(const Corner&, const glm::dvec3&)>& put) {
  for (const Corner& c : fan) {
    const glm::dvec3 own = planes[c.face];
    glm::dvec3 sum(0);
    if (fan.size() <= kLargestFan) {
      for (const Corner& other : fan) {
        if (own == glm::dvec3(0) || glm::dot(own, planes[other.face]) >= kCreaseCosine) {
          sum += other.angle * planes[other.face];
        }
      }
    }
    put(c, sum == glm::dvec3(0) ? own : unit_or_zero(sum));
  }
}

}  // namespace

uint32_t pack_normal(const glm::vec3& n) {
  const auto ten_bits = [](float x) {
    return static_cast<uint32_t>(std::lround(std::clamp(x, -1.0f, 1.0f) * 511.0f)) & 0x3ffu;
  };
  return ten_bits(n.x) | ten_bits(n.y) << 10 | ten_bits(n.z) << 20;
}

glm::vec3 unpack_normal(uint32_t packed) {
  const auto number = [&](int shift) {
    const int bits = static_cast<int>(packed >> shift & 0x3ffu);
    return static_cast<float>(bits >= 512 ? bits - 1024 : bits) / 511.0f;
  };
  return {number(0), number(10), number(20)};
}

BaseFaces::BaseFaces(const Mesh& mesh, const FloatFrame& frame) : bases_(mesh.face_slots()) {
  std::vector<glm::dvec3> planes(bases_.size(), glm::dvec3(0));
  std::vector<Corner> corners;
  corners.reserve(3 * mesh.live_faces());
  for (uint32_t f = 0; f < bases_.size(); ++f) {
    const FaceId face(f);
    if (!mesh.is_live(face)) continue;
    const FaceData& data = mesh.data(face);
    bases_[f].known = data.halvings == 0 && data.base == face;
    const Triangle t = mesh.triangle(face);
    const std::array<glm::dvec3, 3> s{frame.scaled(t[0]), frame.scaled(t[1]), frame.scaled(t[2])};
    planes[f] = unit_or_zero(glm::cross(s[1] - s[0], s[2] - s[0]));
    for (uint8_t c = 0; c < 3; ++c) {
      bases_[f].corners[c] = glm::vec3(s[c]);
      corners.push_back(
          {position_hash(t[c]), f, c, angle_between(s[(c + 1) % 3] - s[c], s[(c + 2) % 3] - s[c])});
    }
  }
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    return std::tie(a.position, a.face, a.corner) < std::tie(b.position, b.face, b.corner);
  });
  for (size_t begin = 0; begin < corners.size();) {
    size_t end = begin;
    while (end < corners.size() && corners[end].position == corners[begin].position) ++end;
    smooth_fan(std::span(corners).subspan(begin, end - begin), planes,
               [&](const Corner& c, const glm::dvec3& n) {
                 bases_[c.face].normals[c.corner] = pack_normal(glm::vec3(n));
               });
    begin = end;
  }
}

std::array<glm::vec3, 3> BaseFaces::normals_at(FaceId base, const std::array<glm::vec3, 3>& points) const {
  const glm::vec3 flat = flat_normal(points);
  if (base.index >= bases_.size() || !bases_[base.index].known) return {flat, flat, flat};
  const Base& b = bases_[base.index];
  std::array<glm::vec3, 3> normals;
  for (size_t i = 0; i < 3; ++i) {
    const glm::vec3 weight(barycentric(b.corners, points[i]));
    const glm::vec3 n = weight.x * unpack_normal(b.normals[0]) + weight.y * unpack_normal(b.normals[1]) +
                        weight.z * unpack_normal(b.normals[2]);
    const float length = glm::length(n);
    normals[i] = length > 1e-6f ? n / length : flat;
  }
  return normals;
}

}  // namespace kerf
