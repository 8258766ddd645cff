#include "core/game/vehicle/soup_parts.h"

#include "core/base/assert.h"

namespace kerf {

namespace {

uint32_t part_of_group(const std::string& group, const std::vector<std::string>& parts) {
  auto best = static_cast<uint32_t>(parts.size());
  for (uint32_t p = 0; p < parts.size(); ++p) {
    const bool longer = best == parts.size() || parts[p].size() > parts[best].size();
    if (longer && is_of_part(group, parts[p])) best = p;
  }
  return best;
}

}  // namespace

std::vector<uint32_t> part_of_triangles(const Soup& soup, const std::vector<std::string>& parts) {
  std::vector<uint32_t> of(soup.triangles.size(), static_cast<uint32_t>(parts.size()));
  for (const MeshPart& group : soup.parts) {
    const uint32_t part = part_of_group(group.name, parts);
    if (part == parts.size()) continue;
    for (uint32_t t = group.first; t < group.last; ++t) of[t] = part;
  }
  return of;
}

Soup extract_part(const Soup& soup, const std::vector<uint32_t>& part, uint32_t wanted) {
  KERF_ASSERT(part.size() == soup.triangles.size());
  Soup own;
  own.positions = soup.positions;
  own.material_names = soup.material_names;
  own.format = soup.format;
  std::vector<uint32_t> before(part.size() + 1, 0);  // triangles of the part ahead of each one
  for (size_t t = 0; t < part.size(); ++t) {
    before[t + 1] = before[t] + (part[t] == wanted ? 1 : 0);
    if (part[t] != wanted) continue;
    own.triangles.push_back(soup.triangles[t]);
    if (!soup.materials.empty()) own.materials.push_back(soup.materials[t]);
  }
  for (const MeshPart& group : soup.parts) {
    const uint32_t first = before[group.first], last = before[group.last];
    if (first < last) own.parts.push_back({group.name, first, last});
  }
  own.faces_in_file = own.triangles_in_file = own.triangles.size();
  return own;
}

}  // namespace kerf
