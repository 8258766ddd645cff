#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/mesh/files/bytes.h"
#include "core/mesh/files/mtl_file.h"
#include "core/mesh/files/ply_file.h"
#include "core/mesh/files/readers.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/soup.h"
#include "core/mesh/files/vertex_colour.h"

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

using Problem = std::optional<Error>;

const glm::vec2 kNoUv(std::numeric_limits<float>::quiet_NaN());

// The role of a property in the mesh.
enum class Role {
  kX,
  kY,
  kZ,
  kRed,
  kGreen,
  kBlue,
  kOpacity,
  kNormalX,
  kNormalY,
  kNormalZ,
  kU,
  kV,
  kCorners,
  kCornerUvs,
  kAttribute,
  kNone
};

struct ElementPlan {
  std::vector<Role> roles;  // one per property
  bool positions = false;   // an element gives a position
  bool faces = false;       // an element gives a polygon
  bool strips = false;      // an element gives triangle strips
  bool colours = false;     // an element gives a colour with its position
  bool fractions =
      false;  // the colour is not in whole numbers, so that its type does not determine the maximum
  bool normals = false, uvs = false;  // an element gives these with its position
  bool corner_uvs = false;            // an element gives UVs with its polygon
  std::vector<size_t> attributes{};   // properties of custom attributes, ascending
};

bool is_corner_list(const PlyProperty& property) {
  const bool named = property.name == "vertex_indices" || property.name == "vertex_index";
  return named && property.count_type && is_integer(property.type);
}

Role role_of(const PlyElement& element, const PlyProperty& property) {
  if (element.name != "vertex") {
    if (is_corner_list(property)) return Role::kCorners;
    const bool has_uvs = element.name == "face" && property.name == "texcoord" && property.count_type;
    return has_uvs ? Role::kCornerUvs : Role::kNone;
  }
  if (property.count_type) return Role::kNone;
  if (property.name == "x") return Role::kX;
  if (property.name == "y") return Role::kY;
  return property.name == "z" ? Role::kZ : Role::kNone;
}

// Returns the maximum of a colour component: the largest value of an integer type, otherwise one.
double largest_of(PlyType type) {
  if (!is_integer(type)) return 1;
  const bool has_sign =
      type == PlyType::kInt8 || type == PlyType::kInt16 || type == PlyType::kInt32 || type == PlyType::kInt64;
  return std::exp2(static_cast<int>(8 * byte_size(type)) - has_sign) - 1;
}

ElementPlan plan_for(const PlyElement& element) {
  ElementPlan plan{{}, element.name == "vertex", element.name == "face", element.name == "tristrips"};
  for (const PlyProperty& property : element.properties) plan.roles.push_back(role_of(element, property));
  const auto colours = plan.positions ? colour_properties_of(element) : std::nullopt;
  plan.colours = colours.has_value();
  for (size_t k = 0; colours && k < colours->size(); ++k) {
    if ((*colours)[k] == kNoProperty) continue;
    plan.roles[(*colours)[k]] = static_cast<Role>(static_cast<size_t>(Role::kRed) + k);
    plan.fractions = plan.fractions || !is_integer(element.properties[(*colours)[k]].type);
  }
  const auto set = [&](std::span<const size_t> properties, Role first) {
    if (!plan.positions || properties[0] == kNoProperty) return false;
    for (size_t k = 0; k < properties.size(); ++k)
      plan.roles[properties[k]] = static_cast<Role>(static_cast<size_t>(first) + k);
    return true;
  };
  const PlyLookProperties looks = look_properties_of(element);
  plan.normals = set(looks.normal, Role::kNormalX);
  plan.uvs = set(looks.uv, Role::kU);
  plan.corner_uvs = std::ranges::count(plan.roles, Role::kCornerUvs) > 0;
  if (plan.positions) plan.attributes = looks.attributes;
  for (const size_t property : plan.attributes) plan.roles[property] = Role::kAttribute;
  return plan;
}

