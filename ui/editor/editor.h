#pragma once

#include "core/base/result.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shell/catalogue.h"
#include "ui/game/game.h"

namespace kerf {

struct Workspace;

// All features of the editor. The order says who is asked first, and whose marks lie below those of others.
// The workspace and the catalogue, which is filled later, must outlive them.
Features make_features(Workspace& workspace, const Catalogue& catalogue);

// Runs the editor until its window is closed or its script ends. Fails if there is no display or no
// OpenGL 3.3, if not even the default scene can be read, at a line of the script that is wrong, or if the
// report cannot be written. With a match that was left for a look at its world, F5 goes back to it.
Status run_editor(const EditorOptions& options, LeftMatch left = {});

// Writes the world of a match as a scene in a folder beside the high scores: seen from where the player saw
// it, with an emitter where his laser is. Returns its file. Fails like save_world_as_scene.
Result<std::filesystem::path> save_match_as_scene(const Match& match, const View& view);

}  // namespace kerf
