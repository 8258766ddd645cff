#pragma once

#include "core/base/result.h"
#include "ui/editor/shared/settings.h"
#include "ui/game/game.h"

namespace kerf {

// Runs the editor until its window is closed or its script ends. Fails without a display or OpenGL 3.3, if
// not even the default scene can be read, at an invalid line of the script, or if the report cannot be
// written. F5 returns to `left`, a match that was suspended to inspect its world.
Status run_editor(const EditorOptions& options, SuspendedMatch left = {});

// Writes the world of a match as a scene in a folder next to the high scores, with the player's view and an
// emitter in place of the player's laser. Returns its file. Fails like save_world_as_scene.
Result<std::filesystem::path> save_match_as_scene(const Match& match, const View& view);

}  // namespace kerf
