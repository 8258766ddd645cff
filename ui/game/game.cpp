#include "ui/game/game.h"

#include "core/document/journal/save.h"
#include "ui/game/game_screen.h"
#include "ui/game/high_scores.h"
#include "ui/screen/frame_loop.h"
#include "ui/window/gui.h"
#include "ui/window/window.h"

namespace kerf {

Result<std::filesystem::path> save_inspected(const Match& match) {
  const ArenaDescription& arena = match.rules().arena.description;
  SceneDescription scene;
  scene.lights = arena.lamps;
  scene.paints = arena.paints;
  for (const Vehicle& v : match.vehicles())
    scene.paints.insert(v.what().paints.begin(), v.what().paints.end());
  return save_world_as_scene(match.world(), std::move(scene), high_scores_file().parent_path() / "inspected");
}

Result<GameOutcome> play_in(Window& window, FrameLoop& loop, const GameOptions& options) {
  auto picture = MatchPicture::create();
  if (!picture) return picture.error();
  GameScreen screen(window, std::move(*picture), options);
  loop.run(screen);
  GameOutcome outcome;
  outcome.inspect = screen.leave() == GameScreen::Leave::kInspect;
  outcome.look = screen.look();
  outcome.played = screen.played();
  outcome.frame_seconds = screen.frame_seconds();
  outcome.match = screen.take_match();
  return outcome;
}

Result<GameOutcome> play(const GameOptions& options, const WindowOptions& wanted) {
  auto opened = open_window(wanted);
  if (!opened) return opened.error();
  Window& window = **opened;
  Gui gui(window);
  FrameLoop loop(window, gui);
  auto played = play_in(window, loop, options);
  if (!loop.fault().empty()) return bad_input(loop.fault());
  return played;
}

}  // namespace kerf
