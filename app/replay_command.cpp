#include <CLI/CLI.hpp>
#include <iostream>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/interrupt.h"
#include "app/pieces_folder.h"
#include "app/progress_line.h"
#include "app/tell.h"
#include "core/cut/stopwatch.h"
#include "core/document/command_words.h"
#include "core/document/hash_text.h"
#include "core/document/replay.h"
#include "core/world/state_hash.h"

namespace kerf {

namespace {

constexpr size_t kMovesOfStep = 64;

struct ReplayArguments {
  std::string journal, out, expect;
};

// One run of `kerf replay`.
class ReplayRun {
 public:
  explicit ReplayRun(ReplayArguments arguments) : arguments_(std::move(arguments)) {}

  Status run() {
    if (const auto s = check_arguments(); !s) return s;
    if (const auto s = load(); !s) return s;
    const PiecesFolder folder{arguments_.out};
    if (!folder.path.empty()) {
      if (const auto s = folder.make(); !s) return s;
    }
    Replay replay(journal_, document_);
    if (const auto s = walk(replay); !s) return s;
    const uint64_t hash = state_hash(document_.world());
    std::cout << hash_text(hash) << '\n';
    if (!folder.path.empty()) {
      if (const auto s = folder.write(job_, document_.world(), first_settings()); !s) return s;
    }
    return judge(replay, hash);
  }

 private:
  Status check_arguments() {
    if (arguments_.expect.empty()) return Done{};
    expected_ = parse_hash(arguments_.expect);
    if (!expected_) return bad_input("--expect: must be sixteen hexadecimal digits, like 0123456789abcdef");
    return Done{};
  }

  Status load() {
    auto journal = read_journal(arguments_.journal);
    if (!journal) return journal.error();
    journal_ = std::move(*journal);
    if (!journal_.damage.empty()) warn(journal_.damage);
    ProgressLine line("loading");
    const Progress progress = line.progress();
    const Stopwatch watch(job_.load_s);
    auto scene = load_scene(journal_.scene, &progress);
    if (!scene) return error_or_stopped(scene.error());
    for (const BodyId id : scene->world.ids()) job_.note_loaded(scene->world.body(id).loaded);
    job_.input_min_angle = smallest_angle(scene->world);
    document_ = Document(std::move(scene->world));
    return Done{};
  }

  Status walk(Replay& replay) {
    const Stopwatch watch(job_.cut_s);
    ProgressLine line("replaying");
    const Progress within{[&](double) { return line.update(replay.fraction()); }};
    while (!replay.done()) {
      if (!within.report(0)) return stopped();
      double seconds = 0;
      const Result<StepResult> step = [&] {
        const Stopwatch step_watch(seconds);
        return replay.advance(kMovesOfStep, &within);
      }();
      if (interrupted()) return stopped();
      if (step) {
        job_.note_step(*step, seconds);
      } else {
        warn(step.error().message);  // as it was when the journal was made, or the hash will tell
      }
    }
    return Done{};
  }

  CutSettings first_settings() const {
    for (const Command& command : journal_.commands) {
      if (const auto* begin = std::get_if<BeginStroke>(&command)) return begin->settings;
    }
    return {};
  }

  Status judge(const Replay& replay, uint64_t hash) const {
    if (const auto& d = replay.difference()) {
      const size_t n = d->mark.commands;
      const std::string after =
          n > 0 ? "after command " + std::to_string(n) + " (" + words(journal_.commands[n - 1]) + ")"
                : "before the first command";
      return failed(arguments_.journal + ": line " + std::to_string(d->mark.line) + ": " + after +
                    " the state is " + hash_text(d->hash) + " and not " + hash_text(d->mark.hash) +
                    ": another version of Kerf made this journal, or it was changed");
    }
    if (expected_ && *expected_ != hash) {
      return failed(arguments_.journal + ": the state at the end is " + hash_text(hash) + " and not " +
                    hash_text(*expected_) + " as --expect says");
    }
    return Done{};
  }

  ReplayArguments arguments_;
  std::optional<uint64_t> expected_;
  Journal journal_;
  Document document_;
  CutJob job_;
};

}  // namespace

void add_replay_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "replay", "Replay a journal, print the hash of its end and hold it to those recorded");
  auto a = std::make_shared<ReplayArguments>();
  command->add_option("JOURNAL", a->journal, "A journal (.kerf)")->required();
  command->add_option("--out", a->out, "A folder for the pieces and report.json, as kerf cut writes them");
  command->add_option("--expect", a->expect, "The hash that the end must have");
  command->callback([a, &action] {
    action = [a] {
      catch_interrupts();
      const Status status = ReplayRun(*a).run();
      return status ? 0 : report_error(status.error());
    };
  });
}

}  // namespace kerf
