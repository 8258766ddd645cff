#include "core/mesh/files/ply_values.h"

#include "core/mesh/files/bytes.h"

namespace kerf {
namespace {

// Calls `use` with the value of the given type at the given address and returns its result.
template <typename Use>
auto with_value(PlyType type, const char* bytes, std::endian order, Use&& use) {
  switch (type) {
    case PlyType::kInt8:
      return use(load<int8_t>(bytes, order));
    case PlyType::kUint8:
      return use(load<uint8_t>(bytes, order));
    case PlyType::kInt16:
      return use(load<int16_t>(bytes, order));
    case PlyType::kUint16:
      return use(load<uint16_t>(bytes, order));
    case PlyType::kInt32:
      return use(load<int32_t>(bytes, order));
    case PlyType::kUint32:
      return use(load<uint32_t>(bytes, order));
    case PlyType::kInt64:
      return use(load<int64_t>(bytes, order));
    case PlyType::kUint64:
      return use(load<uint64_t>(bytes, order));
    case PlyType::kFloat32:
      return use(load<float>(bytes, order));
    case PlyType::kFloat64:
      break;
  }
  return use(load<double>(bytes, order));
}

}  // namespace

bool PlyTextValues::number(PlyType, double& value) {
  scanner_.at_end();
  const std::optional<double> number = scanner_.number();
  if (number) value = *number;
  return number.has_value();
}

bool PlyTextValues::integer(PlyType, int64_t& value) {
  scanner_.at_end();
  const std::optional<int64_t> number = scanner_.integer();
  if (number) value = *number;
  return number.has_value();
}

bool PlyTextValues::skip(PlyType type, uint64_t count) {
  double ignored = 0;
  for (uint64_t i = 0; i < count; ++i) {
    if (!number(type, ignored)) return false;
  }
  return true;
}

bool PlyTextValues::end_element() {
  if (!scanner_.at_line_end()) return false;
  scanner_.skip_line();
  return true;
}

bool PlyBinaryValues::number(PlyType type, double& value) {
  if (!can_hold(type, 1)) return false;
  value =
      with_value(type, scanner_.take(byte_size(type)), order_, [](auto v) { return static_cast<double>(v); });
  return true;
}

bool PlyBinaryValues::integer(PlyType type, int64_t& value) {
  if (!can_hold(type, 1)) return false;
  value = with_value(type, scanner_.take(byte_size(type)), order_,
                     [](auto v) { return static_cast<int64_t>(v); });
  return true;
}

bool PlyBinaryValues::skip(PlyType type, uint64_t count) {
  if (!can_hold(type, count)) return false;
  scanner_.take(count * byte_size(type));
  return true;
}

std::optional<PlyVertices> PlyBinaryValues::vertices(const PlyElement& element) {
  if (order_ != std::endian::little) return std::nullopt;
  auto rows =
      read_vertex_rows(element, scanner_.between(scanner_.position(), scanner_.position() + scanner_.left()));
  if (!rows) return std::nullopt;
  scanner_.take(rows->bytes);
  return std::move(rows->values);
}

std::optional<std::vector<Soup::Triangle>> PlyBinaryValues::triangles(const PlyElement& element) {
  if (order_ != std::endian::little) return std::nullopt;
  auto rows = read_triangle_rows(
      element, scanner_.between(scanner_.position(), scanner_.position() + scanner_.left()));
  if (!rows) return std::nullopt;
  scanner_.take(rows->bytes);
  return std::move(rows->values);
}

Error PlyBinaryValues::missing(const std::string& what) const {
  return scanner_.byte_error("the file ends where " + what + " must be; it is cut short");
}

}  // namespace kerf
