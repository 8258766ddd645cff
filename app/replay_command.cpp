#include <chrono>
#include <iostream>
#include <map>

#include "app/arguments.h"
#include "app/console.h"
#include "app/cut_output.h"
#include "app/run_description.h"
#include "core/cut/stopwatch.h"
#include "core/document/command_log.h"
#include "core/document/commands.h"
#include "core/document/replay.h"
#include "core/document/text/hash.h"
#include "core/game/match/recording.h"
#include "core/physics/physics.h"
#include "core/world/world.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/game/match_picture.h"
#include "ui/render/picture.h"

namespace kerf {

namespace {

struct ReplayArguments {
  std::string journal, out, expect, frames;
  double frames_per_second = 30;
  PictureArguments picture;
};

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
  return film ? film->end() : Done{};
}

Status judge(const std::string& file, uint64_t hash, const Recording& recording,
             const std::optional<uint64_t>& expected) {
  const auto differs = [&](uint64_t wanted, const std::string& why) {
    return failed(file + ": the final state is " + hash_text(hash) + ", expected " + hash_text(wanted) + why);
  };
  if (expected && *expected != hash) return differs(*expected, " (--expect)");
  if (!recording.hash || *recording.hash == hash) return Done{};
  if (recording.machine == machine_kind())
    return differs(*recording.hash, " (recorded): the match differs from the recording");
  warn(file + ": bodies moved on another kind of machine (" + recording.machine +
       "), so the match ended differently here");
  return Done{};
}

// Replays a recorded match, prints the final hash, and compares it with the recorded and the expected one, if
// any. Films it if `film` is given. Fails if lines were left out, if the hash differs from either, unless it
// was recorded on another kind of machine, and for bad input.
Status replay_match(const std::filesystem::path& file, const std::optional<uint64_t>& expected,
                    const std::optional<MatchFilm::Options>& film) {
  const auto recording = read_recording(file);
  if (!recording) return recording.error();
  if (recording->torn) warn(recording->damage);
  auto rules = load_rules(recording->rules, nullptr, recording->player, recording->arena);
  if (!rules) return rules.error();
  if (film) {
    auto inputs = files_of_match(recording->rules, (*rules)->description);
    if (!inputs) return inputs.error();
    inputs->push_back(file);
    if (const Status free = check_frames("--frames", film->folder, input_files(*inputs)); !free) return free;
  }
  const auto files = hash_of_files(recording->rules, (*rules)->description);
  if (!files) return files.error();
  if (*files != recording->files)
    return bad_input(file.string() + ": the rules " + recording->rules.string() +
                     " or files that they name have changed since the match was recorded; restore them");
  Match match({*rules, recording->seed, recording->difficulty});
  if (const Status played = play(match, *recording, film); !played) return played;
  const uint64_t hash = state_hash(match.world());
  std::cout << hash_text(hash) << '\n';
  if (!recording->damage.empty() && !recording->torn) return failed(recording->damage);
  const Status judged = judge(file.string(), hash, *recording, expected);
  return judged ? flush_output() : judged;
}

// One run of `kerf replay`.
class ReplayRun {
 public:
  explicit ReplayRun(ReplayArguments arguments) : arguments_(std::move(arguments)) {}

  Status run() {
    catch_interrupts();
    if (const auto s = check_arguments(); !s) return s;
    if (is_recording(arguments_.journal)) return run_match();
    const PiecesFolder folder{arguments_.out};
    record_inputs({arguments_.journal});
    if (const auto s = load(); !s) return s;
    if (const auto s = check_outputs(folder); !s) return s;
    if (!folder.path.empty()) {
      if (const auto s = folder.make(); !s) return s;
    }
    if (const auto s = begin_film(); !s) return s;
    Document document = document_of(std::move(work_.scene.world), work_.scene);
    Replay replay(work_.journal, document);
    if (const auto s = run_queue(replay, document); !s) return s;
    const uint64_t hash = state_hash(document.world());
    std::cout << hash_text(hash) << '\n';
    if (replay.looks_differ())
      warn(arguments_.journal + ": materials, images or UVs differ from those when the journal was saved");
    record_missed();
    if (!folder.path.empty()) {
      if (const auto s = folder.write(job_, document.world(), first_settings_.value_or(CutSettings())); !s)
        return s.error();
    }
    const Status judged = judge(replay, hash);
    return judged ? flush_output() : judged;
  }

 private:
  using Clock = std::chrono::steady_clock;

