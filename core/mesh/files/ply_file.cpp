#include "core/mesh/files/ply_file.h"

#include <algorithm>
#include <atomic>
#include <set>
#include <utility>

#include "core/base/parallel.h"
#include "core/mesh/files/bytes.h"

namespace kerf {

namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 18> kTypeNames{{
    {"char", PlyType::kInt8},
    {"int8", PlyType::kInt8},
    {"uchar", PlyType::kUint8},
    {"uint8", PlyType::kUint8},
    {"short", PlyType::kInt16},
    {"int16", PlyType::kInt16},
    {"ushort", PlyType::kUint16},
    {"uint16", PlyType::kUint16},
    {"int", PlyType::kInt32},
    {"int32", PlyType::kInt32},
    {"uint", PlyType::kUint32},
    {"uint32", PlyType::kUint32},
    {"int64", PlyType::kInt64},
    {"uint64", PlyType::kUint64},
    {"float", PlyType::kFloat32},
    {"float32", PlyType::kFloat32},
    {"double", PlyType::kFloat64},
    {"float64", PlyType::kFloat64},
}};

std::optional<PlyType> type_named(std::string_view name) {
  const auto found = std::find_if(kTypeNames.begin(), kTypeNames.end(),
                                  [&](const auto& entry) { return entry.first == name; });
  if (found == kTypeNames.end()) return std::nullopt;
  return found->second;
}

bool is_binary(char c) {
  const bool control = static_cast<unsigned char>(c) < ' ' || c == 0x7f;
  return control && c != '\t' && c != '\r' && c != '\n';
}

class HeaderReader {
 public:
  explicit HeaderReader(Scanner& scanner) : scanner_(scanner) {}

  Result<PlyHeader> read() {
    if (scanner_.word() != "ply") return scanner_.expected("'ply'");
    scanner_.at_line_end();
    const bool has_cr_lines = at_lone_cr();
    scanner_.skip_line();
    for (;;) {
      if (scanner_.at_end()) {
        if (header_.elements.empty() && stray_error_) return *stray_error_;
        return scanner_.file_error("the header has no 'end_header'; the file is truncated");
      }
      line_begin_ = scanner_.position();
      const std::string_view keyword = scanner_.word();
      if (keyword == "end_header") break;
      if (auto problem = read_line(keyword)) return *problem;
      scanner_.skip_line();
    }
    if (header_.elements.empty() && stray_error_) return *stray_error_;
    if (!has_format_) return scanner_.line_error("the header has no 'format'");
    skip_to_data(has_cr_lines);
    if (auto problem = check_counts()) return *problem;
    record_stray_lines();
    return std::move(header_);
  }

 private:
  using Problem = std::optional<Error>;

  Problem read_line(std::string_view keyword) {
    if (keyword == "format") return read_format();
    if (keyword == "element") return read_element();
    if (keyword == "property") return read_property();
    if (keyword == "comment") read_comment();
    if (keyword == "comment" || keyword == "obj_info") return std::nullopt;
    return pass_over_stray_line();
  }

  bool at_byte(size_t ahead, char c) const {
    const size_t at = scanner_.position() + ahead;
    return ahead < scanner_.left() && scanner_.between(at, at + 1).front() == c;
  }
  bool at_lone_cr() const { return at_byte(0, '\r') && !at_byte(1, '\n'); }

  // Ends the line of the last keyword. If lines end with CR alone, an LF after it is data.
  void skip_to_data(bool has_cr_lines) {
    scanner_.at_line_end();
    if (has_cr_lines && at_byte(0, '\r')) {
      scanner_.take(1);
    } else {
      scanner_.skip_line();
    }
  }

  void read_comment() {
    if (scanner_.word() != "TextureFile") return;
    const std::string name(scanner_.rest_of_line());
    if (name.empty()) return;
    if (header_.textures++ == 0) header_.texture_file = name;
  }

