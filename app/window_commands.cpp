
#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

#include "app/arguments.h"
#include "app/console.h"
#include "app/version.h"
#include "core/base/json.h"
#include "core/base/number_format.h"
#include "core/base/platform.h"
#include "core/document/save.h"
#include "core/document/text/hash.h"
#include "core/game/match/match.h"
#include "core/game/match/recording.h"
#include "core/physics/physics.h"
#include "core/world/world.h"
#include "ui/editor/editor.h"
#include "ui/editor/shared/settings.h"
#include "ui/game/game.h"
#include "ui/game/game_settings.h"
#include "ui/screen/frame_loop.h"
#include "ui/window/gui.h"
#include "ui/window/window.h"

namespace kerf {

namespace {

struct EditorArguments {
  std::vector<std::string> files;
  std::string report, size, landmarks, events;
  bool own_font = false;
};

Status edit(const EditorArguments& a) {
  EditorOptions options;
  options.default_scene = assets_folder() / "scenes" / "car.json";
  for (const std::string& file : a.files) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return bad_input(file + ": no such file or command");
    options.files.emplace_back(file);
  }
  for (const auto& [option, file] : {std::pair{"--report", a.report}, {"--landmarks", a.landmarks}}) {
    if (file.empty()) continue;
    if (const Status free = inputs_of(a.files).check(option, file); !free) return free;
  }
  if (!a.report.empty()) options.report = a.report;
  if (!a.landmarks.empty()) options.landmarks = a.landmarks;
  if (!a.events.empty()) options.events = a.events;
  options.own_font = a.own_font;
  options.version = version_text();
  if (!a.size.empty()) {
    const auto size = parse_size(a.size);
    if (!size) return size.error();
    options.width = size->width;
    options.height = size->height;
  }
  return run_editor(options);
}

struct PlayArguments {
  std::string rules, arena, driver, difficulty, report, record, size, landmarks, events;
  uint64_t seed = 1;
  double seconds = 0;
  bool headless = false;
};

// Quantiles in ms of durations in s.
nlohmann::ordered_json times_of(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const auto at = [&](double share) {
    const auto i = static_cast<size_t>(share * static_cast<double>(seconds.size()));
    return seconds.empty() ? 0.0 : 1000 * seconds[std::min(i, seconds.size() - 1)];
  };
  return {{"p50", at(0.5)}, {"p99", at(0.99)}, {"max", at(1)}};
}

// Returns "won", "lost", "ended" if the time of a match without winner is up, or "quit" if it is not over.
const char* result_of(const Match& match) {
  switch (match.standing().phase) {
    case Standing::Phase::kWon:
      return "won";
    case Standing::Phase::kLost:
      return "lost";
    case Standing::Phase::kEnded:
      return "ended";
    default:
      return "quit";
  }
}

// Returns the outcome of a match for --report: frames and frame_ms (none without a window), ticks and tick_ms
// (none in a window), then the match itself.
nlohmann::ordered_json match_report(const Match& match, const std::vector<double>& frame_s,
                                    const std::vector<double>& tick_s) {
  const Standing& standing = match.standing();
  return {{"frames", frame_s.size()},
          {"frame_ms", times_of(frame_s)},
          {"ticks", standing.ticks},
          {"tick_ms", times_of(tick_s)},
          {"strokes", match.strokes()},
          {"faces", match.world().live_faces()},
          {"faces_removed", standing.faces_removed},
          {"pieces", standing.pieces},
          {"bodies", match.world().ids().size()},
          {"undo_depth", 0},
          {"score", standing.score},
          {"enemies_destroyed", standing.enemies_destroyed},
          {"wheels_lost", standing.wheels_lost},
          {"wave", standing.wave + 1},
          {"waves", match.rules().waves.size()},
          {"seconds", seconds_of_ticks(standing.ticks)},
          {"seed", match.setup().seed},
          {"difficulty", name_of(match.setup().difficulty)},
          {"result", result_of(match)},
          {"state_hash", hash_text(state_hash(match.world()))}};
}

// Returns the outcome of a match in one line.
std::string match_summary(const Match& match) {
  const Standing& standing = match.standing();
  const bool ended = standing.phase == Standing::Phase::kEnded;
  std::ostringstream text;
  text << (ended ? "time up" : result_of(match)) << " after " << seconds_of_ticks(standing.ticks)
       << " s: " << standing.score << " points, " << standing.enemies_destroyed
       << (standing.enemies_destroyed == 1 ? " wreck, " : " wrecks, ")
       << count_text(standing.pieces, "piece");
  return text.str();
}

// One run of `kerf play --headless`.
class PlayRun {
 public:
  explicit PlayRun(PlayArguments arguments) : arguments_(std::move(arguments)) {}

