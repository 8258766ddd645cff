#include "core/mesh/files/readers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/assert.h"
#include "core/base/number_format.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/soup.h"

namespace kerf {
namespace {

constexpr size_t kCountAt = 80;
constexpr size_t kHeaderBytes = 84;
constexpr size_t kNormalBytes = 12;
constexpr size_t kTriangleBytes = 50;
constexpr size_t kAttributeAt = 48;  // in a triangle

uint32_t binary_count(std::string_view bytes) {
  KERF_ASSERT(bytes.size() >= kHeaderBytes);
  return load<uint32_t>(bytes.data() + kCountAt, std::endian::little);
}

char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; }

bool starts_ignoring_case(std::string_view word, std::string_view lower) {
  return word.size() >= lower.size() && std::equal(lower.begin(), lower.end(), word.begin(),
                                                   [](char a, char b) { return a == lower_case(b); });
}
bool equal_ignoring_case(std::string_view word, std::string_view lower) {
  return word.size() == lower.size() && starts_ignoring_case(word, lower);
}

bool is_text(std::string_view bytes) {
  Scanner scanner(bytes, {}, {}, nullptr);
  scanner.at_end();
  const std::string_view word = scanner.word();
  return (starts_ignoring_case(word, "solid") || equal_ignoring_case(word, "facet")) &&
         bytes.find('\0') == std::string_view::npos;
}

void add_triangle(const std::array<Vec3, 3>& corners, Soup& soup) {
  const uint32_t first = static_cast<uint32_t>(soup.positions.size());
  soup.positions.insert(soup.positions.end(), corners.begin(), corners.end());
  soup.triangles.push_back({first, first + 1, first + 2});
}

Result<Soup> finished(Soup soup, const std::string& file_name) {
  soup.format = "stl";
  soup.faces_in_file = soup.triangles_in_file = soup.triangles.size();
  if (soup.triangles.empty()) return no_face_left(soup, file_name);
  return soup;
}

std::array<Vec3, 3> load_corners(const char* bytes) {
  std::array<Vec3, 3> corners;
  for (Vec3& corner : corners) {
    for (int i = 0; i < 3; ++i, bytes += sizeof(float)) corner[i] = load<float>(bytes, std::endian::little);
  }
  return corners;
}

// Returns the number of whole triangles that fit a binary file.
size_t room_for_triangles(std::string_view bytes) { return (bytes.size() - kHeaderBytes) / kTriangleBytes; }

// Returns true if the bytes after the header are whole triangles, regardless of the count in the header.
// Programs that write while they compute leave it at 0. The coordinates distinguish text and most other data.
bool are_whole_triangles(std::string_view bytes) {
  if ((bytes.size() - kHeaderBytes) % kTriangleBytes != 0 || bytes.find('\0') == std::string_view::npos)
    return false;
  for (size_t i = 0; i < room_for_triangles(bytes); ++i) {
    for (const Vec3& corner : load_corners(bytes.data() + kHeaderBytes + i * kTriangleBytes + kNormalBytes)) {
      if (!std::isfinite(corner.x) || !std::isfinite(corner.y) || !std::isfinite(corner.z)) return false;
    }
  }
  return true;
}

Result<Soup> read_binary(std::string_view bytes, const std::string& file_name, const Progress* progress) {
  Scanner scanner(bytes, file_name, {}, progress);
  scanner.seek(0);
  if (bytes.size() < kHeaderBytes) {
    return scanner.file_error("the file has " + std::to_string(bytes.size()) +
                              " bytes, too few for an STL file");
  }
  scanner.take(kCountAt);
  const uint32_t announced = load<uint32_t>(scanner.take(sizeof(uint32_t)), std::endian::little);
  const size_t room = room_for_triangles(bytes);
  const bool wrong_count = room > 0 && announced != room && are_whole_triangles(bytes);
  if (announced > room && !wrong_count) {
    return scanner.byte_error("declares " + std::to_string(announced) +
                              " triangles, but the file holds only " + std::to_string(room) +
                              "; it is truncated or not an STL file");
  }
  Soup soup;
  if (wrong_count) {
    soup.warnings.push_back("The header declares " + count_text(announced, "triangle") +
                            ", but the file is as long as " + grouped(room) + "; all of them were read.");
  }
  const size_t count = wrong_count ? room : announced;
  bool has_attributes = false;
  soup.positions.reserve(3 * count);
  soup.triangles.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    if (scanner.cancelled()) return cancelled();
    const char* const triangle = scanner.take(kTriangleBytes);
    add_triangle(load_corners(triangle + kNormalBytes), soup);
    has_attributes = has_attributes || load<uint16_t>(triangle + kAttributeAt, std::endian::little) != 0;
  }
  if (has_attributes) soup.warnings.emplace_back("Attributes of triangles, such as colours, were ignored.");
  if (scanner.left() > 0) {
    soup.warnings.push_back(std::to_string(scanner.left()) +
                            (scanner.left() == 1 ? " byte after the last triangle was ignored."
                                                 : " bytes after the last triangle were ignored."));
  }
  return finished(std::move(soup), file_name);
}

// Reads text STL. Accepts, with a warning, deviations that other readers accept and that leave no facet in
// doubt.
class TextReader {
 public:
  TextReader(std::string_view bytes, const std::string& file_name, const Progress* progress)
      : scanner_(bytes, file_name, {}, progress), file_name_(file_name) {}

