#include "core/mesh/files/stl_reader.h"

#include <algorithm>
#include <optional>

#include "core/base/assert.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/polygon_list.h"
#include "core/mesh/files/scanner.h"

namespace kerf {
namespace {

constexpr size_t kCountAt = 80;
constexpr size_t kHeaderBytes = 84;
constexpr size_t kNormalBytes = 12;
constexpr size_t kTriangleBytes = 50;

uint32_t binary_count(std::string_view bytes) {
  KERF_ASSERT(bytes.size() >= kHeaderBytes);
  return load<uint32_t>(bytes.data() + kCountAt, std::endian::little);
}

bool equal_ignoring_case(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + ('a' - 'A') : a) == b; });
}

bool is_text(std::string_view bytes) {
  Scanner scanner(bytes, {}, {}, nullptr);
  scanner.at_end();
  return equal_ignoring_case(scanner.word(), "solid") && bytes.find('\0') == std::string_view::npos;
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

Result<Soup> read_binary(std::string_view bytes, const std::string& file_name, const Progress* progress) {
  Scanner scanner(bytes, file_name, {}, progress);
  scanner.seek(0);
  if (bytes.size() < kHeaderBytes) {
    return scanner.file_error("with " + std::to_string(bytes.size()) +
                              " bytes it is too short for an STL file");
  }
  scanner.take(kCountAt);
  const uint32_t count = load<uint32_t>(scanner.take(sizeof(uint32_t)), std::endian::little);
  if (count > scanner.left() / kTriangleBytes) {
    return scanner.byte_error("announces " + std::to_string(count) + " triangles, but the file holds only " +
                              std::to_string(scanner.left() / kTriangleBytes) +
                              "; it is cut short or no STL");
  }
  Soup soup;
  soup.positions.reserve(3 * size_t{count});
  soup.triangles.reserve(count);
  for (uint32_t i = 0; i < count; ++i) {
    if (scanner.cancelled()) return cancelled();
    add_triangle(load_corners(scanner.take(kTriangleBytes) + kNormalBytes), soup);
  }
  if (scanner.left() > 0) {
    soup.warnings.push_back(std::to_string(scanner.left()) +
                            (scanner.left() == 1 ? " byte after the last triangle was passed over."
                                                 : " bytes after the last triangle were passed over."));
  }
  return finished(std::move(soup), file_name);
}

class TextReader {
 public:
  TextReader(std::string_view bytes, const std::string& file_name, const Progress* progress)
      : scanner_(bytes, file_name, {}, progress), file_name_(file_name) {}

  Result<Soup> read() {
    while (next_is("solid")) {
      if (auto problem = read_solid()) return *problem;
    }
    if (!scanner_.at_end()) soup_.warnings.push_back("What follows the last 'endsolid' was passed over.");
    if (scanner_.garbled_numbers() > 0) soup_.warnings.push_back(scanner_.garbled_numbers_warning());
    return finished(std::move(soup_), file_name_);
  }

 private:
  using Problem = std::optional<Error>;

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

  Problem read_vector(Vec3& vector) {
    for (int i = 0; i < 3; ++i) {
      scanner_.at_end();
      const std::optional<double> number = scanner_.number();
      if (!number) return scanner_.expected("a number");
      vector[i] = *number;
    }
    return std::nullopt;
  }

  // Reads a solid after the word "solid" up to the end of the line of "endsolid".
  Problem read_solid() {
    scanner_.skip_line();
    while (next_is("facet")) {
      if (scanner_.cancelled()) return cancelled();
      if (auto problem = read_facet()) return problem;
    }
    if (!next_is("endsolid")) return scanner_.expected("'facet' or 'endsolid'");
    scanner_.skip_line();
    return std::nullopt;
  }

  // Reads a facet after the word "facet".
  Problem read_facet() {
    Vec3 normal;
    std::array<Vec3, 3> corners;
    if (auto problem = need("normal")) return problem;
    if (auto problem = read_vector(normal)) return problem;
    for (const std::string_view keyword : {"outer", "loop"}) {
      if (auto problem = need(keyword)) return problem;
    }
    for (Vec3& corner : corners) {
      if (auto problem = need("vertex")) return problem;
      if (auto problem = read_vector(corner)) return problem;
    }
    for (const std::string_view keyword : {"endloop", "endfacet"}) {
      if (auto problem = need(keyword)) return problem;
    }
    add_triangle(corners, soup_);
    return std::nullopt;
  }

  Scanner scanner_;
  const std::string& file_name_;
  Soup soup_;
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