  Status run() {
    catch_interrupts();
    if (const Status s = check(); !s) return s;
    if (const Status s = load(); !s) return s;
    if (const Status s = check_outputs(); !s) return s;
    if (!arguments_.headless) return play_in_window();
    Match match(setup_);
    if (const Status s = play(match); !s) return s;
    if (const Status s = write_results(match); !s) return s;
    summarize(match_summary(match));
    return Done{};
  }

 private:
  using Clock = std::chrono::steady_clock;

  Status check() {
    if (!arguments_.driver.empty() && arguments_.driver != "bot" && arguments_.driver != "still")
      return bad_input("--driver: must be \"bot\" or \"still\"");
    const auto difficulty =
        parse_difficulty(arguments_.difficulty.empty() ? "normal" : arguments_.difficulty);
    if (!difficulty) return bad_input("--difficulty: must be \"easy\", \"normal\" or \"hard\"");
    setup_.difficulty = *difficulty;
    setup_.seed = arguments_.seed;
    for (const auto& [option, file] :
         {std::pair{"--record", arguments_.record}, {"--report", arguments_.report}}) {
      if (file.empty()) continue;
      std::error_code error;
      const std::filesystem::path folder = std::filesystem::absolute(file, error).parent_path();
      if (!std::filesystem::is_directory(folder, error))
        return bad_input(std::string(option) + ": no such folder: " + folder.string());
    }
    if (!arguments_.record.empty() && resolved(arguments_.record) == resolved(arguments_.report))
      return bad_input("--report: " + arguments_.report + " is the file of --record; use another name");
    starts_ = arguments_.rules.empty() && arguments_.arena.empty() && arguments_.driver.empty() &&
              arguments_.seconds == 0;
    arena_ = arguments_.arena;
    for (size_t i = 0; i < kArenaNames.size(); ++i) {
      if (arguments_.arena == kArenaNames[i]) arena_ = arena_file(static_cast<GameArena>(i));
    }
    if (arguments_.rules.empty()) arguments_.rules = (assets_folder() / "games" / "standard.json").string();
    return Done{};
  }

  Status check_outputs() const {
    const auto files = files_of_match(setup_.rules->file, setup_.rules->description);
    if (!files) return files.error();
    const InputFiles inputs = input_files(*files);
    for (const auto& [option, file] : {std::pair{"--record", arguments_.record},
                                       {"--report", arguments_.report},
                                       {"--landmarks", arguments_.landmarks}}) {
      if (const Status free = inputs.check(option, file); !free) return free;
    }
    return arguments_.record.empty() ? Status(Done{}) : check_writable(arguments_.record);
  }

  Status load() {
    ProgressLine line("loading the match");
    const Progress progress = line.progress();
    auto rules = load_rules(arguments_.rules, &progress, {}, arena_);
    if (!rules) return error_or_stopped(rules.error());
    setup_.rules = std::move(*rules);
    return Done{};
  }

  Status play_in_window() {
    GameOptions options;
    options.setup = setup_;
    options.selected_difficulty = !arguments_.difficulty.empty();
    const Settings settings = read_settings(settings_file()).settings;
    options.look = {settings.theme, settings.palette, static_cast<float>(settings.ui_scale), false};
    options.bot = arguments_.driver == "bot";
    options.starts = starts_;
    options.seconds = arguments_.seconds;
    if (!arguments_.landmarks.empty()) options.landmarks = arguments_.landmarks;
    PixelSize size{settings.width, settings.height};
    if (!arguments_.size.empty()) {
      if (const Status s = unpack(parse_size(arguments_.size), size); !s) return s;
    }
    end_on_interrupt();
    WindowOptions window{size.width, size.height, {}};
    if (!arguments_.events.empty()) window.events = arguments_.events;
    auto opened = open_window(window);
    if (!opened) return opened.error();
    options.look.scale *= (*opened)->scale();
    Gui gui(**opened);
    FrameLoop loop(**opened, gui);
    auto game = WindowedGame::begin(**opened, options);
    if (!game) return game.error();
    game->play(loop);
    if (game->look().palette != settings.palette) keep_palette(game->look());
    if (!loop.fault().empty()) return bad_input(loop.fault());
    setup_ = game->match().setup();
    controls_ = game->played();
    frame_s_ = game->frame_seconds();
    if (const Status s = write_results(game->match()); !s) return s;
    if (!game->wants_inspection()) return Done{};
    EditorOptions editor;
    editor.default_scene = assets_folder() / "scenes" / "car.json";
    editor.landmarks = options.landmarks;
    return run_editor_after_game(std::move(editor), **opened, gui, loop, std::move(*game));
  }

  // Saves the colours that were selected in the pause menu. They are a setting of the editor, of which others
  // may have changed since.
  static void keep_palette(const GuiLook& look) {
    Settings settings = read_settings(settings_file()).settings;
    settings.palette = look.palette;
    (void)write_settings(settings, settings_file());
  }

