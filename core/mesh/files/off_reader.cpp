#include "core/mesh/files/readers.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/mesh/files/scanner.h"
#include "core/mesh/files/soup.h"
#include "core/mesh/files/vertex_colour.h"

namespace kerf {
namespace {

struct Keyword {
  size_t length = 0;       // of the keyword, including "OFF"; 0 if the word is none
  bool flat_space = true;  // three coordinates
  // Values after the coordinates, in this order.
  bool normals = false, colours = false, texture = false;
};

Keyword parse_keyword(std::string_view word) {
  std::string_view rest = word;
  const auto skip = [&](std::string_view prefix) {
    const bool there = rest.starts_with(prefix);
    if (there) rest.remove_prefix(prefix.size());
    return there;
  };
  const bool texture = skip("ST"), colours = skip("C"), normals = skip("N");
  const bool homogeneous = skip("4"), many = skip("n");
  if (!skip("OFF")) return {};
  const bool ends = rest.empty() || (rest[0] >= '0' && rest[0] <= '9');
  return {ends ? word.size() - rest.size() : 0, !homogeneous && !many, normals, colours, texture};
}

class OffReader {
 public:
  OffReader(std::string_view bytes, const std::string& file_name, const Progress* progress)
      : scanner_(bytes, file_name, {.comments = true, .continuations = false}, progress),
        file_name_(file_name) {}

  Result<Soup> read() {
    if (auto problem = read_keyword()) return *problem;
    if (auto problem = read_counts()) return *problem;
    positions_.reserve(vertices_);
    polygons_.reserve(faces_);
    while (positions_.size() < vertices_) {
      if (scanner_.cancelled()) return cancelled();
      if (auto problem = read_vertex()) return *problem;
    }
    while (polygons_.size() < faces_) {
      if (scanner_.cancelled()) return cancelled();
      if (auto problem = read_face()) return *problem;
    }
    Result<Soup> soup = polygons_.to_soup(std::move(positions_), file_name_);
    if (!soup) return soup;
    soup->format = "off";
    soup->colours = colours_.take(soup->positions.size(), soup->warnings);
    if (has_others_) soup->warnings.push_back(others_warning());
    if (has_face_colours_) soup->warnings.emplace_back("Colours of faces were ignored.");
    if (!scanner_.at_end())
      soup->warnings.push_back("Data after the last face that the header declares were ignored.");
    if (scanner_.garbled_numbers() > 0) soup->warnings.push_back(scanner_.garbled_numbers_warning());
    return soup;
  }

 private:
  using Problem = std::optional<Error>;

  Problem read_keyword() {
    scanner_.at_end();
    const std::string_view word = scanner_.word();
    const size_t begin = scanner_.position() - word.size();
    keyword_ = parse_keyword(word);
    if (keyword_.length == 0) return scanner_.expected("the keyword OFF");
    if (!keyword_.flat_space)
      return scanner_.line_error("OFF with other than three coordinates is not supported");
    scanner_.seek(begin + keyword_.length);
    const size_t after = scanner_.position();
    if (scanner_.word() == "BINARY")
      return scanner_.line_error("binary OFF is not supported; save it as text, or as PLY");
    scanner_.seek(after);
    return scanner_.refuse_binary("OFF");
  }

  // Reads a count of items, each of which takes at least `bytes_each` bytes.
  Problem read_count(const char* of_what, size_t bytes_each, size_t& count) {
    scanner_.at_end();
    const std::optional<int64_t> number = scanner_.integer();
    if (!number) return scanner_.expected(std::string("the number of ") + of_what);
    if (*number < 0 || static_cast<uint64_t>(*number) > scanner_.left() / bytes_each + 1) {
      return scanner_.line_error("declares " + std::to_string(*number) + " " + of_what + ", but the " +
                                 std::to_string(scanner_.left()) + " bytes that follow cannot hold them");
    }
    count = static_cast<size_t>(*number);
    return std::nullopt;
  }

