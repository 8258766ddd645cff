#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kerf {

// The name of a list that is most like another one, for an error about a misspelt name: the least number of
// letters inserted, left out, replaced or swapped with the next one, where case does not count, and a name
// that the other one begins with counts 1 (F. J. Damerau, A technique for computer detection and correction
// of spelling errors, 1964). Of equally near names the first one; empty for an empty list. O(letters^2).
std::string nearest_name(std::string_view name, std::span<const std::string> names);

// "; the nearest that there is: \"radius\"", or an empty text for an empty list.
std::string nearest_name_hint(std::string_view name, std::span<const std::string> names);

}  // namespace kerf
