#include "core/mesh/files/gltf_accessor.h"

#include <cassert>

#include "core/mesh/files/bytes.h"
#include "core/mesh/files/gltf_numbers.h"

namespace kerf {

namespace {

constexpr uint64_t kLongestStride = 252;

std::string accessor_place(uint32_t accessor) { return "/accessors/" + std::to_string(accessor); }

}  // namespace

Result<GltfAccessor> GltfAccessor::rows(const GltfFile& file, uint32_t accessor, const char* type,
                                        uint64_t row) {
  const nlohmann::json& json = file.element("accessors", accessor);
  const std::string where = accessor_place(accessor);
  if (json.contains("sparse")) return file.wrong(where, "is sparse, which is not read; export it dense");
  if (!json.contains("type") || json["type"] != type)
    return file.wrong(where + "/type", std::string("must be ") + type);
  const auto view_index = file.index(json, "bufferView", "bufferViews", where);
  if (!view_index) return view_index.error();
  if (!*view_index) return file.wrong(where + "/bufferView", "is missing, so that there are no data");
  const auto view = file.view(**view_index);
  if (!view) return view.error();
  const auto offset = file.whole(json, "byteOffset", 0, where), count = file.whole(json, "count", 0, where);
  if (!offset) return offset.error();
  if (!count) return count.error();
  const uint64_t stride = view->stride == 0 ? row : view->stride;
  if (stride < row || stride > kLongestStride)
    return file.wrong("/bufferViews/" + std::to_string(**view_index) + "/byteStride",
                      "must be from " + std::to_string(row) + " to 252");
  GltfAccessor rows;
  if (*count == 0) return rows;
  const uint64_t room = *offset < view->bytes.size() ? view->bytes.size() - *offset : 0;
  if (room < row || (room - row) / stride < *count - 1) {
    return file.wrong(where, "announces " + std::to_string(*count) + " elements, but the " +
                                 std::to_string(view->bytes.size()) + " bytes of its view cannot hold them");
  }
  rows.bytes_ = view->bytes.substr(*offset);
  rows.size_ = *count;
  rows.stride_ = stride;
  rows.width_ = row;
  return rows;
}

Result<GltfAccessor> GltfAccessor::positions(const GltfFile& file, uint32_t accessor) {
  const auto kind =
      file.whole(file.element("accessors", accessor), "componentType", 0, accessor_place(accessor));
  if (!kind) return kind.error();
  if (*kind != kGltfFloat)
    return file.wrong(accessor_place(accessor),
                      "holds quantised positions, which are not read; export them as floats");
  return rows(file, accessor, "VEC3", 3 * sizeof(float));
}

Result<GltfAccessor> GltfAccessor::indices(const GltfFile& file, uint32_t accessor) {
  const auto kind =
      file.whole(file.element("accessors", accessor), "componentType", 0, accessor_place(accessor));
  if (!kind) return kind.error();
  if (*kind != kGltfByte && *kind != kGltfShort && *kind != kGltfInt)
    return file.wrong(accessor_place(accessor) + "/componentType", "must be 5121, 5123 or 5125 for indices");
  return rows(file, accessor, "SCALAR", *kind == kGltfByte ? 1 : *kind == kGltfShort ? 2 : 4);
}

Result<GltfAccessor> GltfAccessor::colours(const GltfFile& file, uint32_t accessor) {
  const nlohmann::json& json = file.element("accessors", accessor);
  const auto kind = file.whole(json, "componentType", 0, accessor_place(accessor));
  if (!kind) return kind.error();
  if (*kind != kGltfFloat && *kind != kGltfByte && *kind != kGltfShort)
    return file.wrong(accessor_place(accessor) + "/componentType", "must be 5121, 5123 or 5126 for colours");
  const size_t parts = json.contains("type") && json["type"] == "VEC4" ? 4 : 3;
  auto colours = rows(file, accessor, parts == 4 ? "VEC4" : "VEC3",
                      parts * (*kind == kGltfByte    ? 1
                               : *kind == kGltfShort ? 2
                                                     : sizeof(float)));
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

Vec3 GltfAccessor::position(size_t i) const {
  assert(i < size_ && width_ == 3 * sizeof(float));
  const char* at = bytes_.data() + i * stride_;
  Vec3 p;
  for (int k = 0; k < 3; ++k, at += sizeof(float)) p[k] = load<float>(at, std::endian::little);
  return p;
}

uint32_t GltfAccessor::index(size_t i) const {
  assert(i < size_ && width_ <= 4);
  const char* at = bytes_.data() + i * stride_;
  if (width_ == 1) return static_cast<uint8_t>(*at);
  return width_ == 2 ? load<uint16_t>(at, std::endian::little) : load<uint32_t>(at, std::endian::little);
}

}  // namespace kerf