  Problem read_format() {
    const std::string_view name = scanner_.word();
    if (name == "ascii") {
      header_.encoding = PlyEncoding::kText;
    } else if (name == "binary_little_endian") {
      header_.encoding = PlyEncoding::kLittleEndian;
    } else if (name == "binary_big_endian") {
      header_.encoding = PlyEncoding::kBigEndian;
    } else {
      return scanner_.expected("'ascii', 'binary_little_endian' or 'binary_big_endian'");
    }
    if (scanner_.word() != "1.0") return scanner_.expected("version 1.0");
    has_format_ = true;
    return std::nullopt;
  }

  Problem read_element() {
    const std::string_view name = scanner_.word();
    if (name.empty()) return scanner_.expected("the name of an element");
    if (!names_.emplace(name).second)
      return scanner_.line_error("declares the element " + in_quotes(name) + " twice");
    const std::optional<int64_t> count = scanner_.integer();
    if (!count) return scanner_.expected("the number of elements");
    if (*count < 0) return scanner_.line_error("declares " + std::to_string(*count) + " elements");
    header_.elements.push_back({std::string(name), static_cast<uint64_t>(*count), {}});
    return std::nullopt;
  }

  Problem read_property() {
    if (header_.elements.empty()) {
      if (stray_error_) return stray_error_;
      return scanner_.line_error("a property comes before the first element");
    }
    PlyProperty property;
    const size_t before = scanner_.position();
    if (scanner_.word() == "list") {
      PlyType count_type{};
      if (auto problem = read_type(count_type)) return problem;
      if (!is_integer(count_type)) return scanner_.expected("an integer type");
      property.count_type = count_type;
    } else {
      scanner_.seek(before);
    }
    if (auto problem = read_type(property.type)) return problem;
    property.name = scanner_.word();
    if (property.name.empty()) return scanner_.expected("the name of a property");
    header_.elements.back().properties.push_back(std::move(property));
    return std::nullopt;
  }

  Problem read_type(PlyType& type) {
    const std::optional<PlyType> named = type_named(scanner_.word());
    if (!named) return scanner_.expected("a type");
    type = *named;
    return std::nullopt;
  }

  // Returns true if the current line contains a byte that cannot be text. Does not move the scanner.
  bool line_has_binary() {
    const size_t here = scanner_.position();
    scanner_.skip_line();
    const size_t end = scanner_.position();
    const std::string_view line = scanner_.between(line_begin_, end);
    scanner_.seek(here);
    return std::any_of(line.begin(), line.end(), is_binary);
  }

  // Blender 2.4x wrote "Created by ..." without the keyword "comment". Such lines
  // cannot be mistaken for data only before the first element; no writer emits bytes that are not text.
  Problem pass_over_stray_line() {
    const bool refused = !header_.elements.empty() || line_has_binary();
    if (!refused && stray_lines_++ > 0) return std::nullopt;
    Error error = scanner_.expected("'element', 'property' or 'end_header'");
    if (refused) return error;
    first_stray_line_ = scanner_.line();
    stray_error_ = std::move(error);
    return std::nullopt;
  }

  // Rejects counts that the rest of the file cannot hold; every element takes at least one byte.
  Problem check_counts() const {
    for (const PlyElement& element : header_.elements) {
      uint64_t least = 0;  // bytes of one element
      for (const PlyProperty& property : element.properties) {
        constexpr size_t kTextBytes = 2;  // a digit and a blank
        const PlyType first = property.count_type.value_or(property.type);
        least += header_.encoding == PlyEncoding::kText ? kTextBytes : byte_size(first);
      }
      const size_t left = scanner_.left() + (header_.encoding == PlyEncoding::kText);
      if (least == 0 || element.count <= left / least) continue;
      return scanner_.file_error("declares " + std::to_string(element.count) + " times " +
                                 in_quotes(element.name) + ", but the " + std::to_string(scanner_.left()) +
                                 " bytes after the header cannot hold them");
    }
    return std::nullopt;
  }

