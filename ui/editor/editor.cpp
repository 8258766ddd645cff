#include "ui/editor/editor.h"

#include <nlohmann/json.hpp>
#include <random>

#include "core/base/atomic_file.h"
#include "core/document/journal/save.h"
#include "ui/editor/features.h"
#include "ui/editor/shell/editor_screen.h"
#include "ui/game/game.h"
#include "ui/render/bodies/assets.h"
#include "ui/screen/frame_loop.h"
#include "ui/window/window.h"

namespace kerf {

namespace {

// Lets the player play, and tells the editor what came of it.
void play_game(Window& window, FrameLoop& loop, EditorScreen& screen, const EditorOptions& options) {
  auto rules = load_rules(assets_folder() / "games" / "standard.json");
  if (!rules) {
    screen.come_back(screen.look(), {});
    return screen.tell(rules.error().message);
  }
  GameOptions game;
  game.setup.rules = std::move(*rules);
  game.setup.seed = std::random_device()();
  game.look = screen.look();
  game.from_editor = true;
  game.landmarks = options.landmarks;
  auto played = play_in(window, loop, game);
  if (!played) {
    screen.come_back(screen.look(), {});
    return screen.tell(played.error().message);
  }
  std::filesystem::path scene;
  std::string fault;
  if (played->inspect) {
    auto saved = save_inspected(*played->match);
    if (saved) scene = *saved;
    if (!saved) fault = saved.error().message;
  }
  screen.come_back(played->look, scene);
  screen.tell(fault);
}

}  // namespace

Status run_editor(const EditorOptions& options) {
  LoadedSettings loaded = read_settings(settings_file());
  const std::string fault = loaded.fault;
  WindowOptions wanted{options.width, options.height, options.events};
  if (wanted.width == 0) wanted = {loaded.settings.width, loaded.settings.height, options.events};
  auto opened = open_window(wanted);
  if (!opened) return opened.error();
  Window& window = **opened;
  auto picture = LivePicture::create();
  if (!picture) return picture.error();
  Gui gui(window);
  FrameLoop loop(window, gui);
  EditorScreen screen(window, std::move(*picture), std::move(loaded), options, make_features);
  gui.dress(screen.look());
  if (const Status shown = screen.open(); !shown) return shown;
  screen.tell(fault);
  bool left_by_user = loop.run(screen);
  while (left_by_user && screen.wants_game()) {
    play_game(window, loop, screen, options);
    left_by_user = loop.run(screen);
  }
  screen.close(left_by_user);
  if (!loop.fault().empty()) return bad_input(loop.fault());
  if (!options.report) return Done{};
  return write_file_atomically(
      *options.report,
      screen.report().dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace kerf
