#pragma once

#include "core/base/result.h"
#include "ui/editor/shared/settings.h"
#include "ui/game/game.h"

namespace kerf {

class FrameLoop;
class Gui;
class Window;

// Runs the editor until its window is closed or its script ends. Fails without a display or OpenGL 3.3, if
// not even the default scene can be read, at an invalid line of the script, or if the report cannot be
// written.
Status run_editor(const EditorOptions& options);

// Runs the editor in the window of a suspended game, to inspect its world. F5 returns
// to the game. Fails likewise, and like save_match_as_scene.
Status run_editor_after_game(EditorOptions options, Window& window, Gui& gui, FrameLoop& loop,
                             WindowedGame game);

// Writes the world of a match as a scene in a new folder next to the high scores, with the player's view, an
// emitter in place of the player's laser, and the beam of the game at medium width. Returns its file. Fails
// like save_world_as_scene, or if the folder cannot be created.
Result<std::filesystem::path> save_match_as_scene(const Match& match, const View& view);

}  // namespace kerf
