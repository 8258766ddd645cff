#include "core/mesh/files/ply_rows.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "core/base/parallel.h"
#include "core/mesh/files/bytes.h"

namespace kerf {

namespace {

constexpr size_t kRows = 1 << 14;  // a range
constexpr auto kLittle = std::endian::little;

bool is_scalar(const PlyProperty& p) { return !p.count_type; }

// Where the scalars x, y and z lie in a row.
struct PositionRow {
  std::array<size_t, 3> at{};
  size_t bytes = 0;
  PlyType type = PlyType::kFloat32;
};

std::optional<PositionRow> position_row(const PlyElement& element) {
  PositionRow row;
  std::array<std::optional<PlyType>, 3> types;
  for (const PlyProperty& p : element.properties) {
    if (!is_scalar(p)) return std::nullopt;
    if (p.name == "x" || p.name == "y" || p.name == "z") {
      const auto axis = static_cast<size_t>(p.name[0] - 'x');
      row.at[axis] = row.bytes;
      types[axis] = p.type;
    }
    row.bytes += byte_size(p.type);
  }
  if (!types[0] || types[1] != types[0] || types[2] != types[0] || is_integer(*types[0])) return std::nullopt;
  row.type = *types[0];
  return row;
}

template <typename Number>
void load_positions(const PositionRow& row, std::string_view bytes, std::vector<Vec3>& positions) {
  for_each_range(positions.size(), kRows, [&](size_t i, size_t end) {
    for (const char* at = bytes.data() + i * row.bytes; i < end; ++i, at += row.bytes) {
      positions[i] = {load<Number>(at + row.at[0], kLittle), load<Number>(at + row.at[1], kLittle),
                      load<Number>(at + row.at[2], kLittle)};
    }
  });
}

bool has_eight_bits(const PlyElement& element, const std::array<size_t, 4>& colours) {
  return std::all_of(colours.begin(), colours.end(), [&](size_t i) {
    return i == kNoProperty || element.properties[i].type == PlyType::kUint8;
  });
}

void load_colours(const PlyElement& element, const std::array<size_t, 4>& properties, size_t row_bytes,
                  std::string_view bytes, std::vector<VertexColour>& colours) {
  std::vector<size_t> starts{0};  // of the properties in a row
  for (const PlyProperty& p : element.properties) starts.push_back(starts.back() + byte_size(p.type));
  for_each_range(colours.size(), kRows, [&](size_t i, size_t end) {
    for (const char* at = bytes.data() + i * row_bytes; i < end; ++i, at += row_bytes) {
      for (size_t k = 0; k < properties.size(); ++k) {
        if (properties[k] == kNoProperty) continue;
        const auto byte = static_cast<uint8_t>(at[starts[properties[k]]]);
        colours[i].part[k] = static_cast<uint16_t>(257u * byte);
      }
    }
  });
}

// Where the list of corners lies in a row in which it has three entries.
struct TriangleRow {
  size_t list_at = 0, bytes = 0;
};

std::optional<TriangleRow> triangle_row(const PlyElement& element) {
  TriangleRow row;
  size_t lists = 0;
  for (const PlyProperty& p : element.properties) {
    if (is_scalar(p)) {
      row.bytes += byte_size(p.type);
      continue;
    }
    const bool usual =
        p.count_type == PlyType::kUint8 && (p.type == PlyType::kInt32 || p.type == PlyType::kUint32);
    if (!usual || ++lists > 1) return std::nullopt;
    row.list_at = row.bytes;
    row.bytes += 1 + sizeof(Soup::Triangle);
  }
  if (lists == 0) return std::nullopt;
  return row;
}

bool fits(const PlyElement& element, size_t row_bytes, std::string_view bytes) {
  return element.count <= bytes.size() / row_bytes;
}

}  // namespace

std::optional<std::array<size_t, 4>> colour_properties_of(const PlyElement& element) {
  constexpr std::array<std::string_view, 4> kNames{"red", "green", "blue", "alpha"};
  constexpr std::string_view kPrefix = "diffuse_";
  std::array<size_t, 4> found;
  found.fill(kNoProperty);
  for (size_t i = 0; i < element.properties.size(); ++i) {
    std::string_view name = element.properties[i].name;
    if (name.starts_with(kPrefix)) name.remove_prefix(kPrefix.size());
    const auto at = std::find(kNames.begin(), kNames.end(), name);
    if (at != kNames.end() && is_scalar(element.properties[i]))
      found[static_cast<size_t>(at - kNames.begin())] = i;
  }
  const bool whole = std::count(found.begin(), found.begin() + VertexColour::kOpacity, kNoProperty) == 0;
  return whole ? std::optional(found) : std::nullopt;
}

std::optional<PlyVertexRows> read_vertex_rows(const PlyElement& element, std::string_view bytes) {
  const auto row = position_row(element);
  if (!row || !fits(element, row->bytes, bytes)) return std::nullopt;
  const auto colours = colour_properties_of(element);
  if (colours && !has_eight_bits(element, *colours)) return std::nullopt;
  PlyVertexRows rows{{std::vector<Vec3>(element.count), {}}, element.count * row->bytes};
  if (row->type == PlyType::kFloat32)
    load_positions<float>(*row, bytes, rows.values.positions);
  else
    load_positions<double>(*row, bytes, rows.values.positions);
  if (colours) {
    rows.values.colours.resize(element.count);
    load_colours(element, *colours, row->bytes, bytes, rows.values.colours);
  }
  return rows;
}

std::optional<PlyRows<Soup::Triangle>> read_triangle_rows(const PlyElement& element, std::string_view bytes) {
  const auto row = triangle_row(element);
  if (!row || !fits(element, row->bytes, bytes)) return std::nullopt;
  PlyRows<Soup::Triangle> rows{std::vector<Soup::Triangle>(element.count), element.count * row->bytes};
  std::atomic<bool> all_triangles = true;
  for_each_range(element.count, kRows, [&](size_t i, size_t end) {
    const char* at = bytes.data() + i * row->bytes + row->list_at;
    for (; i < end && *at == 3; ++i, at += row->bytes) {
      for (size_t k = 0; k < 3; ++k) rows.values[i][k] = load<uint32_t>(at + 1 + 4 * k, kLittle);
    }
    if (i < end) all_triangles = false;
  });
  if (!all_triangles) return std::nullopt;
  return rows;
}

}  // namespace kerf