// Returns an error if properties needed to read an element are missing or occur twice.
Problem check_plan(const Scanner& scanner, const PlyElement& element, const ElementPlan& plan) {
  const auto need_one = [&](Role role, const std::string& what) -> Problem {
    if (std::count(plan.roles.begin(), plan.roles.end(), role) == 1) return std::nullopt;
    return scanner.file_error("the element " + in_quotes(element.name) + " must have one property " + what);
  };
  if (plan.faces || plan.strips) return need_one(Role::kCorners, "'vertex_indices', a list of integers");
  if (!plan.positions) return std::nullopt;
  for (const auto& [role, name] : {std::pair(Role::kX, "'x'"), {Role::kY, "'y'"}, {Role::kZ, "'z'"}}) {
    if (auto problem = need_one(role, name)) return problem;
  }
  return std::nullopt;
}

// Reads the data after the header from either kind of values.
template <typename Values>
class BodyReader {
 public:
  BodyReader(Scanner& scanner, Values values) : scanner_(scanner), values_(values) {}

  Problem read(const PlyHeader& header) {
    for (const PlyElement& element : header.elements) {
      const ElementPlan plan = plan_for(element);
      if (auto problem = check_plan(scanner_, element, plan)) return problem;
      // Elements without properties have no data, regardless of their count.
      if (element.properties.empty()) continue;
      if (auto problem = read_elements(element, plan)) return problem;
    }
    return std::nullopt;
  }

  PlyVertices vertices;
  ColourNumbers numbers;  // colours that are not in whole numbers
  PolygonList polygons;
  std::vector<glm::vec2> corner_uvs;  // by corner of the polygons; empty if they have none

 private:
  Problem read_elements(const PlyElement& element, const ElementPlan& plan) {
    element_ = &element;
    if (read_rows(element, plan)) return std::nullopt;
    if (plan.positions) {
      vertices.positions.reserve(element.count);
      vertices.attributes.resize(plan.attributes.size());
      attributes_.resize(element.properties.size());
    }
    if (plan.faces) polygons.reserve(element.count);
    for (number_ = 0; number_ < element.count; ++number_) {
      if (scanner_.cancelled()) return cancelled();
      if (auto problem = read_properties(element, plan)) return problem;
      if (plan.positions) vertices.positions.push_back(position_);
      if (plan.fractions)
        numbers.set(vertices.positions.size() - 1, numbers_);
      else if (plan.colours)
        vertices.colours.push_back(colour_);
      if (plan.normals) vertices.normals.push_back(normal_);
      if (plan.uvs) vertices.uvs.push_back(uv_);
      for (size_t a = 0; a < plan.attributes.size(); ++a)
        vertices.attributes[a].push_back(attributes_[plan.attributes[a]]);
      if (plan.corner_uvs) add_corner_uvs();
      if (plan.faces) add_face();
      if (plan.strips) add_strips();
    }
    return std::nullopt;
  }

  // Reads a whole element at once if its rows have the usual layout. Returns false otherwise.
  bool read_rows(const PlyElement& element, const ElementPlan& plan) {
    if (plan.positions) {
      auto rows = values_.vertices(element);
      if (rows) vertices = std::move(*rows);
      return rows.has_value();
    }
    if (!plan.faces) return false;
    auto rows = values_.triangles(element);
    if (rows) polygons.add_triangles(std::move(*rows));
    return rows.has_value();
  }

