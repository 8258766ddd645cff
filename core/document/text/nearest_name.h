#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kerf {

// Finds the name of a list that is most similar to a misspelt name: the minimum number of letters inserted,
// deleted, replaced or swapped with the next one, ignoring case; a name that the other one begins with
// counts 1 (F. J. Damerau, A technique for computer detection and correction of spelling errors, 1964).
// Returns the first of equally near names; empty for an empty list. O(letters^2).
std::string nearest_name(std::string_view name, std::span<const std::string> names);

// "; the nearest name is \"radius\"", or an empty text for an empty list.
std::string nearest_name_hint(std::string_view name, std::span<const std::string> names);

}  // namespace kerf
