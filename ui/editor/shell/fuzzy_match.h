#pragma once

#include <optional>
#include <string_view>

namespace kerf {

// How well a text matches what was typed: the higher, the better, and nothing where it does not match. Every
// word that was typed must occur in the text as a subsequence of letters, in either case; letters at the
// beginning of a word and letters that follow each other count more than others. An empty query matches every
// text with 0. O(query * text).
std::optional<int> fuzzy_score(std::string_view query, std::string_view text);

}  // namespace kerf
