#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/base/result.h"
#include "ui/game/match_film.h"

namespace kerf {

// Plays the recording of a match again, prints the hash of its end, and holds it against the one that was
// recorded and, if given, an expected one. Films it if `film` is given. Fails if the hash differs from
// either, and for bad input.
Status replay_match(const std::filesystem::path& file, const std::optional<uint64_t>& expected,
                    const std::optional<MatchFilm::Options>& film);

}  // namespace kerf
