#include "ui/figures/draw_figure.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/document/journal/opened_file.h"
#include "ui/figures/marks.h"
#include "ui/figures/match_figure.h"
#include "ui/figures/scene_options.h"
#include "ui/figures/split_diagram.h"
#include "ui/gl/offscreen_context.h"
#include "ui/render/picture/picture.h"
#include "ui/render/picture/png.h"
#include "ui/render/picture/studio.h"
#include "ui/window/offscreen_gui.h"

namespace kerf {

namespace {

constexpr double kStrip = 0.075;  // of the height
// Pixels, of a picture whose text and marks have their usual size: in print, and on a screen.
constexpr double kPrintHeight = 400, kScreenHeight = 720;

int strip_height(const FigureSize& size) { return static_cast<int>(std::lround(kStrip * size.height)); }

GuiLook look_for(const FigureSize& size, double usual_height) {
  GuiLook look;
  look.scale = static_cast<float>(std::min(size.height / usual_height, size.width / (1.6 * usual_height)));
  return look;
}

// The rows of a picture, and below them those of its caption.
Pixels with_caption(const gl::Framebuffer& picture, const std::string& caption, int strip,
                    OffscreenGui& gui) {
  const int width = picture.shape().width;
  Pixels all = read_pixels(picture.name(), width, picture.shape().height);
  const gl::Framebuffer paper({width, strip, 1, false});
  gui.draw(paper, [&] { draw_caption_strip(caption); });
  const Pixels below = read_pixels(paper.name(), width, strip);
  all.rgb.insert(all.rgb.end(), below.rgb.begin(), below.rgb.end());
  all.height += strip;
  return all;
}

Status draw_scene(const Figure& figure, const FigureSize& size, const std::filesystem::path& png) {
  auto work = open_file(figure.scene);
  if (!work) return work.error();
  auto options = options_for(figure.scene, work->scene, size.width, size.height - strip_height(size));
  if (!options) return options.error();
  options->spread = figure.spread;
  options->beam = figure.beam;
  options->mark_scale = figure.mark_scale * size.height / kScreenHeight;
  options->legends = false;
  const auto drawn = draw_picture(std::move(*work), *options);
  if (!drawn) return drawn.error();
  const Studio* studio = drawn->studio.get();
  OffscreenGui gui(look_for(size, kPrintHeight));
  if (!figure.rulers.empty())
    gui.draw(studio->framebuffer(), [&] { draw_rulers(figure.rulers, studio->view()); });
  return write_png(with_caption(studio->framebuffer(), figure.caption, strip_height(size), gui), png);
}

Status draw_without_scene(const Figure& figure, const FigureSize& size, const std::filesystem::path& png) {
  const auto context = gl::OffscreenContext::create();
  if (!context) return context.error();
  const gl::Framebuffer picture({size.width, size.height - strip_height(size), 1, false});
  if (!figure.match.empty()) {
    OffscreenGui display(look_for(size, kScreenHeight));
    const Status drawn = draw_match_figure(figure.match, figure.tick, picture, display);
    if (!drawn) return drawn;
  }
  OffscreenGui gui(look_for(size, kPrintHeight));
  if (!figure.diagram.empty()) gui.draw(picture, [] { draw_split_diagram(); });
  return write_png(with_caption(picture, figure.caption, strip_height(size), gui), png);
}

}  // namespace

Status draw_figure(const Figure& figure, const FigureSize& size, const std::filesystem::path& png) {
  KERF_ASSERT(std::min(size.width, size.height) >= 64);
  KERF_ASSERT((!figure.scene.empty() + !figure.match.empty() + !figure.diagram.empty()) == 1);
  return figure.scene.empty() ? draw_without_scene(figure, size, png) : draw_scene(figure, size, png);
}

}  // namespace kerf
