#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/files/soup.h"

namespace kerf {

// Whether a group of a mesh belongs to a part: its name begins with that of the part.
inline bool is_of_part(std::string_view group, std::string_view part) { return group.starts_with(part); }

// For each triangle the index of the part to which one of its groups belongs, or parts.size(). Where a group
// belongs to several parts, the one with the longest name counts. O(groups * parts + triangles).
std::vector<uint32_t> part_of_triangles(const Soup& soup, const std::vector<std::string>& parts);

// The triangles of a soup for which `part` has this value, with their groups. The result may be empty.
Soup extract_part(const Soup& soup, const std::vector<uint32_t>& part, uint32_t wanted);

}  // namespace kerf
