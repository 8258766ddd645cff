#include <algorithm>
#include <atomic>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <thread>
#include <vector>

#include "core/base/ids.h"
#include "core/game/match/recording.h"
#include "tests/matches/endurance.h"
#include "tests/matches/match_course.h"

namespace kerf {
namespace {

constexpr Difficulty kLevels[] = {Difficulty::kEasy, Difficulty::kNormal, Difficulty::kHard};
constexpr double kStill = 60;                      // s, that a player who does nothing shall live
constexpr double kOutlives = 10;                   // s, from the first hit
constexpr double kFirstBeam = 6, kFirstPart = 10;  // s

// Calls play(i) for 0 .. count - 1, on all cores.
template <typename Play>
void play_all(size_t count, Play play) {
  std::atomic<size_t> next = 0;
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < std::max(1u, std::thread::hardware_concurrency()); ++t) {
    threads.emplace_back([&] {
      for (size_t i = next++; i < count; i = next++) play(i);
    });
  }
  for (std::thread& thread : threads) thread.join();
}

// Matches of the seeds from `first` on.
std::vector<MatchCourse> courses_of(const std::shared_ptr<const Rules>& rules, Difficulty level,
                                    MatchDriver driver, size_t first, size_t count, double seconds) {
  std::vector<MatchCourse> courses(count);
  play_all(count, [&](size_t i) { courses[i] = play_course({rules, first + i, level}, driver, seconds); });
  return courses;
}

// MiB of memory that the program has now; 0 where the system does not say.
size_t memory_now() {
  std::ifstream file("/proc/self/statm");
  size_t all = 0, resident = 0;
  file >> all >> resident;
  return resident * 4096 >> 20;
}

// Returns whether no match had a fault. Prints a line each as it ends.
bool endure_level(const std::shared_ptr<const Rules>& rules, Difficulty level, size_t first, size_t count,
                  double seconds) {
  std::atomic<size_t> faults = 0;
  play_all(count, [&](size_t i) {
    const Endurance e = endure({rules, first + i, level}, seconds);
    faults += e.fault.empty() ? 0 : 1;
    std::printf(
        "%-6s seed %3zu: %6.1f s, %3zu bodies, tick %.2f ms, p99 %.2f, longest %.1f, %4zu MiB, %016llx %s\n",
        name_of(level), first + i, static_cast<double>(e.ticks) / kTicksPerSecond, e.most_bodies,
        1e3 * e.median_s, 1e3 * e.slow_s, 1e3 * e.longest_s, memory_now(),
        static_cast<unsigned long long>(e.hash), e.fault.c_str());
    std::fflush(stdout);
  });
  return faults == 0;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void print_matches(const std::vector<MatchCourse>& courses, size_t first) {
  for (size_t i = 0; i < courses.size(); ++i) {
    const MatchCourse& c = courses[i];
    std::printf(
        "  seed %2zu: %s after %5.1f s, wave %zu, %2zu destroyed, beam %4.1f s, part %4.1f s, hit %4.1f s, "
        "death "
        "%4.1f s, held %.1f s\n",
        first + i,
        c.won    ? "won "
        : c.lost ? "lost"
                 : "runs",
        c.seconds, c.wave, c.enemies_destroyed, c.first_beam.value_or(-1), c.first_part.value_or(-1),
        c.first_hit.value_or(-1), c.first_death.value_or(-1), c.longest_without_way);
  }
}

void print_level(Difficulty level, const std::vector<MatchCourse>& bots,
                 const std::vector<MatchCourse>& still) {
  std::vector<double> lost, lengths, contacts;
  size_t won = 0, beams = 0, parts = 0, at_once = 0, alive = 0;
  double held = 0;
  for (const MatchCourse& c : bots) {
    won += c.won;
    if (c.lost) lost.push_back(c.seconds);
    lengths.push_back(c.seconds);
    if (c.first_part && c.first_cut) contacts.push_back(*c.first_part - *c.first_cut);
    beams += c.first_beam && *c.first_beam <= kFirstBeam;
    parts += c.first_part && *c.first_part <= kFirstPart;
    at_once = std::max(at_once, c.kills_at_once);
    held = std::max(held, c.longest_without_way);
  }
  size_t outlived = 0;
  MovedParts off, heavy;
  for (const MatchCourse& c : bots) {
    off += c.parts;
    heavy += c.heavy_parts;
  }
  for (const MatchCourse& c : still) {
    alive += !c.lost;
    outlived += outlives(c, kOutlives);
  }
  const size_t all = bots.size();
  std::printf(
      "%-6s  won %zu of %zu, after %.0f s (median), lost after %.0f s (median), first part %.1f s after "
      "contact "
      "(median), first beam within %.0f s %zu, first part within "
      "%.0f s %zu, "
      "vital parts lost in a tick by several beams %zu, standing still alive after %.0f s %zu of %zu, %.0f s "
      "after the first hit %zu, held %.1f s, parts that moved %zu of %zu (%zu were touched and stayed), "
      "heavier "
      "ones %zu of %zu (%zu)\n",
      name_of(level), won, all, median(lengths), median(lost), median(contacts), kFirstBeam, beams,
      kFirstPart, parts, at_once, kStill, alive, still.size(), kOutlives, outlived, held, off.moved, off.all,
      off.held, heavy.moved, heavy.all, heavy.held);
}

struct Wanted {
  std::string rules, arena, level;
  size_t count = 20, first = 1;
  double seconds = 600;
  bool each = false, endure = false;
};

int run(const Wanted& wanted) {
  const auto rules = load_rules(wanted.rules, nullptr, {}, wanted.arena);
  if (!rules) {
    std::fprintf(stderr, "%s\n", rules.error().message.c_str());
    return 2;
  }
  bool sound = true;
  for (const Difficulty level : kLevels) {
    if (!wanted.level.empty() && wanted.level != name_of(level)) continue;
    if (wanted.endure) {
      sound = endure_level(*rules, level, wanted.first, wanted.count, wanted.seconds) && sound;
      continue;
    }
    const auto bots =
        courses_of(*rules, level, MatchDriver::kBot, wanted.first, wanted.count, wanted.seconds);
    const auto still = courses_of(*rules, level, MatchDriver::kStill, wanted.first, wanted.count, kStill);
    if (wanted.each) print_matches(bots, wanted.first);
    if (wanted.each) print_matches(still, wanted.first);
    print_level(level, bots, still);
    std::fflush(stdout);
  }
  return sound ? 0 : 1;
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
  CLI::App app{"Bot matches of each level without a window, in a table"};
  kerf::Wanted wanted;
  app.add_option("RULES", wanted.rules, "The rules of the matches (.json)")->required();
  app.add_option("--arena", wanted.arena, "The arena (.json) instead of that of the rules");
  app.add_option("--level", wanted.level, "Only this level: easy, normal or hard");
  app.add_option("--matches", wanted.count, "How many of each level")->check(CLI::Range(1, 1000));
  app.add_option("--seconds", wanted.seconds, "The longest match")->check(CLI::Range(1, 3600));
  app.add_flag("--each", wanted.each, "A line for each match, too");
  app.add_flag("--endure", wanted.endure,
               "A line for each match with its ticks, memory, hash and faults instead");
  app.add_option("--first", wanted.first, "The seed of the first match");
  CLI11_PARSE(app, argc, argv);
  return kerf::run(wanted);
}
