#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "core/base/containers.h"
#include "core/base/random.h"
#include "core/mesh/files/encode.h"

namespace kerf {

// The vertices of a file with one value per vertex of each kind of looks: positions that differ in one are
// separate. A kind that the mesh lacks is empty. UVs and attributes of faces without any are 0, normals that
// of the face, and tangents a direction across the normal.
class SplitVertices {
 public:
  std::vector<std::array<uint32_t, 3>> own_triangles;  // of the vertices; empty if those of the mesh are
  std::vector<uint32_t> positions;                     // by vertex; empty: vertices are positions
  std::vector<std::vector<glm::vec2>> uv_sets;         // each by vertex
  std::vector<glm::vec3> normals;                      // by vertex
  std::vector<glm::vec4> tangents;                     // by vertex
  std::vector<std::vector<glm::vec4>> attributes;      // each by vertex

  // `v_points_down`: as in CornerLooks, for the UVs here.
  SplitVertices(const MeshView& mesh, bool v_points_down, bool with_tangents)
      : v_points_down_(v_points_down) {
    if (!mesh.looks || !mesh.looks->any()) return;
    looks_ = mesh.looks;
    has_normals_ = looks_->normals.any();
    has_tangents_ = with_tangents && looks_->tangents.any();
    uv_sets.resize(looks_->uv_sets.size());
    attributes.resize(looks_->attributes.size());
    KeyTable table;
    own_triangles.reserve(mesh.triangles.size());
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      auto& own = own_triangles.emplace_back();
      for (size_t i = 0; i < 3; ++i) own[i] = vertex(mesh, t, i, table);
    }
  }

  std::span<const std::array<uint32_t, 3>> triangles(const MeshView& mesh) const {
    return positions.empty() ? mesh.triangles : std::span<const std::array<uint32_t, 3>>(own_triangles);
  }
  size_t count(const MeshView& mesh) const {
    return positions.empty() ? mesh.positions.size() : positions.size();
  }
  uint32_t position(size_t vertex) const {
    return positions.empty() ? static_cast<uint32_t>(vertex) : positions[vertex];
  }

 private:
  uint32_t vertex(const MeshView& mesh, size_t t, size_t i, KeyTable& table) {
    constexpr uint32_t kNone = LookChannel<glm::vec3>::kNone;
    const auto next = static_cast<uint32_t>(positions.size());
    positions.push_back(mesh.triangles[t][i]);
    for (size_t set = 0; set < uv_sets.size(); ++set) {
      const LookChannel<glm::vec2>& channel = looks_->uv_sets[set];
      const bool known = channel.corners[t][i] != kNone;
      const glm::vec2 uv = known ? channel.values[channel.corners[t][i]] : glm::vec2(0);
      uv_sets[set].push_back({uv.x, known && looks_->v_points_down != v_points_down_ ? 1 - uv.y : uv.y});
    }
    if (has_normals_) {
      const uint32_t known = looks_->normals.corners[t][i];
      normals.push_back(known != kNone ? looks_->normals.values[known] : plane(mesh, t));
    }
    if (has_tangents_) {
      const uint32_t known = looks_->tangents.corners[t][i];
      const glm::vec3 normal = has_normals_ ? normals.back() : plane(mesh, t);
      tangents.push_back(known != kNone ? looks_->tangents.values[known] : any_tangent(normal));
    }
    for (size_t a = 0; a < attributes.size(); ++a) {
      const LookChannel<glm::vec4>& channel = looks_->attributes[a].channel;
      const uint32_t known = channel.corners[t][i];
      attributes[a].push_back(known != kNone ? channel.values[known] : glm::vec4(0));
    }
    const uint32_t found = table.find_or_add(
        hash(next), next, [&](uint32_t other) { return same(other, next); },
        [&](uint32_t other) { return hash(other); });
    if (found == next) return next;
    positions.pop_back();
    for (auto& set : uv_sets) set.pop_back();
    if (has_normals_) normals.pop_back();
    if (has_tangents_) tangents.pop_back();
    for (auto& values : attributes) values.pop_back();
    return found;
  }

  static glm::vec3 plane(const MeshView& mesh, size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3 across = unit_normal(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    return across == Vec3(0) ? glm::vec3(0, 1, 0) : glm::vec3(across);
  }
  static glm::vec4 any_tangent(const glm::vec3& normal) {
    const Vec3 n(normal);
    const Vec3 axis = std::abs(n.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    return glm::vec4(glm::vec3(glm::normalize(axis - glm::dot(axis, n) * n)), 1);
  }
  bool same(uint32_t a, uint32_t b) const {
    const auto is_same = [&](const auto& values) { return values[a] == values[b]; };
    return positions[a] == positions[b] && (normals.empty() || is_same(normals)) &&
           (tangents.empty() || is_same(tangents)) && std::all_of(uv_sets.begin(), uv_sets.end(), is_same) &&
           std::all_of(attributes.begin(), attributes.end(), is_same);
  }
  uint64_t hash(uint32_t v) const {
    uint64_t key = mix64(positions[v]);
    for (const auto& set : uv_sets) {
      for (int k = 0; k < 2; ++k) key = hash_combine(key, number_bits(set[v][k]));
    }
    for (int k = 0; k < 3 && has_normals_; ++k) key = hash_combine(key, number_bits(normals[v][k]));
    for (int k = 0; k < 4 && !tangents.empty(); ++k) key = hash_combine(key, number_bits(tangents[v][k]));
    for (const auto& values : attributes) {
      for (int k = 0; k < 4; ++k) key = hash_combine(key, number_bits(values[v][k]));
    }
    return key;
  }

  bool v_points_down_;
  bool has_normals_ = false, has_tangents_ = false;
  const CornerLooks* looks_ = nullptr;
};

}  // namespace kerf
