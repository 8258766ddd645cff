#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace kerf {

// So many colours for pieces, in linear light: each is as far as possible, in OKLab, from all of `paints` and
// from the colours before it. They are cool and not bright, for what is warm in the picture is hot. The same
// paints give the same colours. O(count^2).
std::vector<glm::dvec3> piece_palette(std::span<const glm::dvec3> paints, size_t count);

}  // namespace kerf