  Problem read_properties(const PlyElement& element, const ElementPlan& plan) {
    for (size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.count_type) {
        if (auto problem = read_list(property, plan.roles[i])) return problem;
      } else if (plan.roles[i] == Role::kNone) {
        if (!values_.skip(property.type, 1)) return missing(property);
      } else {
        double number = 0;
        if (!values_.number(property.type, number)) return missing(property);
        if (plan.roles[i] == Role::kAttribute) {
          attributes_[i] = static_cast<float>(number);
        } else {
          take_number(property, plan.roles[i], number);
        }
      }
    }
    if (!values_.end_element()) {
      return values_.error("the line continues after the properties of " + in_quotes(element.name) + " " +
                           std::to_string(number_) + "; a property before may be missing");
    }
    return std::nullopt;
  }

  void take_number(const PlyProperty& property, Role role, double number) {
    if (role <= Role::kZ) {
      position_[static_cast<int>(role)] = number;
    } else if (role >= Role::kU) {
      uv_[static_cast<int>(role) - static_cast<int>(Role::kU)] = static_cast<float>(number);
    } else if (role >= Role::kNormalX) {
      normal_[static_cast<int>(role) - static_cast<int>(Role::kNormalX)] = static_cast<float>(number);
    } else {
      const size_t part = static_cast<size_t>(role) - static_cast<size_t>(Role::kRed);
      numbers_[part] = number / largest_of(property.type);
      colour_.part[part] = colour_part(numbers_[part]);
    }
  }

  Problem read_list(const PlyProperty& property, Role role) {
    int64_t count = 0;
    if (!values_.integer(*property.count_type, count)) return missing(property);
    if (count < 0 || !values_.can_hold(property.type, static_cast<uint64_t>(count))) {
      return values_.error("the list " + in_quotes(property.name) + " declares " + std::to_string(count) +
                           " values, but only " + std::to_string(scanner_.left()) + " bytes follow");
    }
    if (role == Role::kCornerUvs) {
      uvs_of_corners_.resize(static_cast<size_t>(count));
      for (double& number : uvs_of_corners_) {
        if (!values_.number(property.type, number)) return missing(property);
      }
      return std::nullopt;
    }
    if (role != Role::kCorners) {
      if (!values_.skip(property.type, static_cast<uint64_t>(count))) return missing(property);
      return std::nullopt;
    }
    corners_.resize(static_cast<size_t>(count));
    for (int64_t& corner : corners_) {
      if (!values_.integer(property.type, corner)) return missing(property);
    }
    return std::nullopt;
  }

  Error missing(const PlyProperty& property) const {
    return values_.missing(in_quotes(property.name) + " of " + in_quotes(element_->name) + " " +
                           std::to_string(number_) + " of " + std::to_string(element_->count));
  }

  // Corners of other faces before, and of a face without two numbers for each corner, have kNoUv.
  void add_corner_uvs() {
    corner_uvs.resize(corners_before_, kNoUv);
    const bool known = uvs_of_corners_.size() == 2 * corners_.size();
    for (size_t i = 0; i < corners_.size(); ++i)
      corner_uvs.push_back(known ? glm::vec2(uvs_of_corners_[2 * i], uvs_of_corners_[2 * i + 1]) : kNoUv);
  }

  void add_face() {
    for (const int64_t corner : corners_) polygons.add_corner(corner);
    polygons.close();
    corners_before_ += corners_.size();
  }

  // Every second triangle of a strip is reversed, so that all face the same way.
  void add_strips() {
    size_t begin = 0;
    for (size_t i = 0; i < corners_.size(); ++i) {
      if (corners_[i] == -1) begin = i + 1;
      if (i < begin + 2) continue;
      const bool turned = (i - begin) % 2 == 1;
      polygons.add_corner(corners_[turned ? i - 1 : i - 2]);
      polygons.add_corner(corners_[turned ? i - 2 : i - 1]);
      polygons.add_corner(corners_[i]);
      polygons.close();
      corners_before_ += 3;
    }
  }

  Scanner& scanner_;
  Values values_;
  const PlyElement* element_ = nullptr;  // the current one
  uint64_t number_ = 0;                  // of elements read before
  Vec3 position_{0, 0, 0};
  VertexColour colour_;
  ColourNumbers::Parts numbers_{1, 1, 1, ColourNumbers::kFull};  // of colour_
  glm::vec3 normal_{0};
  glm::vec2 uv_{0};
  std::vector<float> attributes_;  // by property of the vertex
  std::vector<int64_t> corners_;
  std::vector<double> uvs_of_corners_;
  size_t corners_before_ = 0;  // of polygons
};

// Returns the description of the only material of a file with a texture; null if the image is missing.
std::shared_ptr<const SurfaceLibrary> surfaces_of(const PlyHeader& header,
                                                  const std::filesystem::path& folder,
                                                  std::vector<std::string>& warnings) {
  if (header.texture_file.empty() || folder.empty()) return nullptr;
  if (header.textures > 1)
    warnings.push_back("Only the first of " + std::to_string(header.textures) + " textures was read.");
  auto library = std::make_shared<SurfaceLibrary>();
  library->materials.push_back({{{"map_Kd ", 0u}}, {}});
  library->images.push_back(read_image(folder, header.texture_file, warnings));
  return library;
}

