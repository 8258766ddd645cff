#include "core/mesh/files/readers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/mesh/files/mtl_file.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/soup.h"
#include "core/mesh/files/vertex_colour.h"

namespace kerf {
namespace {

constexpr std::array<std::string_view, 5> kPassedOver{"vp", "s", "mg", "lod", "maplib"};

// The indices of a corner as written in the file: 1 is the first one, -1 the last one so far, and 0 marks a
// missing one.
struct ObjCorner {
  int64_t vertex = 0, uv = 0, normal = 0;
};

// Parses a corner like 7, 7/7, 7//7 or 7/7/7; nullopt if the word is none.
std::optional<ObjCorner> parse_corner(std::string_view word) {
  const size_t slash = std::min(word.find('/'), word.size());
  if (word.find_first_not_of("/0123456789+-", slash) != std::string_view::npos) return std::nullopt;
  ObjCorner corner;
  if (slash > 0) {
    const auto vertex = parse_integer(word.substr(0, slash));
    if (!vertex) return std::nullopt;
    corner.vertex = *vertex;
  }
  if (slash == word.size()) return corner;
  const std::string_view rest = word.substr(slash + 1);
  const size_t second = std::min(rest.find('/'), rest.size());
  corner.uv = parse_integer(rest.substr(0, second)).value_or(0);
  if (second < rest.size()) corner.normal = parse_integer(rest.substr(second + 1)).value_or(0);
  return corner;
}

// Values that the corners of faces refer to, vt or vn.
template <typename T>
class ObjValues {
 public:
  void add(const T& value) { values_.push_back(value); }

  // Sets the value of the next corner of `corners` in all. Values may follow the faces that refer to them.
  void refer(int64_t index, size_t corners) {
    if (index == 0 && indices_.empty()) return;
    indices_.resize(corners, LookChannel<T>::kNone);
    const auto count = static_cast<int64_t>(values_.size());
    const int64_t from_first = index < 0 ? count + index : index - 1;
    const bool fits = index != 0 && from_first >= 0 && from_first < LookChannel<T>::kNone;
    missing_ += index != 0 && !fits;
    indices_.push_back(fits ? static_cast<uint32_t>(from_first) : LookChannel<T>::kNone);
  }

  // Returns the values of triangles with these corners. Counts those that refer to missing ones.
  LookChannel<T> take(const std::vector<Soup::Triangle>& corners) {
    LookChannel<T> channel;
    if (indices_.empty()) return channel;
    channel.corners.reserve(corners.size());
    for (const Soup::Triangle& triangle : corners) {
      auto& own = channel.corners.emplace_back();
      for (size_t i = 0; i < 3; ++i) {
        own[i] = triangle[i] < indices_.size() ? indices_[triangle[i]] : LookChannel<T>::kNone;
        if (own[i] == LookChannel<T>::kNone || own[i] < values_.size()) continue;
        own[i] = LookChannel<T>::kNone;
        ++missing_;
      }
    }
    channel.values = std::move(values_);
    return channel;
  }

  bool any() const { return !indices_.empty(); }
  size_t missing() const { return missing_; }

 private:
  std::vector<T> values_;
  std::vector<uint32_t> indices_;  // by corner, up to the last one that refers to a value
  size_t missing_ = 0;
};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const std::string& file_name, const Progress* progress,
            const std::filesystem::path& folder)
      : scanner_(bytes, file_name, {.comments = true, .continuations = true}, progress),
        file_name_(file_name),
        folder_(folder) {}

  Result<Soup> read() {
    if (auto binary = scanner_.refuse_binary("OBJ")) return *binary;
    while (!scanner_.at_end()) {
      if (scanner_.cancelled()) return cancelled();
      if (auto problem = read_statement(scanner_.word())) return *problem;
      scanner_.skip_line();
    }
    const bool has_looks = uvs_.any() || normals_.any();
    std::vector<Soup::Triangle> corners;
    Result<Soup> soup = polygons_.to_soup(std::move(positions_), file_name_, has_looks ? &corners : nullptr);
    if (!soup) return soup;
    soup->format = "obj";
    if (uvs_.any()) soup->looks.uv_sets.push_back(uvs_.take(corners));
    if (normals_.any()) soup->looks.normals = normals_.take(corners);
    soup->colours = colours_.take(soup->positions.size(), soup->warnings);
    add_warnings(*soup);
    soup->material_names = std::move(material_names_);
    if (!folder_.empty() && !libraries_.empty())
      soup->surfaces = read_mtl_surfaces(folder_, libraries_, soup->material_names, soup->warnings);
    if (soup->material_names.size() == 1 && soup->material_names[0].empty()) soup->material_names.clear();
    return soup;
  }

 private:
  using Problem = std::optional<Error>;

  Problem read_statement(std::string_view keyword) {
    if (keyword == "v") return read_vertex();
    if (keyword == "f" || keyword == "fo") return read_face();
    if (keyword == "vt") {
      uvs_.add(glm::vec2(read_numbers(1)));
    } else if (keyword == "vn") {
      normals_.add(glm::vec3(read_numbers(3)));
    } else if (keyword == "usemtl") {
      material_name_ = scanner_.rest_of_line();
      material_.reset();
    } else if (keyword == "mtllib") {
      std::string name(scanner_.rest_of_line());
      while (name.ends_with('\\')) {
        name.back() = ' ';
        scanner_.skip_line();
        name += scanner_.rest_of_line();
      }
      if (!name.empty() && libraries_.size() < kMaxLibraries &&
          std::find(libraries_.begin(), libraries_.end(), name) == libraries_.end())
        libraries_.push_back(name);
    } else if (keyword == "o") {
      polygons_.begin_parts(PolygonList::Level::kObject, {one_line(scanner_.rest_of_line())});
    } else if (keyword == "g") {
      read_groups();
    } else {
      count_skipped(keyword);
    }
    return std::nullopt;
  }

