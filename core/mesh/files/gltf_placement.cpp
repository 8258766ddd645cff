#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "core/mesh/files/gltf_file_internal.h"

namespace kerf {

namespace {

// Reads kCount finite numbers; `missing` if there is no such member.
template <size_t kCount>
Result<std::array<double, kCount>> finite_numbers(const GltfFile& file, const nlohmann::json& of,
                                                  const char* key, const std::string& where,
                                                  const std::array<double, kCount>& missing) {
  const auto at = of.find(key);
  if (at == of.end()) return missing;
  std::array<double, kCount> found{};
  const auto is_finite = [](const nlohmann::json& n) {
    return n.is_number() && std::isfinite(n.get<double>());
  };
  if (!at->is_array() || at->size() != kCount || !std::all_of(at->begin(), at->end(), is_finite))
    return file.wrong(where + "/" + key, "must be " + std::to_string(kCount) + " finite numbers");
  for (size_t i = 0; i < kCount; ++i) found[i] = (*at)[i].template get<double>();
  return found;
}

// Returns the matrix that scales, then rotates, then translates. Precondition: the rotation, with the scalar
// part last, is not zero.
GltfMatrix composed(const Vec3& translation, const glm::dvec4& rotation, const Vec3& scale) {
  const glm::dquat q(rotation[3], rotation[0], rotation[1], rotation[2]);
  const glm::dmat3 turn = glm::mat3_cast(glm::normalize(q));
  GltfMatrix matrix(1);
  for (int k = 0; k < 3; ++k) matrix[k] = glm::dvec4(turn[k] * scale[k], 0);
  matrix[3] = glm::dvec4(translation, 1);
  return matrix;
}

bool has_finite_elements(const GltfMatrix& matrix) {
  for (int i = 0; i < 16; ++i) {
    if (!std::isfinite(matrix[i / 4][i % 4])) return false;
  }
  return true;
}

// Reads an attribute of the instances; nullopt if it is missing.
Result<std::optional<GltfAccessor>> instance_values(const GltfFile& file, const nlohmann::json& attributes,
                                                    const char* name, size_t parts,
                                                    const std::string& where) {
  const auto index = file.index(attributes, name, "accessors", where);
  if (!index) return index.error();
  if (!*index) return std::optional<GltfAccessor>();
  if (!file.element("accessors", **index).contains("bufferView"))
    return file.wrong(where + "/" + name, "refers to an accessor without a buffer view");
  auto values = GltfAccessor::vectors(file, **index, parts);
  if (!values) return values.error();
  return std::optional(std::move(*values));
}

}  // namespace

Result<GltfMatrix> gltf_transform(const GltfFile& file, const nlohmann::json& node,
                                  const std::string& where) {
  const auto whole =
      finite_numbers<16>(file, node, "matrix", where, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  const auto moved = finite_numbers<3>(file, node, "translation", where, {0, 0, 0});
  const auto turned = finite_numbers<4>(file, node, "rotation", where, {0, 0, 0, 1});
  const auto scaled = finite_numbers<3>(file, node, "scale", where, {1, 1, 1});
  if (!whole) return whole.error();
  if (!moved) return moved.error();
  if (!turned) return turned.error();
  if (!scaled) return scaled.error();
  if (node.contains("matrix")) {
    GltfMatrix matrix(1);
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = (*whole)[static_cast<size_t>(i)];
    return matrix;
  }
  const glm::dvec4 rotation((*turned)[0], (*turned)[1], (*turned)[2], (*turned)[3]);
  if (!(glm::dot(rotation, rotation) > 0)) return file.wrong(where + "/rotation", "must not be zero");
  return composed({(*moved)[0], (*moved)[1], (*moved)[2]}, rotation,
                  {(*scaled)[0], (*scaled)[1], (*scaled)[2]});
}

Result<std::vector<GltfMatrix>> gltf_instances(const GltfFile& file, const nlohmann::json& node,
                                               const std::string& of, const GltfMatrix& to_scene,
                                               size_t max_instances) {
  std::vector<GltfMatrix> instances{to_scene};
  const auto extensions = node.find("extensions");
  if (extensions == node.end() || !extensions->is_object() || !extensions->contains(kGltfInstancing))
    return instances;
  const nlohmann::json& extension = (*extensions)[kGltfInstancing];
  const std::string where = of + "/extensions/" + kGltfInstancing + "/attributes";
  if (!extension.is_object() || !extension.contains("attributes") || !extension["attributes"].is_object())
    return file.wrong(where, "is missing");
  const nlohmann::json& attributes = extension["attributes"];
  const auto moved = instance_values(file, attributes, "TRANSLATION", 3, where);
  const auto turned = instance_values(file, attributes, "ROTATION", 4, where);
  const auto scaled = instance_values(file, attributes, "SCALE", 3, where);
  std::optional<size_t> count;
  for (const auto* values : {&moved, &turned, &scaled}) {
    if (!*values) return values->error();
    if (!**values) continue;
    if (count.value_or((**values)->size()) != (**values)->size())
      return file.wrong(where, "must have the same number of TRANSLATION, ROTATION and SCALE values");
    count = (**values)->size();
  }
  if (!count) return file.wrong(where, "has no TRANSLATION, ROTATION or SCALE");
  if (*count > max_instances)
    return file.wrong(where, "exceeds the maximum number of instances per glTF file");
  instances.clear();
  for (size_t i = 0; i < *count; ++i) {
    const glm::dvec4 rotation = *turned ? (*turned)->vector(i) : glm::dvec4(0, 0, 0, 1);
    const Vec3 translation = *moved ? Vec3((*moved)->vector(i)) : Vec3(0);
    const Vec3 scale = *scaled ? Vec3((*scaled)->vector(i)) : Vec3(1);
    instances.push_back(to_scene * composed(translation, rotation, scale));
    if (!(glm::dot(rotation, rotation) > 0) || !has_finite_elements(instances.back()))
      return file.wrong(where, "has the unusable instance " + std::to_string(i));
  }
  return instances;
}

}  // namespace kerf
