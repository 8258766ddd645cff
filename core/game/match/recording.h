#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/game/match/match.h"

namespace kerf {

// The format of recordings: raised when recordings change so that other versions of Kerf cannot read them, or
// when the same inputs lead to another world than before.
inline constexpr uint64_t kRecordingFormat = 1;

// Limits of the seed and of the duration [s] of a match that can be recorded.
inline constexpr uint64_t kMostSeed = 1'000'000'000'000'000;
inline constexpr size_t kMostSeconds = 36'000;

// A match as its file holds it, one JSON object a line:
//
//   {"kerf": "match", "format": 1, "program": "0.1.0", "rules": "games/standard.json",
//    "files": "0123456789abcdef", "seed": 1, "difficulty": "normal"}
//   {"inputs": [[ticks, throttle, steer, buttons, fire, width, heading, pitch], ...]}
//   {"hash": "0123456789abcdef", "machine": "..."}
//
// "format" and "program" are those of Fields::format. "files" is a hash of the rules and of all
// files that they name. A vehicle file "player" is in the head where the player drove another vehicle than
// that of the rules. Inputs are the player's controls, each for so many ticks; each line holds a second. Of
// the buttons the handbrake counts 1, asking for a vehicle 2, and giving up 4. The hash is that of the world
// at the end.
struct Recording {
  std::filesystem::path rules, player;  // player: empty where it is that of the rules
  uint64_t files = 0, seed = 1;
  Difficulty difficulty = Difficulty::kNormal;
  std::vector<Controls> controls;  // by tick
  std::optional<uint64_t> hash;
  std::string machine;  // on which it was made (see machine_kind); empty without a hash
  std::string damage;   // one sentence on what could not be read, or empty
  bool torn = false;    // only the last line could not be read, because it is incomplete
};

// Whether a file begins like a recording.
bool is_recording(const std::filesystem::path& file);

// Reads a recording up to its first damaged line, which `damage` tells. Bad input if the file or its first
// line cannot be read.
Result<Recording> read_recording(const std::filesystem::path& file);

// The text of a recording for a file in `folder`. Bad input if the path of the rules is not UTF-8.
Result<std::string> recording_text(const Recording& recording, const std::filesystem::path& folder);

// The files that a match is made of: the rules, and all that they name. Fails if one cannot be read.
Result<std::vector<std::filesystem::path>> files_of_match(const std::filesystem::path& rules_file,
                                                          const RulesDescription& rules);
// The hash of these files.
Result<uint64_t> hash_of_files(const std::filesystem::path& rules_file, const RulesDescription& rules);

const char* name_of(Difficulty difficulty);
std::optional<Difficulty> parse_difficulty(std::string_view name);

}  // namespace kerf
