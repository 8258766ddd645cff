#pragma once

#include <filesystem>
#include <functional>

#include "core/game/match/recording.h"
#include "ui/gl/framebuffer.h"
#include "ui/window/offscreen_gui.h"

namespace kerf {

// The moment of a recorded match as its player saw it, with the head-up display, drawn without a screen. An
// OpenGL context must be current.
//
// Plays the match up to the tick, by the rules as they are: if these changed since the match was recorded,
// the figure shows another fight. Fails if the recording or its rules cannot be read, or if the recording is
// shorter.
Status draw_match_figure(const std::filesystem::path& file, Ticks tick, const gl::Framebuffer& picture,
                         OffscreenGui& gui);

}  // namespace kerf
