#include "core/mesh/files/soup.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/mesh/files/scanner.h"
#include "core/mesh/files/triangulation.h"

namespace kerf {

void PolygonList::reserve(size_t polygons) {
  ends_.reserve(ends_.size() + polygons);
  corners_.reserve(corners_.size() + 3 * polygons);
}

void PolygonList::add_triangles(std::vector<Soup::Triangle> triangles) {
  if (size() == 0 && parts_.empty()) {
    triangles_ = std::move(triangles);
    return;
  }
  for (const Soup::Triangle& triangle : triangles) {
    for (const uint32_t corner : triangle) add_corner(corner);
    close();
  }
}

void PolygonList::put_triangles_in_list() {
  const std::vector<Soup::Triangle> triangles = std::exchange(triangles_, {});
  for (const Soup::Triangle& triangle : triangles) {
    corners_.insert(corners_.end(), triangle.begin(), triangle.end());
    close();
  }
}

void PolygonList::add_corner(int64_t vertex) {
  if (!triangles_.empty()) put_triangles_in_list();
  corners_.push_back(vertex >= 0 && vertex < kNoVertex ? static_cast<uint32_t>(vertex) : kNoVertex);
}

void PolygonList::close(uint16_t material) {
  if (!triangles_.empty()) put_triangles_in_list();
  if (material != 0 && materials_.empty()) materials_.resize(ends_.size());
  ends_.push_back(static_cast<uint32_t>(corners_.size()));
  if (material != 0 || !materials_.empty()) materials_.push_back(material);
}

void PolygonList::begin_parts(Level level, const std::vector<std::string>& names) {
  if (!triangles_.empty()) put_triangles_in_list();
  const auto here = static_cast<uint32_t>(size());
  std::vector<size_t>& open = open_[static_cast<size_t>(level)];
  for (const size_t part : open) parts_[part].last = here;
  open.clear();
  for (const std::string& name : names) {
    open.push_back(parts_.size());
    parts_.push_back({name, here, kNoVertex});
  }
}

std::vector<MeshPart> PolygonList::parts_of_triangles(const std::vector<uint32_t>& before) const {
  std::vector<MeshPart> parts;
  for (const MeshPart& part : parts_) {
    const uint32_t first = before[part.first], last = before[std::min<size_t>(part.last, size())];
    if (first < last) parts.push_back({part.name, first, last});
  }
  return parts;
}

namespace {

// Removes and counts the triangles that refer to missing vertices.
void drop_invalid(Soup& soup) {
  const auto invalid = [&](const Soup::Triangle& t) {
    return std::max({t[0], t[1], t[2]}) >= soup.positions.size();
  };
  soup.invalid_faces_dropped += std::erase_if(soup.triangles, invalid);
}

}  // namespace

void PolygonList::triangulate(std::span<const Vec3> positions, Soup& soup,
                              std::vector<Soup::Triangle>* corners) const {
  soup.triangles.reserve(size());
  Triangulator triangulator;
  std::vector<uint32_t> before;  // by polygon: the number of triangles before it
  uint32_t begin = 0;
  for (size_t i = 0; i < size(); ++i) {
    const std::span<const uint32_t> polygon(corners_.data() + begin, corners_.data() + ends_[i]);
    assert(begin <= ends_[i]);
    if (!parts_.empty()) before.push_back(static_cast<uint32_t>(soup.triangles.size()));
    const uint32_t first = std::exchange(begin, ends_[i]);
    if (polygon.size() < 3) {
      ++soup.incomplete_faces_dropped;
      continue;
    }
    const bool valid =
        std::all_of(polygon.begin(), polygon.end(), [&](uint32_t v) { return v < positions.size(); });
    soup.triangles_in_file += polygon.size() - 2;
    if (valid) {
      const size_t before_it = soup.triangles.size();
      triangulator.append(positions, polygon, soup.triangles);
      if (corners) triangulator.append_corners(soup.triangles.size() - before_it, first, *corners);
    } else {
      soup.invalid_faces_dropped += polygon.size() - 2;
    }
    if (!materials_.empty()) soup.materials.resize(soup.triangles.size(), materials_[i]);
  }
  before.push_back(static_cast<uint32_t>(soup.triangles.size()));
  soup.parts = parts_of_triangles(before);
}

Result<Soup> PolygonList::to_soup(std::vector<Vec3> positions, const std::string& file_name,
                                  std::vector<Soup::Triangle>* corners) {
  assert(!corners || triangles_.empty());
  Soup soup;
  soup.faces_in_file = size();
  if (triangles_.empty()) {
    triangulate(positions, soup, corners);
    soup.positions = std::move(positions);
  } else {
    soup.triangles_in_file = size();
    soup.triangles = std::exchange(triangles_, {});
    soup.positions = std::move(positions);
    drop_invalid(soup);
  }
  if (soup.triangles.empty()) return no_face_left(soup, file_name);
  return soup;
}

Error no_face_left(const Soup& soup, const std::string& file_name) {
  assert(soup.triangles.empty());
  const std::string name = one_line(file_name);
  if (soup.faces_in_file == 0) return bad_input(name + ": the file has no faces.");
  if (soup.triangles_in_file == 0) {
    return bad_input(name + ": no face is usable: all " + std::to_string(soup.faces_in_file) +
                     " have fewer than three corners.");
  }
  return bad_input(name + ": no face is usable: all " + std::to_string(soup.faces_in_file) +
                   (soup.incomplete_faces_dropped == 0
                        ? " refer to missing vertices."
                        : " refer to missing vertices or have fewer than three corners."));
}

}  // namespace kerf