  Problem read_vertex() {
    constexpr std::array<const char*, 3> kNames{"the x coordinate", "the y coordinate", "the z coordinate"};
    Vec3 position;
    for (int i = 0; i < 3; ++i) {
      const std::optional<double> number = scanner_.number();
      if (!number) return scanner_.expected(kNames[static_cast<size_t>(i)]);
      position[i] = *number;
    }
    positions_.push_back(position);
    // A weight or a colour may follow. Anything but a number indicates a lost line break.
    ColourNumbers::Parts further;
    further.fill(ColourNumbers::kFull);
    size_t count = 0;
    for (; !scanner_.at_line_end(); ++count) {
      const std::optional<double> number = parse_number(scanner_.word());
      if (!number) return scanner_.expected("a number");
      if (count < further.size()) further[count] = *number;
    }
    if (count >= VertexColour::kOpacity) colours_.set(positions_.size() - 1, further);
    return std::nullopt;
  }

  // Reads up to three numbers of a UV or a normal; missing ones are 0. If fewer than `least` are there, or
  // one is no number, all are NaN.
  Vec3 read_numbers(int least) {
    Vec3 numbers(0);
    for (int i = 0; i < 3 && (i < least || !scanner_.at_line_end()); ++i) {
      const std::optional<double> number = parse_number(scanner_.word());
      if (!number || !std::isfinite(*number)) return Vec3(std::numeric_limits<double>::quiet_NaN());
      numbers[i] = *number;
    }
    return numbers;
  }

  Problem read_face() {
    const int64_t vertices = static_cast<int64_t>(positions_.size());
    while (!scanner_.at_line_end()) {
      const std::optional<ObjCorner> corner = parse_corner(scanner_.word());
      if (!corner) return scanner_.expected("a corner of a face, like 7 or 7/7/7");
      // Zero and indices that count back beyond the first vertex become -1, which marks a missing vertex.
      const int64_t index = corner->vertex;
      polygons_.add_corner(index < 0 && index >= -vertices ? vertices + index
                                                           : std::max(index, int64_t{0}) - 1);
      uvs_.refer(corner->uv, corners_);
      normals_.refer(corner->normal, corners_);
      ++corners_;
    }
    polygons_.close(material());
    return std::nullopt;
  }

  void read_groups() {
    std::vector<std::string> names;
    for (auto name = scanner_.name(); !name.empty(); name = scanner_.name()) names.push_back(one_line(name));
    polygons_.begin_parts(PolygonList::Level::kGroup, names);
  }

  // Returns the index of the current material. Faces before the first usemtl have an unnamed material.
  uint16_t material() {
    if (material_) return *material_;
    constexpr size_t kMost = std::numeric_limits<uint16_t>::max();
    const auto [known, added] = material_numbers_.try_emplace(
        material_name_, static_cast<uint16_t>(std::min(material_names_.size(), kMost)));
    if (added && material_names_.size() <= kMost) {
      material_names_.push_back(one_line(material_name_));
    } else if (added) {
      too_many_materials_ = true;
    }
    material_ = known->second;
    return *material_;
  }

  void count_skipped(std::string_view keyword) {
    if (std::find(kPassedOver.begin(), kPassedOver.end(), keyword) != kPassedOver.end()) return;
    if (skipped_++ == 0) first_skipped_ = in_quotes(keyword);
  }

  void add_warnings(Soup& soup) const {
    if (skipped_ > 0) {
      soup.warnings.push_back(skipped_ == 1
                                  ? "1 statement that defines no face was skipped, " + first_skipped_ + "."
                                  : std::to_string(skipped_) +
                                        " statements that define no face were skipped, the first " +
                                        first_skipped_ + ".");
    }
    if (too_many_materials_) {
      soup.warnings.push_back(
          "There are more than 65536 materials; faces of further ones have the last one.");
    }
    const size_t missing = uvs_.missing() + normals_.missing();
    if (missing > 0) {
      soup.warnings.push_back(std::to_string(missing) +
                              (missing == 1
                                   ? " corner refers to a missing UV or normal; its face loses it."
                                   : " corners refer to missing UVs or normals; their faces lose them."));
    }
    if (scanner_.garbled_numbers() > 0) soup.warnings.push_back(scanner_.garbled_numbers_warning());
  }

  Scanner scanner_;
  const std::string& file_name_;
  const std::filesystem::path& folder_;
  std::vector<Vec3> positions_;
  ColourNumbers colours_;  // by position
  PolygonList polygons_;
  ObjValues<glm::vec2> uvs_;
  ObjValues<glm::vec3> normals_;
  size_t corners_ = 0;                  // of all faces
  std::vector<std::string> libraries_;  // arguments of mtllib

  std::string_view material_name_;           // the argument of the last usemtl
  std::optional<uint16_t> material_;         // its index, once a face uses it
  std::vector<std::string> material_names_;  // of the materials that faces use
  std::unordered_map<std::string_view, uint16_t> material_numbers_;
  bool too_many_materials_ = false;

  size_t skipped_ = 0;
  std::string first_skipped_;
};

}  // namespace

Result<Soup> read_obj(std::string_view bytes, const std::string& file_name, const Progress* progress,
                      const std::filesystem::path& folder) {
  return ObjReader(bytes, file_name, progress, folder).read();
}

Result<Soup> read_obj(std::string_view bytes, const std::string& file_name, const Progress* progress) {
  return read_obj(bytes, file_name, progress, {});
}

}  // namespace kerf