  Status check_arguments() {
    if (!arguments_.expect.empty()) {
      expected_ = parse_hash(arguments_.expect);
      if (!expected_) return bad_input("--expect: must be sixteen hexadecimal digits, like 0123456789abcdef");
    }
    return Done{};
  }

  Status run_match() const {
    if (!arguments_.out.empty()) return bad_input("--out: not available for matches");
    if (!arguments_.picture.show.empty()) return bad_input("--show: not available for matches");
    if (!arguments_.picture.section.empty()) return bad_input("--section: not available for matches");
    if (arguments_.picture.eye.empty() != arguments_.picture.target.empty())
      return bad_input("--eye and --target: give both for matches");
    std::optional<MatchFilm::Options> film;
    if (!arguments_.frames.empty()) {
      const auto picture = arguments_.picture.parse();
      if (!picture) return picture.error();
      if (const auto s = PiecesFolder{arguments_.frames}.make(); !s) return s;
      film = {arguments_.frames, picture->width, picture->height, arguments_.frames_per_second,
              picture->eye,      picture->target};
    }
    return replay_match(arguments_.journal, expected_, film);
  }

  Status check_outputs(const PiecesFolder& folder) const {
    const InputFiles inputs = inputs_of(arguments_.journal, work_);
    if (!folder.path.empty()) {
      if (const Status free = folder.check("--out", inputs); !free) return free;
    }
    return arguments_.frames.empty() ? Status(Done{}) : check_frames("--frames", arguments_.frames, inputs);
  }

  Status load() {
    const Stopwatch watch(job_.load_s);
    auto work = load_showing_progress(arguments_.journal, open_journal);
    if (const Status s = unpack(std::move(work), work_); !s) return s;
    if (work_.journal.torn) warn(work_.journal.damage);
    const World& world = work_.scene.world;
    for (const BodyId id : world.ids()) job_.record_loaded(world.body(id).loaded);
    job_.input_min_angle = smallest_angle(world);
    lasting_ = lasting_commands(work_.journal.commands);
    size_t strokes = 0;
    for (size_t i = 0; i < lasting_.size(); ++i) {
      strokes += lasting_[i] && cut_settings(work_.journal.commands[i]) != nullptr;
      strokes_.push_back(strokes);
      if (!lasting_[i]) continue;
      if (const CutSettings* settings = cut_settings(work_.journal.commands[i])) {
        if (!first_settings_) first_settings_ = *settings;
        job_.thermal = job_.thermal || settings->model == Model::kThermal;
      }
    }
    met_.assign(strokes, false);
    return Done{};
  }

  Status begin_film() {
    if (arguments_.frames.empty()) return Done{};
    auto picture = arguments_.picture.parse();
    if (!picture) return picture.error();
    if (const auto s = show_as_asked(arguments_.picture, work_.scene, arguments_.journal, *picture); !s)
      return s;
    if (const auto s = PiecesFolder{arguments_.frames}.make(); !s) return s;
    auto film =
        Film::begin(work_.scene, {*picture, arguments_.frames_per_second, arguments_.frames}, work_.journal);
    if (!film) return film.error();
    film_.emplace(std::move(*film));
    return Done{};
  }

  Status run_queue(Replay& replay, const Document& document) {
    const Stopwatch watch(job_.cut_s);
    ProgressLine line(film_ ? "filming" : "replaying");
    const Progress progress{[&](double) { return line.update(replay.fraction()); }};
    QueueRun how;
    if (film_) how.moves_a_step = 1;
    how.progress = &progress;
    how.told = [&](const Result<StepResult>& step) { return note(replay, document, step); };
    step_began_ = Clock::now();
    if (const Status run = replay.run(how); !run) return error_or_stopped(run.error());
    return film_ ? film_->end(document) : Done{};
  }

  // A step that fails also failed during recording; otherwise the hash differs.
  Status note(const Replay& replay, const Document& document, const Result<StepResult>& step) {
    if (interrupted()) return stopped();
    if (step) {
      ++job_.steps;
      const size_t stroke = replay.applied() > 0 ? strokes_[replay.applied() - 1] : 0;
      if (stroke > 0 && (step->delta.removed_faces > 0 || step->statistics.met_s > 0))
        met_[stroke - 1] = true;
      if (should_record(replay.applied(), document.history(), *step)) {
        job_.strokes = stroke > 0 ? stroke - 1 : 0;
        job_.record_step(*step, document.world(),
                         std::chrono::duration<double>(Clock::now() - step_began_).count());
      }
    } else {
      warn(step.error().message);
    }
    const Status filmed = film(replay, document, step ? &*step : nullptr);
    step_began_ = Clock::now();
    return filmed;
  }