  Result<Soup> read() {
    while (!scanner_.at_end()) {
      if (scanner_.cancelled()) return cancelled();
      if (auto problem = read_statement()) return *problem;
    }
    scanner_.word();
    if (in_solid_) stray("the file ends without 'endsolid'; it may be truncated");
    if (strays_ > 0) add_warning();
    if (scanner_.garbled_numbers() > 0) soup_.warnings.push_back(scanner_.garbled_numbers_warning());
    return finished(std::move(soup_), file_name_);
  }

 private:
  using Problem = std::optional<Error>;

  // Reads a facet, or a line outside of facets.
  Problem read_statement() {
    const std::string_view word = scanner_.word();
    if (equal_ignoring_case(word, "facet")) return read_facet();
    const bool split_end = equal_ignoring_case(word, "end");
    if (starts_ignoring_case(word, "endsolid") || (split_end && next_is("solid"))) {
      if (split_end || word.size() > std::string_view("endsolid").size())
        stray("expected 'endsolid', a space and the name");
      if (!std::exchange(in_solid_, false)) stray("'endsolid' without 'solid'");
    } else if (starts_ignoring_case(word, "solid")) {
      if (std::exchange(in_solid_, true)) stray("'solid' before the 'endsolid' of the last one");
    } else if (is_part_of_facet(word) || (in_solid_ && is_last_line())) {
      return scanner_.expected("'facet' or 'endsolid'");
    } else {
      stray(in_quotes(word) + " was skipped");
    }
    scanner_.skip_line();
    return std::nullopt;
  }

  static bool is_part_of_facet(std::string_view word) {
    constexpr std::array<std::string_view, 7> kParts{"normal",  "outer",    "loop", "vertex",
                                                     "endloop", "endfacet", "end"};
    return std::any_of(kParts.begin(), kParts.end(),
                       [&](std::string_view part) { return equal_ignoring_case(word, part); });
  }

  // Returns true if the line of the last word is the last one.
  bool is_last_line() {
    const size_t before = scanner_.position();
    scanner_.skip_line();
    const bool last = scanner_.at_end();
    scanner_.seek(before);
    return last;
  }

  // Reads a facet after the word "facet".
  Problem read_facet() {
    Vec3 normal;
    std::array<Vec3, 3> corners;
    if (!in_solid_ && soup_.triangles.empty()) stray("'facet' without 'solid'");
    if (auto problem = need("normal")) return problem;
    if (auto problem = read_vector(normal)) return problem;
    for (const std::string_view keyword : {"outer", "loop"}) {
      if (auto problem = need(keyword)) return problem;
    }
    for (Vec3& corner : corners) {
      if (auto problem = need("vertex")) return problem;
      if (auto problem = read_vector(corner)) return problem;
    }
    if (auto problem = need_one("end", "loop")) return problem;
    if (auto problem = need_one("end", "facet")) return problem;
    add_triangle(corners, soup_);
    return std::nullopt;
  }

  // Consumes the next word if it is the keyword.
  bool next_is(std::string_view keyword) {
    scanner_.at_end();
    const size_t before = scanner_.position();
    if (equal_ignoring_case(scanner_.word(), keyword)) return true;
    scanner_.seek(before);
    return false;
  }

  Problem need(std::string_view keyword) {
    scanner_.at_end();
    if (equal_ignoring_case(scanner_.word(), keyword)) return std::nullopt;
    return scanner_.expected(in_quotes(keyword));
  }

  // Consumes a keyword whose two parts may be separate words.
  Problem need_one(std::string_view first, std::string_view second) {
    const std::string keyword = std::string(first) + std::string(second);
    if (!next_is(first)) return need(keyword);
    stray("'" + std::string(first) + " " + std::string(second) + "' was read as " + in_quotes(keyword));
    return need(second);
  }

  Problem read_vector(Vec3& vector) {
    for (int i = 0; i < 3; ++i) {
      scanner_.at_end();
      const std::optional<double> number = scanner_.number();
      if (!number) return scanner_.expected("a number");
      vector[i] = *number;
    }
    return std::nullopt;
  }

  // Counts a deviation from the format, in the line of the last word.
  void stray(const std::string& how) {
    if (strays_++ == 0) first_stray_ = "line " + std::to_string(scanner_.line()) + ": " + how;
  }

  void add_warning() {
    const size_t facets = soup_.triangles.size();
    soup_.warnings.push_back(
        "Invalid STL in " + (strays_ == 1 ? std::string() : grouped(strays_) + " places, the first in ") +
        first_stray_ + ". " + count_text(facets, "facet") + (facets == 1 ? " was read." : " were read."));
  }

  Scanner scanner_;
  const std::string& file_name_;
  Soup soup_;
  bool in_solid_ = false;
  size_t strays_ = 0;
  std::string first_stray_;  // "line 3: WHAT"
};

}  // namespace

bool is_exact_binary_stl(std::string_view bytes) {
  return bytes.size() >= kHeaderBytes &&
         bytes.size() == kHeaderBytes + kTriangleBytes * size_t{binary_count(bytes)};
}

Result<Soup> read_stl(std::string_view bytes, const std::string& file_name, const Progress* progress) {
  if (!is_exact_binary_stl(bytes) && is_text(bytes)) return TextReader(bytes, file_name, progress).read();
  return read_binary(bytes, file_name, progress);
}

}  // namespace kerf
