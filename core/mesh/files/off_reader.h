#pragma once

#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/soup.h"

namespace kerf {

// Whether the word that a file begins with is a keyword of Geomview's OFF family: OFF, COFF, STCN4nOFF and
// all in between, followed by nothing or by a digit (a lost line break that is common).
bool is_off_keyword(std::string_view word);

// Reads OFF, COFF, NOFF, STOFF and their mixtures as text, with comments and with the counts on the first
// line or on one of their own. Of a vertex the position is read, of a face its corners; colours, normals and
// texture coordinates are passed over. Binary OFF and OFF in four or n dimensions are refused. A face that
// names a vertex that is not there is dropped and counted. Linear in the bytes, but for polygons (see
// Triangulator).
Result<Soup> read_off(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

}  // namespace kerf