  // Returns true for a step of a command that lasts. A redo executes such a command if it was undone before
  // it was executed, or again if its before-images were discarded: only the first execution is recorded.
  // `applied`: the number of commands so far.
  bool should_record(size_t applied, const UndoStack& history, const StepResult& step) {
    if (applied == 0) return false;
    const bool is_redone = std::holds_alternative<Redo>(work_.journal.commands[applied - 1]) && step.last &&
                           history.position() > 0;
    // The generation of a step is the number of its first command.
    const size_t begun = history.position() > 0 ? history.last().generation : 0;
    const size_t command = is_redone ? begun : applied;
    if (command == 0 || command > lasting_.size() || !lasting_[command - 1]) return false;
    const size_t first = recorded_by_.try_emplace(begun, applied).first->second;
    return !is_redone || first == applied;
  }

  void record_missed() {
    for (size_t i = 0; i < met_.size(); ++i) {
      if (!met_[i]) job_.missed.push_back(i);
    }
  }

  // The film leaves out undone commands and strokes that were recut.
  Status film(const Replay& replay, const Document& document, const StepResult* step) {
    if (!film_) return Done{};
    if (lasting_[replay.applied() - 1]) return film_->follow(document, step);
    film_->skip(document, step);
    return Done{};
  }

  static const CutSettings* cut_settings(const Command& command) {
    if (const auto* begin = std::get_if<BeginStroke>(&command)) return &begin->settings;
    const auto* recut = std::get_if<Recut>(&command);
    return recut != nullptr ? &recut->settings : nullptr;
  }

  Status judge(const Replay& replay, uint64_t hash) const {
    if (!replay.other_machine().empty()) {
      warn(arguments_.journal + ": bodies moved on another kind of machine (" + replay.other_machine() +
           "), so their recorded poses are used" +
           (replay.cut_otherwise() ? "; a stroke that was drawn while they moved cut differently here" : ""));
    }
    if (!work_.journal.damage.empty() && !work_.journal.torn) return failed(work_.journal.damage);
    if (const auto& d = replay.difference()) {
      return failed(arguments_.journal + ": line " + std::to_string(d->mark.line) + ": " + place_of(d->mark) +
                    " the state is " + hash_text(d->hash) + ", but the journal recorded " +
                    hash_text(d->mark.hash));
    }
    if (expected_ && *expected_ != hash) {
      return failed(arguments_.journal + ": the final state is " + hash_text(hash) + ", expected " +
                    hash_text(*expected_) + " (--expect)");
    }
    return Done{};
  }

  std::string place_of(const StateMark& mark) const {
    if (mark.commands == 0) return "before the first command";
    return "after command " + std::to_string(mark.commands) + " (" +
           command_label(work_.journal.commands[mark.commands - 1], FileUnit::kMetre) + ")";
  }

  ReplayArguments arguments_;
  std::optional<uint64_t> expected_;
  std::optional<CutSettings> first_settings_;  // of the first stroke that lasts
  OpenedFile work_;
  CutJob job_;
  std::optional<Film> film_;
  std::vector<bool> lasting_;             // by command of the journal
  std::vector<size_t> strokes_;           // number of lasting strokes up to and including each command
  std::vector<bool> met_;                 // by lasting stroke: true if it hit a mesh
  std::map<size_t, size_t> recorded_by_;  // by first command of a history step: `applied` at its first record
  Clock::time_point step_began_;
};

}  // namespace

void add_replay_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "replay",
      "Replay a journal or a recorded match, print its final hash and compare it with the recorded ones");
  auto a = std::make_shared<ReplayArguments>();
  command->add_option("JOURNAL", a->journal, "A journal or the recording of a match (.kerf)")->required();
  command->add_option("-o,--out", a->out, "A folder for the pieces and report.json, like that of kerf cut");
  command->add_option("--expect", a->expect, "The expected final hash");
  auto* frames =
      command->add_option("--frames", a->frames,
                          "A folder for a film in numbered PNGs; for a journal, the beam crosses the "
                          "diagonal of all meshes in four seconds, and undone commands are left out");
  add_number(*command, "--fps", a->frames_per_second, {1, 1000}, "Frames per second of the film (30)")
      ->needs(frames);
  a->picture.add_to(*command, frames);
  on_call(
      *command, invocation, [a] { return ReplayRun(*a).run(); }, "kerf replay assets/scenes/figure-08.kerf");
}

}  // namespace kerf