  void record_stray_lines() {
    if (stray_lines_ == 0) return;
    const std::string line = std::to_string(first_stray_line_);
    header_.warnings.push_back(stray_lines_ == 1
                                   ? "1 stray line before the first element, line " + line + ", was skipped."
                                   : std::to_string(stray_lines_) +
                                         " stray lines before the first element, the first in line " + line +
                                         ", were skipped.");
  }

  Scanner& scanner_;
  PlyHeader header_;
  std::set<std::string> names_;  // of the elements
  bool has_format_ = false;
  size_t line_begin_ = 0;  // of the current line
  size_t stray_lines_ = 0;
  size_t first_stray_line_ = 0;       // its number, from 1
  std::optional<Error> stray_error_;  // about the first one, if no element follows
};

constexpr size_t kRows = 1 << 14;  // per range
constexpr auto kLittle = std::endian::little;

bool is_scalar(const PlyProperty& p) { return !p.count_type; }

// The offsets of the scalars x, y and z in a row.
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

std::vector<size_t> starts_in_row(const PlyElement& element) {
  std::vector<size_t> starts{0};  // of the properties
  for (const PlyProperty& p : element.properties) starts.push_back(starts.back() + byte_size(p.type));
  return starts;
}

bool has_floats(const PlyElement& element, std::span<const size_t> properties) {
  return std::ranges::all_of(properties, [&](size_t i) {
    return i == kNoProperty || element.properties[i].type == PlyType::kFloat32;
  });
}

template <typename V, size_t count>
void load_floats(const PlyElement& element, const std::array<size_t, count>& properties, size_t row_bytes,
                 std::string_view bytes, std::vector<V>& values) {
  if (properties[0] == kNoProperty) return;
  const std::vector<size_t> starts = starts_in_row(element);
  values.resize(element.count);
  for_each_range(values.size(), kRows, [&](size_t i, size_t end) {
    for (const char* at = bytes.data() + i * row_bytes; i < end; ++i, at += row_bytes) {
      for (size_t k = 0; k < count; ++k)
        values[i][static_cast<int>(k)] = load<float>(at + starts[properties[k]], kLittle);
    }
  });
}

template <typename T>
void load_column(std::string_view bytes, size_t start, size_t row_bytes, std::vector<float>& values) {
  for_each_range(values.size(), kRows, [&](size_t i, size_t end) {
    for (; i < end; ++i)
      values[i] = static_cast<float>(load<T>(bytes.data() + i * row_bytes + start, kLittle));
  });
}

// Loads the values of a scalar of any type.
void load_scalars(const PlyElement& element, size_t property, size_t row_bytes, std::string_view bytes,
                  std::vector<float>& values) {
  const size_t start = starts_in_row(element)[property];
  values.resize(element.count);
  switch (element.properties[property].type) {
    case PlyType::kInt8:
      return load_column<int8_t>(bytes, start, row_bytes, values);
    case PlyType::kUint8:
      return load_column<uint8_t>(bytes, start, row_bytes, values);
    case PlyType::kInt16:
      return load_column<int16_t>(bytes, start, row_bytes, values);
    case PlyType::kUint16:
      return load_column<uint16_t>(bytes, start, row_bytes, values);
    case PlyType::kInt32:
      return load_column<int32_t>(bytes, start, row_bytes, values);
    case PlyType::kUint32:
      return load_column<uint32_t>(bytes, start, row_bytes, values);
    case PlyType::kInt64:
      return load_column<int64_t>(bytes, start, row_bytes, values);
    case PlyType::kUint64:
      return load_column<uint64_t>(bytes, start, row_bytes, values);
    case PlyType::kFloat32:
      return load_column<float>(bytes, start, row_bytes, values);
    case PlyType::kFloat64:
      return load_column<double>(bytes, start, row_bytes, values);
  }
}

void load_colours(const PlyElement& element, const std::array<size_t, 4>& properties, size_t row_bytes,
                  std::string_view bytes, std::vector<VertexColour>& colours) {
  const std::vector<size_t> starts = starts_in_row(element);
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

// The offset of the list of corners in a row in which it has three entries.
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

size_t byte_size(PlyType type) {
  constexpr std::array<size_t, 10> kBytes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};  // in the order of PlyType
  return kBytes.at(static_cast<size_t>(type));
}

bool is_integer(PlyType type) { return type != PlyType::kFloat32 && type != PlyType::kFloat64; }

Result<PlyHeader> read_ply_header(Scanner& scanner) { return HeaderReader(scanner).read(); }

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

namespace {

// Returns the indices of scalars of these names; kNoProperty for all if one is missing.
template <size_t count>
std::array<size_t, count> scalars_named(const PlyElement& element,
                                        const std::array<std::string_view, count>& names) {
  std::array<size_t, count> found;
  for (size_t k = 0; k < count; ++k) {
    const auto at = std::ranges::find_if(element.properties, [&](const PlyProperty& property) {
      return is_scalar(property) && property.name == names[k];
    });
    found[k] = static_cast<size_t>(at - element.properties.begin());
    if (at != element.properties.end()) continue;
    found.fill(kNoProperty);
    break;
  }
  return found;
}

}  // namespace

PlyLookProperties look_properties_of(const PlyElement& element) {
  PlyLookProperties looks{scalars_named<3>(element, {"nx", "ny", "nz"}), {kNoProperty, kNoProperty}};
  constexpr std::array<std::array<std::string_view, 2>, 3> kUvs{
      {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}};
  for (const auto& names : kUvs) {
    if (looks.uv[0] == kNoProperty) looks.uv = scalars_named<2>(element, names);
  }
  std::vector<bool> used(element.properties.size(), false);
  const auto use = [&](std::span<const size_t> properties) {
    for (const size_t i : properties) {
      if (i != kNoProperty) used[i] = true;
    }
  };
  use(looks.normal);
  use(looks.uv);
  for (const std::string_view axis : {"x", "y", "z"}) use(scalars_named<1>(element, {axis}));
  if (const auto colours = colour_properties_of(element)) use(*colours);
  for (size_t i = 0; i < used.size(); ++i) {
    if (used[i] || !is_scalar(element.properties[i])) continue;
    if (looks.attributes.size() < kMaxLookAttributes) {
      looks.attributes.push_back(i);
    } else {
      ++looks.ignored;
    }
  }
  return looks;
}

std::optional<PlyVertexRows> read_vertex_rows(const PlyElement& element, std::string_view bytes) {
  const auto row = position_row(element);
  if (!row || !fits(element, row->bytes, bytes)) return std::nullopt;
  const auto colours = colour_properties_of(element);
  if (colours && !has_eight_bits(element, *colours)) return std::nullopt;
  const PlyLookProperties looks = look_properties_of(element);
  if (!has_floats(element, looks.normal) || !has_floats(element, looks.uv)) return std::nullopt;
  PlyVertexRows rows{{std::vector<Vec3>(element.count), {}, {}, {}, {}}, element.count * row->bytes};
  if (row->type == PlyType::kFloat32)
    load_positions<float>(*row, bytes, rows.values.positions);
  else
    load_positions<double>(*row, bytes, rows.values.positions);
  if (colours) {
    rows.values.colours.resize(element.count);
    load_colours(element, *colours, row->bytes, bytes, rows.values.colours);
  }
  load_floats(element, looks.normal, row->bytes, bytes, rows.values.normals);
  load_floats(element, looks.uv, row->bytes, bytes, rows.values.uvs);
  for (const size_t attribute : looks.attributes)
    load_scalars(element, attribute, row->bytes, bytes, rows.values.attributes.emplace_back());
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
