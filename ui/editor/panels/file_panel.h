#pragma once

#include "core/document/scene.h"
#include "core/world/world.h"
#include "ui/editor/view/settings.h"
#include "ui/editor/view/view_state.h"

namespace kerf {

// The unit and the upward axis in which the world is shown, which are remembered for mesh files of this kind;
// what is in the files of the bodies, and what was put right when they were read.
void draw_file_panel(const World& world, const SceneDescription& scene, ViewState& view, Settings& settings);

}  // namespace kerf
