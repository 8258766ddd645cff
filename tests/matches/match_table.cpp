#include <algorithm>
#include <atomic>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <thread>
#include <vector>

#include "core/game/match/recording.h"
#include "tests/matches/match_course.h"

namespace kerf {
namespace {

constexpr Difficulty kLevels[] = {Difficulty::kEasy, Difficulty::kNormal, Difficulty::kHard};
constexpr double kStill = 60;                      // s, that a player who does nothing shall live
constexpr double kFirstBeam = 6, kFirstPart = 20;  // s

// Matches of the seeds 1 .. count, on all cores.
std::vector<MatchCourse> play_all(const std::shared_ptr<const Rules>& rules, Difficulty level,
                                  MatchDriver driver, size_t count, double seconds) {
  std::vector<MatchCourse> courses(count);
  std::atomic<size_t> next = 0;
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < std::max(1u, std::thread::hardware_concurrency()); ++t) {
    threads.emplace_back([&] {
      for (size_t i = next++; i < count; i = next++)
        courses[i] = play_course({rules, i + 1, level}, driver, seconds);
    });
  }
  for (std::thread& thread : threads) thread.join();
  return courses;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void print_matches(const std::vector<MatchCourse>& courses) {
  for (size_t i = 0; i < courses.size(); ++i) {
    const MatchCourse& c = courses[i];
    std::printf(
        "  seed %2zu: %s after %5.1f s, wave %zu, %2zu destroyed, beam %4.1f s, part %4.1f s, held %.1f s\n",
        i + 1,
        c.won    ? "won "
        : c.lost ? "lost"
                 : "runs",
        c.seconds, c.wave, c.enemies_destroyed, c.first_beam.value_or(-1), c.first_part.value_or(-1),
        c.longest_without_way);
  }
}

void print_level(Difficulty level, const std::vector<MatchCourse>& bots,
                 const std::vector<MatchCourse>& still) {
  std::vector<double> lost;
  size_t won = 0, beams = 0, parts = 0, at_once = 0, alive = 0;
  double held = 0;
  for (const MatchCourse& c : bots) {
    won += c.won;
    if (c.lost) lost.push_back(c.seconds);
    beams += c.first_beam && *c.first_beam <= kFirstBeam;
    parts += c.first_part && *c.first_part <= kFirstPart;
    at_once = std::max(at_once, c.kills_at_once);
    held = std::max(held, c.longest_without_way);
  }
  for (const MatchCourse& c : still) alive += !c.lost;
  const size_t all = bots.size();
  std::printf(
      "%-6s  won %zu of %zu, lost after %.0f s (median), first beam within %.0f s %zu, first part within "
      "%.0f s %zu, "
      "vital parts lost in a tick by several beams %zu, standing still alive after %.0f s %zu of %zu, held "
      "%.1f s\n",
      name_of(level), won, all, median(lost), kFirstBeam, beams, kFirstPart, parts, at_once, kStill, alive,
      still.size(), held);
}

int run(const std::string& file, const std::string& only, size_t count, double seconds, bool each) {
  const auto rules = load_rules(file);
  if (!rules) {
    std::fprintf(stderr, "%s\n", rules.error().message.c_str());
    return 2;
  }
  for (const Difficulty level : kLevels) {
    if (!only.empty() && only != name_of(level)) continue;
    const auto bots = play_all(*rules, level, MatchDriver::kBot, count, seconds);
    const auto still = play_all(*rules, level, MatchDriver::kStill, count, kStill);
    if (each) print_matches(bots);
    print_level(level, bots, still);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
  CLI::App app{"Bot matches of each level without a window, in a table"};
  std::string rules, level;
  size_t count = 20;
  double seconds = 600;
  bool each = false;
  app.add_option("RULES", rules, "The rules of the matches (.json)")->required();
  app.add_option("--level", level, "Only this level: easy, normal or hard");
  app.add_option("--matches", count, "How many of each level")->check(CLI::Range(1, 1000));
  app.add_option("--seconds", seconds, "The longest match")->check(CLI::Range(1, 3600));
  app.add_flag("--each", each, "A line for each match, too");
  CLI11_PARSE(app, argc, argv);
  return kerf::run(rules, level, count, seconds, each);
}
