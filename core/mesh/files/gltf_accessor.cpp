#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "core/mesh/files/bytes.h"
#include "core/mesh/files/gltf_file_internal.h"

namespace kerf {

namespace {

constexpr uint64_t kMaxStride = 252;

std::string accessor_place(uint32_t accessor) { return "/accessors/" + std::to_string(accessor); }

constexpr std::array<const char*, 4> kVectorTypes{"SCALAR", "VEC2", "VEC3", "VEC4"};

// Returns the number of bytes of a component; 0 for an unknown type.
uint64_t component_bytes(uint64_t component) {
  if (component == kGltfByte || component == kGltfSignedByte) return 1;
  if (component == kGltfShort || component == kGltfSignedShort) return 2;
  return component == kGltfInt || component == kGltfFloat ? 4 : 0;
}

Result<uint64_t> component_of(const GltfFile& file, uint32_t accessor) {
  return file.whole(file.element("accessors", accessor), "componentType", 0, accessor_place(accessor));
}

uint32_t whole_number(const char* at, size_t bytes) {
  if (bytes == 1) return static_cast<uint8_t>(*at);
  return bytes == 2 ? load<uint16_t>(at, std::endian::little) : load<uint32_t>(at, std::endian::little);
}

// Returns the bytes of `count` rows of a member of a sparse accessor: its indices, or its values.
Result<std::string_view> sparse_bytes(const GltfFile& file, const nlohmann::json& sparse, const char* key,
                                      const std::string& of, uint64_t count, uint64_t row) {
  const std::string where = of + "/" + key;
  const auto json = sparse.find(key);
  if (json == sparse.end() || !json->is_object()) return file.wrong(where, "is missing");
  const auto view_index = file.index(*json, "bufferView", "bufferViews", where);
  if (!view_index) return view_index.error();
  if (!*view_index) return file.wrong(where + "/bufferView", "is missing");
  const auto view = file.view(**view_index);
  if (!view) return view.error();
  const auto offset = file.whole(*json, "byteOffset", 0, where);
  if (!offset) return offset.error();
  const uint64_t room = *offset < view->bytes.size() ? view->bytes.size() - *offset : 0;
  if (room / row < count) {
    return file.wrong(where, "declares " + std::to_string(count) + " elements, but the " +
                                 std::to_string(view->bytes.size()) + " bytes of its view cannot hold them");
  }
  return view->bytes.substr(std::min<uint64_t>(*offset, view->bytes.size()), count * row);
}

}  // namespace

Result<GltfAccessor> GltfAccessor::dense_rows(const GltfFile& file, const nlohmann::json& json,
                                              const std::string& where, const Row& row) {
  const auto count = file.whole(json, "count", 0, where);
  if (!count) return count.error();
  const auto view_index = file.index(json, "bufferView", "bufferViews", where);
  if (!view_index) return view_index.error();
  GltfAccessor rows;
  rows.size_ = *count;
  rows.stride_ = rows.width_ = row.bytes;
  if (!*view_index) {
    if (!json.contains("sparse"))
      return file.wrong(where + "/bufferView", "is missing; the accessor has no data");
    // Otherwise a small file could take any amount of memory.
    if (*count > file.buffer_bytes())
      return file.wrong(where, "is sparse without a view, and has more elements than the buffers have bytes");
    return rows;
  }
  const auto view = file.view(**view_index);
  if (!view) return view.error();
  const auto offset = file.whole(json, "byteOffset", 0, where);
  if (!offset) return offset.error();
  const uint64_t stride = view->stride == 0 ? row.bytes : view->stride;
  if (stride < row.bytes || stride > kMaxStride)
    return file.wrong("/bufferViews/" + std::to_string(**view_index) + "/byteStride",
                      "must be from " + std::to_string(row.bytes) + " to 252");
  if (*count == 0) return rows;
  const uint64_t room = *offset < view->bytes.size() ? view->bytes.size() - *offset : 0;
  if (room < row.bytes || (room - row.bytes) / stride < *count - 1) {
    return file.wrong(where, "declares " + std::to_string(*count) + " elements, but the " +
                                 std::to_string(view->bytes.size()) + " bytes of its view cannot hold them");
  }
  rows.bytes_ = view->bytes.substr(*offset);
  rows.stride_ = stride;
  return rows;
}

std::optional<Error> GltfAccessor::replace_sparse(const GltfFile& file, const nlohmann::json& sparse,
                                                  const std::string& where, const Row& row) {
  if (!sparse.is_object()) return file.wrong(where, "must be an object");
  const auto count = file.whole(sparse, "count", 0, where);
  if (!count) return count.error();
  const auto of_indices = sparse.find("indices");
  const nlohmann::json none = nlohmann::json::object();
  const bool listed = of_indices != sparse.end() && of_indices->is_object();
  const auto component = file.whole(listed ? *of_indices : none, "componentType", 0, where + "/indices");
  if (!component) return component.error();
  if (*component != kGltfByte && *component != kGltfShort && *component != kGltfInt)
    return file.wrong(where + "/indices/componentType", "must be 5121, 5123 or 5125");
  const uint64_t width = component_bytes(*component);
  const auto indices = sparse_bytes(file, sparse, "indices", where, *count, width);
  if (!indices) return indices.error();
  const auto values = sparse_bytes(file, sparse, "values", where, *count, row.bytes);
  if (!values) return values.error();
  std::string own(size_ * row.bytes, '\0');
  for (size_t i = 0; i < size_ && !bytes_.empty(); ++i)
    bytes_.copy(own.data() + i * row.bytes, row.bytes, i * stride_);
  for (size_t i = 0; i < *count; ++i) {
    const uint64_t at = whole_number(indices->data() + i * width, width);
    if (at >= size_) {
      return file.wrong(where + "/indices", "has the number " + std::to_string(at) + ", but there are " +
                                                std::to_string(size_) + " elements");
    }
    values->copy(own.data() + at * row.bytes, row.bytes, i * row.bytes);
  }
  owned_ = std::make_shared<const std::string>(std::move(own));
  bytes_ = *owned_;
  stride_ = row.bytes;
  return std::nullopt;
}

Result<GltfAccessor> GltfAccessor::rows(const GltfFile& file, uint32_t accessor, const Row& row) {
  const nlohmann::json& json = file.element("accessors", accessor);
  const std::string where = accessor_place(accessor);
  if (!json.contains("type") || json["type"] != row.type)
    return file.wrong(where + "/type", std::string("must be ") + row.type);
  auto rows = dense_rows(file, json, where, row);
  if (!rows || !json.contains("sparse")) return rows;
  if (auto problem = rows->replace_sparse(file, json["sparse"], where + "/sparse", row)) return *problem;
  return rows;
}

Result<GltfAccessor> GltfAccessor::indices(const GltfFile& file, uint32_t accessor) {
  const auto component = component_of(file, accessor);
  if (!component) return component.error();
  if (*component != kGltfByte && *component != kGltfShort && *component != kGltfInt)
    return file.wrong(accessor_place(accessor) + "/componentType", "must be 5121, 5123 or 5125 for indices");
  return rows(file, accessor, {"SCALAR", component_bytes(*component)});
}

uint32_t GltfAccessor::index(size_t i) const {
  assert(i < size_ && width_ <= 4);
  return whole_number(bytes_.data() + i * stride_, width_);
}

Result<GltfAccessor> GltfAccessor::colours(const GltfFile& file, uint32_t accessor) {
  const auto component = component_of(file, accessor);
  if (!component) return component.error();
  if (*component != kGltfFloat && *component != kGltfByte && *component != kGltfShort)
    return file.wrong(accessor_place(accessor) + "/componentType", "must be 5121, 5123 or 5126 for colours");
  const nlohmann::json& json = file.element("accessors", accessor);
  const size_t parts = json.contains("type") && json["type"] == "VEC4" ? 4 : 3;
  auto colours = rows(file, accessor, {kVectorTypes[parts - 1], parts * component_bytes(*component)});
  if (colours) colours->parts_ = parts;
  return colours;
}

VertexColour GltfAccessor::colour(size_t i) const {
  assert(i < size_ && parts_ > 0);
  const char* at = bytes_.data() + i * stride_;
  const size_t bytes = width_ / parts_;
  VertexColour colour;
  for (size_t k = 0; k < parts_; ++k, at += bytes) {
    const double fraction = bytes == 1   ? static_cast<uint8_t>(*at) / 255.0
                            : bytes == 2 ? fraction_of(load<uint16_t>(at, std::endian::little))
                                         : load<float>(at, std::endian::little);
    colour.part[k] = k == VertexColour::kOpacity ? colour_part(fraction) : part_of_linear(fraction);
  }
  return colour;
}

Result<GltfAccessor> GltfAccessor::vectors(const GltfFile& file, uint32_t accessor, size_t parts) {
  assert(parts >= 1 && parts <= kVectorTypes.size());
  const auto component = component_of(file, accessor);
  if (!component) return component.error();
  if (component_bytes(*component) == 0 || *component == kGltfInt)
    return file.wrong(accessor_place(accessor) + "/componentType", "must be 5120 to 5123 or 5126");
  auto vectors = rows(file, accessor, {kVectorTypes[parts - 1], parts * component_bytes(*component)});
  if (!vectors) return vectors;
  const nlohmann::json& json = file.element("accessors", accessor);
  const auto normalised = json.find("normalized");
  vectors->parts_ = parts;
  vectors->component_ = *component;
  vectors->is_normalised_ = normalised != json.end() && normalised->is_boolean() && normalised->get<bool>();
  return vectors;
}

Result<GltfAccessor> GltfAccessor::vectors(const GltfFile& file, uint32_t accessor) {
  const nlohmann::json& json = file.element("accessors", accessor);
  for (size_t parts = 1; parts <= kVectorTypes.size(); ++parts) {
    if (json.contains("type") && json["type"] == kVectorTypes[parts - 1])
      return vectors(file, accessor, parts);
  }
  return file.wrong(accessor_place(accessor) + "/type", "must be SCALAR, VEC2, VEC3 or VEC4");
}

glm::dvec4 GltfAccessor::vector(size_t i) const {
  assert(i < size_ && parts_ > 0 && parts_ <= 4);
  const char* at = bytes_.data() + i * stride_;
  const size_t bytes = width_ / parts_;
  const bool is_signed = component_ == kGltfSignedByte || component_ == kGltfSignedShort;
  glm::dvec4 v(0);
  for (size_t k = 0; k < parts_; ++k, at += bytes) {
    double& number = v[static_cast<int>(k)];
    if (component_ == kGltfFloat) {
      number = load<float>(at, std::endian::little);
    } else if (is_signed) {
      number = bytes == 1 ? static_cast<int8_t>(*at) : load<int16_t>(at, std::endian::little);
      if (is_normalised_) number = std::max(number / (bytes == 1 ? 127.0 : 32767.0), -1.0);
    } else {
      number = whole_number(at, bytes);
      if (is_normalised_) number /= bytes == 1 ? 255.0 : 65535.0;
    }
  }
  return v;
}

}  // namespace kerf