template <typename Values>
void take_looks(BodyReader<Values>& body, std::vector<Soup::Triangle> corners, Soup& soup) {
  for (auto& triangle : corners) {
    const bool known = std::ranges::all_of(triangle, [&](uint32_t c) {
      return c < body.corner_uvs.size() && !std::isnan(body.corner_uvs[c].x);
    });
    if (!known) triangle.fill(LookChannel<glm::vec2>::kNone);
  }
  if (!body.corner_uvs.empty())
    soup.looks.uv_sets.push_back({std::move(body.corner_uvs), std::move(corners)});
  else if (!body.vertices.uvs.empty())
    soup.looks.uv_sets.push_back({std::move(body.vertices.uvs), soup.triangles});
  if (!body.vertices.normals.empty()) soup.looks.normals = {std::move(body.vertices.normals), soup.triangles};
}

// Gives the triangles the custom attributes of their vertices.
void take_attributes(const PlyHeader& header, std::vector<std::vector<float>> columns, Soup& soup) {
  for (const PlyElement& element : header.elements) {
    if (element.name != "vertex") continue;
    const PlyLookProperties looks = look_properties_of(element);
    for (size_t a = 0; a < columns.size(); ++a) {
      LookAttribute attribute{element.properties[looks.attributes[a]].name, 1, {}};
      attribute.channel.values.reserve(columns[a].size());
      for (const float number : columns[a]) attribute.channel.values.emplace_back(number, 0, 0, 0);
      attribute.channel.corners = soup.triangles;
      soup.looks.attributes.push_back(std::move(attribute));
    }
    if (looks.ignored > 0) {
      soup.warnings.push_back(std::to_string(looks.ignored) + " properties of vertices beyond the limit of " +
                              std::to_string(kMaxLookAttributes) + " were ignored.");
    }
  }
}

template <typename Values>
Result<Soup> read_body(Scanner& scanner, Values values, const PlyHeader& header, const std::string& file_name,
                       const std::filesystem::path& folder) {
  BodyReader<Values> body(scanner, values);
  if (auto problem = body.read(header)) return *problem;
  std::vector<Soup::Triangle> corners;
  Result<Soup> soup = body.polygons.to_soup(std::move(body.vertices.positions), file_name,
                                            body.corner_uvs.empty() ? nullptr : &corners);
  if (!soup) return soup;
  take_looks(body, std::move(corners), *soup);
  take_attributes(header, std::move(body.vertices.attributes), *soup);
  soup->surfaces = surfaces_of(header, folder, soup->warnings);
  if (soup->surfaces) {
    const std::string& image = soup->surfaces->images[0].name;
    soup->material_names.push_back(image.empty() ? "texture" : image);
  }
  soup->colours = std::move(body.vertices.colours);
  if (soup->colours.empty()) soup->colours = body.numbers.take(soup->positions.size(), soup->warnings);
  soup->format = "ply";
  soup->warnings.insert(soup->warnings.end(), header.warnings.begin(), header.warnings.end());
  const bool has_face_colours = std::ranges::any_of(header.elements, [](const PlyElement& element) {
    return element.name == "face" && element.count > 0 && colour_properties_of(element);
  });
  if (has_face_colours) soup->warnings.emplace_back("Colours of faces were ignored.");
  const bool rest = header.encoding == PlyEncoding::kText ? !scanner.at_end() : scanner.left() > 0;
  if (rest) soup->warnings.push_back("Data after the last element that the header declares were ignored.");
  if (scanner.garbled_numbers() > 0) soup->warnings.push_back(scanner.garbled_numbers_warning());
  return soup;
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
  return scanner_.byte_error("the file ends where " + what + " is expected; it is truncated");
}

Result<Soup> read_ply(std::string_view bytes, const std::string& file_name, const Progress* progress,
                      const std::filesystem::path& folder) {
  Scanner scanner(bytes, file_name, {}, progress);
  const Result<PlyHeader> header = read_ply_header(scanner);
  if (!header) return header.error();
  if (header->encoding == PlyEncoding::kText) {
    if (auto binary = scanner.refuse_binary("PLY")) return *binary;
    return read_body(scanner, PlyTextValues(scanner), *header, file_name, folder);
  }
  const auto order = header->encoding == PlyEncoding::kLittleEndian ? std::endian::little : std::endian::big;
  return read_body(scanner, PlyBinaryValues(scanner, order), *header, file_name, folder);
}

}  // namespace kerf
