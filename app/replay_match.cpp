#include "app/replay_match.h"

#include <iostream>

#include "app/progress_line.h"
#include "app/tell.h"
#include "core/document/text/hash_text.h"
#include "core/game/match/recording.h"
#include "core/physics/machine_kind.h"
#include "core/world/state_hash.h"

namespace kerf {

namespace {

Status play(Match& match, const Recording& recording, const std::optional<MatchFilm::Options>& filmed) {
  std::optional<MatchFilm> film;
  if (filmed) {
    auto begun = MatchFilm::begin(match, *filmed);
    if (!begun) return begun.error();
    film.emplace(std::move(*begun));
  }
  ProgressLine line(film ? "filming" : "replaying");
  const double all = static_cast<double>(recording.controls.size());
  for (size_t t = 0; t < recording.controls.size(); ++t) {
    if (interrupted()) return stopped();
    if (t % kTicksPerSecond == 0) line.update(static_cast<double>(t) / all);
    match.tick(recording.controls[t]);
    if (!film) continue;
    if (const Status followed = film->follow(match, recording.controls[t]); !followed) return followed;
  }
  return Done{};
}

Status judge(const std::string& file, uint64_t hash, const Recording& recording,
             const std::optional<uint64_t>& expected) {
  const auto differs = [&](uint64_t wanted, const std::string& why) {
    return failed(file + ": the state at the end is " + hash_text(hash) + " and not " + hash_text(wanted) +
                  why);
  };
  if (expected && *expected != hash) return differs(*expected, ", as --expect says");
  if (!recording.hash || *recording.hash == hash) return Done{};
  if (recording.version != kMatchVersion)
    return differs(*recording.hash,
                   ": an earlier version of Kerf made this recording, and matches go otherwise since");
  if (recording.machine == machine_kind())
    return differs(*recording.hash, ": the match went otherwise than when it was recorded");
  warn(file + ": bodies moved on another kind of machine (" + recording.machine +
       "), so the match ended otherwise here");
  return Done{};
}

}  // namespace

Status replay_match(const std::filesystem::path& file, const std::optional<uint64_t>& expected,
                    const std::optional<MatchFilm::Options>& film) {
  const auto recording = read_recording(file);
  if (!recording) return recording.error();
  if (!recording->damage.empty()) warn(recording->damage);
  auto rules = load_rules(recording->rules);
  if (!rules) return rules.error();
  const auto files = hash_of_files(recording->rules, (*rules)->description);
  if (!files) return files.error();
  if (*files != recording->files)
    return bad_input(
        file.string() + ": the rules " + recording->rules.string() +
        " or files that they name are others than the match was played with: put the old ones back");
  Match match({*rules, recording->seed, recording->difficulty});
  if (const Status played = play(match, *recording, film); !played) return played;
  const uint64_t hash = state_hash(match.world());
  std::cout << hash_text(hash) << '\n';
  return judge(file.string(), hash, *recording, expected);
}

}  // namespace kerf
