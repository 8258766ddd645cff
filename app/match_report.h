#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "core/game/match/match.h"

namespace kerf {

// What came of a match, for --report: frames and frame_ms of the pictures (none without a window), and of the
// core ticks and tick_ms (nothing in a window), then the match itself.
nlohmann::ordered_json match_report(const Match& match, const std::vector<double>& frame_s,
                                    const std::vector<double>& tick_s);

// "won", "lost", or "quit" where a match is not over.
const char* result_of(const Match& match);

}  // namespace kerf
