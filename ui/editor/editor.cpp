#include "ui/editor/editor.h"

#include <random>
#include <utility>

#include "core/base/json.h"
#include "core/base/platform.h"
#include "core/document/save.h"
#include "core/game/vehicle/vehicle.h"
#include "ui/editor/path/emitter.h"
#include "ui/editor/shared/document_session.h"
#include "ui/editor/shell/editor_screen.h"
#include "ui/game/game_settings.h"
#include "ui/screen/frame_loop.h"
#include "ui/window/gui.h"
#include "ui/window/window.h"

namespace kerf {

namespace {

// The games of an editor session. A game that was left to inspect its world is resumed.
class Games {
 public:
  Games(Window& window, FrameLoop& loop, EditorScreen& screen, const EditorOptions& options,
        std::optional<WindowedGame> game)
      : window_(window), loop_(loop), screen_(screen), options_(options), game_(std::move(game)) {}

  // Runs the game and passes its result to the editor.
  void play() {
    if (const Status begun = game_ ? Status(Done{}) : begin(); !begun) {
      screen_.resume_from_game(screen_.look(), {});
      return screen_.report_error(begun.error().message);
    }
    game_->set_look(screen_.look());  // the settings may have changed since it was left
    game_->play(loop_);
    const GuiLook look = game_->look();
    if (!game_->wants_inspection()) {
      const bool closes = game_->wants_close();
      game_.reset();
      screen_.resume_from_game(look, {});
      if (closes) screen_.quit();
      return;
    }
    const auto scene = save_match_as_scene(game_->match(), game_->view());
    screen_.resume_from_game(look, scene ? *scene : std::filesystem::path());
    screen_.report_error(scene ? "" : scene.error().message);
  }

 private:
  Status begin() {
    GameOptions options;
    auto rules = load_rules(assets_folder() / "games" / "standard.json");
    if (!rules) return rules.error();
    options.setup.rules = std::move(*rules);
    options.setup.seed = std::random_device()();
    options.look = screen_.look();
    options.from_editor = true;
    options.starts = true;
    options.landmarks = options_.landmarks;
    auto game = WindowedGame::begin(window_, options);
    if (!game) return game.error();
    game_.emplace(std::move(*game));
    return Done{};
  }

  Window& window_;
  FrameLoop& loop_;
  EditorScreen& screen_;
  const EditorOptions& options_;
  std::optional<WindowedGame> game_;
};

// Returns the pose of the player's laser, or of its mount after it came off.
Pose laser_pose(const Match& match) {
  const Vehicle& own = match.vehicles()[Match::kPlayer];
  if (own.gun.works()) return muzzle_pose(match.world(), own);
  const Placement& chassis = match.world().body(own.chassis).placement;
  return {chassis.to_world(own.what().turret.barrel.pivot), chassis.orientation * Vec3(0, 0, 1)};
}

Status run_in_window(const EditorOptions& options, LoadedSettings loaded, Window& window, Gui& gui,
                     FrameLoop& loop, std::optional<WindowedGame> game) {
  const std::string fault = loaded.fault;
  auto picture = LivePicture::create();
  if (!picture) return picture.error();
  EditorScreen screen(window, std::move(*picture), std::move(loaded), options);
  gui.dress(screen.look());
  if (const Status shown = screen.open(); !shown) return shown;
  screen.report_error(fault);
  bool left_by_user = loop.run(screen);
  Games games(window, loop, screen, options, std::move(game));
  while (left_by_user && screen.wants_game()) {
    games.play();
    left_by_user = loop.run(screen);
  }
  screen.close(left_by_user);
  if (!loop.fault().empty()) return bad_input(loop.fault());
  if (!options.report) return Done{};
  return write_file_atomically(
      *options.report,
      screen.report().dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

// Creates a folder "inspected-N". Saved documents refer to the meshes in earlier ones, which stay.
Result<std::filesystem::path> new_folder_for_match() {
  const std::filesystem::path beside = high_scores_file().parent_path();
  std::error_code error;
  std::filesystem::create_directories(beside, error);
  for (size_t number = 1; !error; ++number) {
    const auto folder = beside / ("inspected-" + std::to_string(number));
    if (std::filesystem::create_directory(folder, error)) return folder;
  }
  return failed(beside.string() + ": cannot create a folder: " + error.message());
}

}  // namespace

Result<std::filesystem::path> save_match_as_scene(const Match& match, const View& view) {
  const ArenaDescription& arena = match.rules().arena.description;
  SceneDescription scene;
  scene.lights = arena.lamps;
  scene.paints = arena.paints;
  for (const Vehicle& v : match.vehicles())
    scene.paints.insert(v.what().paints.begin(), v.what().paints.end());
  scene.view = view;
  const Pose laser = laser_pose(match);
  Emitter emitter;
  emitter.place(laser.origin, laser.origin + match.rules().description.laser.range / 4 * laser.direction);
  nlohmann::json entry = emitter_entry(emitter);
  const Interval& radius = match.rules().description.laser.radius;
  entry["radius"] = 0.5 * (radius.low + radius.high);
  set_head_entry(scene, kEmitterKey, entry);
  const auto folder = new_folder_for_match();
  if (!folder) return folder.error();
  return save_world_as_scene(match.world(), std::move(scene), *folder);
}

Status run_editor(const EditorOptions& options) {
  LoadedSettings loaded = read_settings(settings_file());
  WindowOptions wanted{options.width, options.height, options.events};
  if (wanted.width == 0) wanted = {loaded.settings.width, loaded.settings.height, options.events};
  auto opened = open_window(wanted);
  if (!opened) return opened.error();
  Gui gui(**opened);
  FrameLoop loop(**opened, gui);
  return run_in_window(options, std::move(loaded), **opened, gui, loop, std::nullopt);
}

Status run_editor_after_game(EditorOptions options, Window& window, Gui& gui, FrameLoop& loop,
                             WindowedGame game) {
  const auto scene = save_match_as_scene(game.match(), game.view());
  if (!scene) return scene.error();
  options.files = {*scene};
  return run_in_window(options, read_settings(settings_file()), window, gui, loop, std::move(game));
}

}  // namespace kerf
