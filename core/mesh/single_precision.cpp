#include "core/mesh/single_precision.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "core/base/count_text.h"
#include "core/base/length_text.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

bool is_single(MeshFormat format) {
  return format == MeshFormat::kStl || format == MeshFormat::kGlb || format == MeshFormat::kGltf;
}

size_t repeated_positions(std::span<const Vec3> positions) {
  const std::vector<uint32_t> first = weld_positions(positions);
  size_t repeated = 0;
  for (size_t i = 0; i < first.size(); ++i) repeated += first[i] != i;
  return repeated;
}

double shortest_edge(const MeshView& mesh) {
  double shortest = 0;
  for (const auto& corners : mesh.triangles) {
    for (size_t i = 0; i < 3; ++i) {
      const double length =
          glm::length(mesh.positions[corners[i]] - mesh.positions[corners[i == 2 ? 0 : i + 1]]);
      if (length > 0 && (shortest == 0 || length < shortest)) shortest = length;
    }
  }
  return shortest;
}

}  // namespace

PrecisionLoss& PrecisionLoss::operator+=(const PrecisionLoss& other) {
  largest_move = std::max(largest_move, other.largest_move);
  if (shortest_edge == 0 || (other.shortest_edge > 0 && other.shortest_edge < shortest_edge))
    shortest_edge = other.shortest_edge;
  merged += other.merged;
  vertices += other.vertices;
  return *this;
}

PrecisionLoss precision_loss(const MeshView& mesh, MeshFormat format) {
  PrecisionLoss loss;
  loss.vertices = mesh.positions.size();
  if (!is_single(format)) return loss;
  const Vec3 origin = format == MeshFormat::kStl ? Vec3(0) : gltf_middle(mesh.positions);
  std::vector<Vec3> rounded;
  rounded.reserve(mesh.positions.size());
  for (const Vec3& p : mesh.positions) {
    const Vec3 exact = p - origin;
    rounded.emplace_back(glm::vec3(exact));
    loss.largest_move = std::max(loss.largest_move, glm::length(rounded.back() - exact));
  }
  if (loss.largest_move == 0) return loss;
  loss.shortest_edge = shortest_edge(mesh);
  loss.merged = repeated_positions(rounded) - repeated_positions(mesh.positions);
  return loss;
}

std::optional<std::string> precision_note(const PrecisionLoss& loss, MeshFormat format,
                                          const std::string& advice) {
  if (!loss.matters()) return std::nullopt;
  std::string text(format_row(format).title);
  text += " holds single precision: vertices move by up to " + length_text(loss.largest_move) +
          ", where the shortest edge has " + length_text(loss.shortest_edge);
  if (loss.merged > 0) {
    text += ", and " + grouped(loss.merged) + " of " + grouped(loss.vertices) + " vertices" +
            (loss.merged == 1 ? " falls" : " fall") + " together with others";
  }
  return text + "; " + advice;
}

}  // namespace kerf