  // Reads the counts. The number of edges is not needed, and some programs omit it.
  Problem read_counts() {
    constexpr size_t kVertexBytes = 6, kFaceBytes = 2;  // "0 0 0\n" and "0\n"
    if (auto problem = read_count("vertices", kVertexBytes, vertices_)) return problem;
    const bool same_line = !scanner_.at_line_end();
    if (auto problem = read_count("faces", kFaceBytes, faces_)) return problem;
    if (!same_line) scanner_.at_end();
    if (!scanner_.at_line_end() && !scanner_.integer()) return scanner_.expected("the number of edges");
    scanner_.skip_line();
    return std::nullopt;
  }

  Problem read_vertex() {
    Vec3 position;
    for (int i = 0; i < 3; ++i) {
      scanner_.at_end();
      const std::optional<double> number = scanner_.number();
      if (!number) {
        return scanner_.expected("a coordinate of vertex " + std::to_string(positions_.size()) + " of " +
                                 std::to_string(vertices_));
      }
      position[i] = *number;
    }
    const bool is_plain = !keyword_.normals && !keyword_.colours && !keyword_.texture;
    has_others_ =
        has_others_ || ((is_plain || keyword_.normals || keyword_.texture) && !scanner_.at_line_end());
    if (keyword_.colours) read_colour();
    positions_.push_back(position);
    scanner_.skip_line();
    return std::nullopt;
  }

  // The warning about values of vertices that are not read.
  std::string others_warning() const {
    if (keyword_.normals && keyword_.texture) return "Normals and UVs were ignored.";
    if (keyword_.normals) return "Normals were ignored.";
    if (keyword_.texture) return "UVs were ignored.";
    return "Numbers after the positions of vertices were ignored, because the keyword is OFF, not COFF.";
  }

  // Reads the colour of the next vertex from the rest of its line, if there is one.
  void read_colour() {
    std::array<double, 9> numbers;
    size_t count = 0;
    for (; count < numbers.size() && !scanner_.at_line_end(); ++count) {
      const std::optional<double> number = parse_number(scanner_.word());
      if (!number) return;
      numbers[count] = *number;
    }
    const size_t first = keyword_.normals ? 3 : 0, others = first + (keyword_.texture ? 2 : 0);
    if (count < others + VertexColour::kOpacity) return;
    ColourNumbers::Parts parts;
    parts.fill(ColourNumbers::kFull);
    std::copy_n(numbers.begin() + first, std::min(count - others, parts.size()), parts.begin());
    colours_.set(positions_.size(), parts);
  }

  Problem read_face() {
    const auto which = [&] {
      return "face " + std::to_string(polygons_.size()) + " of " + std::to_string(faces_);
    };
    scanner_.at_end();
    const std::optional<int64_t> corners = scanner_.integer();
    if (!corners) return scanner_.expected("the number of corners of " + which());
    if (*corners < 0 || static_cast<uint64_t>(*corners) > scanner_.left()) {
      return scanner_.line_error(which() + " declares " + std::to_string(*corners) + " corners, but only " +
                                 std::to_string(scanner_.left()) + " bytes follow");
    }
    for (int64_t i = 0; i < *corners; ++i) {
      scanner_.at_end();
      const std::optional<int64_t> vertex = scanner_.integer();
      if (!vertex) return scanner_.expected("a corner of " + which());
      polygons_.add_corner(*vertex);
    }
    polygons_.close();
    has_face_colours_ = has_face_colours_ || !scanner_.at_line_end();
    scanner_.skip_line();
    return std::nullopt;
  }

  Scanner scanner_;
  const std::string& file_name_;
  size_t vertices_ = 0;
  size_t faces_ = 0;
  Keyword keyword_;
  std::vector<Vec3> positions_;
  ColourNumbers colours_;  // by position
  PolygonList polygons_;
  bool has_others_ = false;  // vertices have values that are not read
  bool has_face_colours_ = false;
};

}  // namespace

bool is_off_keyword(std::string_view word) { return parse_keyword(word).length > 0; }

Result<Soup> read_off(std::string_view bytes, const std::string& file_name, const Progress* progress) {
  return OffReader(bytes, file_name, progress).read();
}

}  // namespace kerf
