#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/game/match/match.h"

namespace kerf {

// The format of recordings: incremented when other versions of Kerf cannot read them, or when equal inputs
// lead to another world than before. Older formats are not read.
inline constexpr uint64_t kRecordingFormat = 4;

// Maximum seed and duration [s] of a recorded match.
inline constexpr uint64_t kMaxSeed = 1'000'000'000'000'000;
inline constexpr size_t kMaxSeconds = 36'000;

// A match as its file holds it, one JSON object a line:
//
//   {"kerf": "match", "format": 4, "program": "0.2.0", "rules": "games/standard.json",
//    "files": "0123456789abcdef", "seed": 1, "difficulty": "normal"}
//   {"inputs": [[ticks, throttle, steer, buttons, fire, width, heading, pitch], ...]}
//   {"hash": "0123456789abcdef", "machine": "..."}
//
// "format" and "program": see Fields::format. "files": the hash of the rules and of all files that they
// name. "player" and "arena": the files of the player's vehicle and of the arena, if they differ from those
// of the rules. Each input
// is a number of ticks with equal controls of the player; a line holds a second. Buttons are the sum of 1
// (handbrake), 2 (request a vehicle), 4 (give up), 8 (boost) and 16 times the upgrade. The hash is that of
// the final world.
struct Recording {
  std::filesystem::path rules, player, arena;  // the last two: empty if they are those of the rules
  uint64_t files = 0, seed = 1;
  Difficulty difficulty = Difficulty::kNormal;
  std::vector<Controls> controls;  // by tick
  std::optional<uint64_t> hash;
  std::string machine;  // kind of machine of the recording (see machine_kind); empty without a hash
  std::string damage;   // one sentence about what could not be read, or empty
  bool torn = false;    // only the last line is unreadable, because it is incomplete
};

// Returns true if a file begins like a recording.
bool is_recording(const std::filesystem::path& file);

// Reads a recording up to its first damaged line, which `damage` describes. Fails with bad input if the file
// or its first line cannot be read.
Result<Recording> read_recording(const std::filesystem::path& file);

// Returns the text of a recording for a file in `folder`. Fails with bad input if the path of the rules is
// not UTF-8.
Result<std::string> recording_text(const Recording& recording, const std::filesystem::path& folder);

// Returns the files of a match: the rules and all files that they name. Fails if one cannot be read.
Result<std::vector<std::filesystem::path>> files_of_match(const std::filesystem::path& rules_file,
                                                          const RulesDescription& rules);
// Returns the hash of files_of_match(). Fails likewise.
Result<uint64_t> hash_of_files(const std::filesystem::path& rules_file, const RulesDescription& rules);

const char* name_of(Difficulty difficulty);
std::optional<Difficulty> parse_difficulty(std::string_view name);

// A part of a match that lies within one wave.
struct MatchMoment {
  WaveStart start;         // of its wave
  Ticks from = 0, to = 0;  // since the start of the match
  size_t vehicle = 0;      // the most affected one, an index of Match::vehicles()
  double points = 0;       // of the player in it
};

// Records when the player scored, to find the best moment of a match.
class ScoreLog {
 public:
  static constexpr Ticks kMoment = 10 * kTicksPerSecond;
  static constexpr Ticks kAfterwards = 2 * kTicksPerSecond;  // duration after its last points

  // Records the events of the last tick. Call after every tick of the match.
  void on_tick(const Match& match);

  // The kMoment ticks in which the player got the most points, the first of them if there are several,
  // ending kAfterwards after the last of these points; without points the last ticks of the match. Shorter
  // if the wave or the match is. Returns nullopt if the match has no ticks. Linear time.
  std::optional<MatchMoment> best() const;

 private:
  struct Scored {
    Ticks tick;
    size_t wave;  // an index of waves_
    size_t vehicle;
    double points;
  };
  MatchMoment around(size_t wave, Ticks last) const;

  std::vector<WaveStart> waves_;
  std::vector<Scored> scored_;
  Ticks ticks_ = 0;
};

// Simulates the match with this setup and these controls of its player from `start` to `ticks` ticks since
// the start of the match, including those after its end, or until it is settled. Returns null if `stop`
// returns true. Precondition: start.standing.ticks <= ticks <= controls.size().
std::unique_ptr<Match> match_at(
    const MatchSetup& setup, const WaveStart& start, std::span<const Controls> controls, Ticks ticks,
    const std::function<bool()>& stop = [] { return false; });

}  // namespace kerf
