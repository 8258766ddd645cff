#include "core/mesh/files/readers.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <unordered_map>

#include "core/mesh/files/scanner.h"
#include "core/mesh/files/soup.h"
#include "core/mesh/files/vertex_colour.h"

namespace kerf {
namespace {

constexpr std::array<std::string_view, 8> kPassedOver{"vt", "vn", "vp", "s", "mg", "mtllib", "lod", "maplib"};

// Parses the vertex index of a corner as written in the file: 1 is the first vertex, -1 the last one so far,
// and 0 marks a missing vertex. Returns nullopt if the word is no corner.
std::optional<int64_t> parse_corner(std::string_view word) {
  const size_t slash = std::min(word.find('/'), word.size());
  if (word.find_first_not_of("/0123456789+-", slash) != std::string_view::npos) return std::nullopt;
  if (slash == 0) return 0;
  return parse_integer(word.substr(0, slash));
}

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const std::string& file_name, const Progress* progress)
      : scanner_(bytes, file_name, {.comments = true, .continuations = true}, progress),
        file_name_(file_name) {}

  Result<Soup> read() {
    if (auto binary = scanner_.refuse_binary("OBJ")) return *binary;
    while (!scanner_.at_end()) {
      if (scanner_.cancelled()) return cancelled();
      if (auto problem = read_statement(scanner_.word())) return *problem;
      scanner_.skip_line();
    }
    Result<Soup> soup = polygons_.to_soup(std::move(positions_), file_name_);
    if (!soup) return soup;
    soup->format = "obj";
    soup->colours = colours_.take(soup->positions.size(), soup->warnings);
    add_warnings(*soup);
    soup->material_names = std::move(material_names_);
    if (soup->material_names.size() == 1 && soup->material_names[0].empty()) soup->material_names.clear();
    return soup;
  }

 private:
  using Problem = std::optional<Error>;

  Problem read_statement(std::string_view keyword) {
    if (keyword == "v") return read_vertex();
    if (keyword == "f" || keyword == "fo") return read_face();
    if (keyword == "usemtl") {
      material_name_ = scanner_.rest_of_line();
      material_.reset();
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

  Problem read_face() {
    const int64_t vertices = static_cast<int64_t>(positions_.size());
    while (!scanner_.at_line_end()) {
      const std::optional<int64_t> index = parse_corner(scanner_.word());
      if (!index) return scanner_.expected("a corner of a face, like 7 or 7/7/7");
      // Zero and indices that count back beyond the first vertex become -1, which marks a missing vertex.
      polygons_.add_corner(*index < 0 && *index >= -vertices ? vertices + *index
                                                             : std::max(*index, int64_t{0}) - 1);
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
    if (scanner_.garbled_numbers() > 0) soup.warnings.push_back(scanner_.garbled_numbers_warning());
  }

  Scanner scanner_;
  const std::string& file_name_;
  std::vector<Vec3> positions_;
  ColourNumbers colours_;  // by position
  PolygonList polygons_;

  std::string_view material_name_;           // the argument of the last usemtl
  std::optional<uint16_t> material_;         // its index, once a face uses it
  std::vector<std::string> material_names_;  // of the materials that faces use
  std::unordered_map<std::string_view, uint16_t> material_numbers_;
  bool too_many_materials_ = false;

  size_t skipped_ = 0;
  std::string first_skipped_;
};

}  // namespace

Result<Soup> read_obj(std::string_view bytes, const std::string& file_name, const Progress* progress) {
  return ObjReader(bytes, file_name, progress).read();
}

}  // namespace kerf