  Status play(Match& match) {
    ProgressLine line("playing");
    const double seconds = arguments_.seconds > 0 ? arguments_.seconds : match.seconds_left();
    const auto ticks = static_cast<Ticks>(std::ceil(seconds * kTicksPerSecond));
    // The time of a match may end in a pause, after which it is over.
    constexpr Ticks kPause = 60 * kTicksPerSecond;
    const Ticks most = arguments_.seconds > 0 ? ticks : ticks + kPause;
    BotPlayer bot(match);
    for (Ticks t = 0; t < most && !match.standing().over(); ++t) {
      if (interrupted()) return stopped();
      if (t % kTicksPerSecond == 0) line.update(static_cast<double>(t) / static_cast<double>(ticks));
      const auto began = Clock::now();
      const Controls controls =
          arguments_.driver == "bot" ? bot.next(match) : match.vehicles()[Match::kPlayer].controls;
      match.tick(controls);
      tick_s_.push_back(std::chrono::duration<double>(Clock::now() - began).count());
      controls_.push_back(controls);
    }
    return Done{};
  }

  // If the report cannot be written, the recording is.
  Status write_results(const Match& match) const {
    const Status report = write_report(match), record = write_record(match);
    return report ? record : report;
  }

  Status write_report(const Match& match) const {
    if (arguments_.report.empty()) return Done{};
    return write_file_atomically(arguments_.report, match_report(match, frame_s_, tick_s_).dump(2) + "\n");
  }

  Status write_record(const Match& match) const {
    if (arguments_.record.empty()) return Done{};
    const Rules& rules = match.rules();
    const auto files = hash_of_files(rules.file, rules.description);
    if (!files) return files.error();
    Recording recording;
    recording.rules = rules.file;
    recording.player = rules.player_file;
    recording.arena = rules.arena_file;
    recording.files = *files;
    recording.seed = setup_.seed;
    recording.difficulty = setup_.difficulty;
    recording.controls = controls_;
    recording.hash = state_hash(match.world());
    recording.machine = machine_kind();
    const std::filesystem::path file = arguments_.record;
    const auto text = recording_text(recording, std::filesystem::absolute(file).parent_path());
    if (!text) return text.error();
    return write_file_atomically(file, *text);
  }

  PlayArguments arguments_;
  bool starts_ = false;          // with the menu before a match
  std::filesystem::path arena_;  // empty: that of the rules
  MatchSetup setup_;
  std::vector<Controls> controls_;
  std::vector<double> tick_s_, frame_s_;
};

}  // namespace

void add_editor(CLI::App& app, Invocation& invocation) {
  auto a = std::make_shared<EditorArguments>();
  app.add_option("FILE", a->files,
                 "Scenes (.json) and meshes to open together in the editor, or a journal (.kerf)");
  app.add_option("--report", a->report, "The file for the JSON report of the session");
  app.add_option("--size", a->size, "Size of the editor's window, WxH");
  constexpr auto kHidden = "";  // from the help: these are for the tests of the window
  app.add_option("--landmarks", a->landmarks, "The file for the positions of widgets, as JSON")
      ->group(kHidden);
  app.add_option("--events", a->events, "A script of input events that drives the editor without a screen")
      ->group(kHidden);
  app.add_flag("--own-font", a->own_font, "Draw the panels without an installed font")->group(kHidden);
  invocation = [a] { return edit(*a); };
}

void add_play_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("play", "Play the game: car combat with roof-mounted lasers");
  auto a = std::make_shared<PlayArguments>();
  command->add_option("SCENE", a->rules, "The rules of a match (.json); the standard match without it");
  command->add_option("--arena", a->arena,
                      "The arena: yard, depot, or a file (.json); that of the rules without it");
  command->add_option("--driver", a->driver, "Driver: bot, or still for a parked car (you, in a window)");
  command->add_option("--difficulty", a->difficulty,
                      "easy, normal or hard (the last setting in a window, otherwise normal)");
  add_number(*command, "--seed", a->seed, {0, kMaxSeed}, "Random seed (1)");
  add_number(*command, "--seconds", a->seconds, {0.01, kMaxSeconds},
             "Stop after this many seconds of match time (no limit)");
  command->add_flag("--headless", a->headless, "Run without a window, as fast as possible");
  command->add_option("--report", a->report, "The file for the JSON report of the match");
  command->add_option("--record", a->record, "The file for the recording (.kerf), for kerf replay");
  command->add_option("--size", a->size, "Size of the window, WxH");
  command->add_option("--landmarks", a->landmarks, "The file for the positions of widgets, as JSON")
      ->group("");
  command->add_option("--events", a->events, "A script of input events that drives the game without a screen")
      ->group("");
  on_call(
      *command, invocation, [a] { return PlayRun(*a).run(); },
      "kerf play --driver bot --headless --seed 1 --seconds 5 --report match.json");
}

}  // namespace kerf
