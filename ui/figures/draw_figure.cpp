#include "ui/figures/draw_figure.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/tick.h"
#include "core/document/journal.h"
#include "core/game/match/recording.h"
#include "ui/figures/split_diagram.h"
#include "ui/game/game_camera.h"
#include "ui/game/hud.h"
#include "ui/game/match_picture.h"
#include "ui/gl/context.h"
#include "ui/gl/image.h"
#include "ui/render/offscreen_renderer.h"
#include "ui/render/picture.h"
#include "ui/window/gui.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr double kStrip = 0.075;  // of the height
// Heights [pixels] of images with text and marks of the usual size: in print, and on a screen.
constexpr double kPrintHeight = 400, kScreenHeight = 720;

constexpr double kMatchFieldOfView = 62;            // degrees
constexpr Ticks kRemembered = 4 * kTicksPerSecond;  // lifetime of sparks, scorches and HUD notices

constexpr ImU32 kPaper = IM_COL32(255, 255, 255, 255), kInk = IM_COL32(0x1b, 0x1f, 0x26, 255);
constexpr ImU32 kRuler = IM_COL32(0xff, 0xff, 0xff, 255), kEdge = IM_COL32(0, 0, 0, 200);
constexpr float kMargin = 1.2f;  // em

int strip_height(const FigureSize& size) { return static_cast<int>(std::lround(kStrip * size.height)); }

GuiLook look_for(const FigureSize& size, double usual_height) {
  GuiLook look;
  look.scale = static_cast<float>(std::min(size.height / usual_height, size.width / (1.6 * usual_height)));
  return look;
}

ImVec2 on_picture(const CameraView& view, const Vec3& p) {
  const Vec3 seen = view.project(p);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  return {size.x * static_cast<float>(0.5 + 0.5 * seen.x), size.y * static_cast<float>(0.5 - 0.5 * seen.y)};
}

// Draws a line with an arrow head at each end. `along` is the unit vector from one to the other.
void draw_arrows(ImDrawList& list, ImVec2 from, ImVec2 to, ImVec2 along, ImU32 colour, float width) {
  const float head = 0.45f * ImGui::GetFontSize();
  list.AddLine(from, to, colour, width);
  for (const auto& [tip, sign] : {std::pair{from, 1.0f}, {to, -1.0f}}) {
    const ImVec2 base(tip.x + sign * head * along.x, tip.y + sign * head * along.y);
    const ImVec2 side(-0.4f * head * along.y, 0.4f * head * along.x);
    list.AddTriangleFilled(tip, {base.x + side.x, base.y + side.y}, {base.x - side.x, base.y - side.y},
                           colour);
    // The end stroke of the dimension line.
    const ImVec2 tick(-head * along.y, head * along.x);
    list.AddLine({tip.x - tick.x, tip.y - tick.y}, {tip.x + tick.x, tip.y + tick.y}, colour, width);
  }
}

void draw_text(ImDrawList& list, ImVec2 at, const std::string& text) {
  for (const auto& [x, y] : {std::pair{-1.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, -1.0f}, {0.0f, 1.0f}})
    list.AddText({at.x + x, at.y + y}, kEdge, text.c_str());
  list.AddText(at, kRuler, text.c_str());
}

void draw_ruler(const Ruler& ruler, const CameraView& view) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 from = on_picture(view, ruler.from), to = on_picture(view, ruler.to);
  const float length = std::max(1e-3f, std::hypot(to.x - from.x, to.y - from.y));
  const ImVec2 along((to.x - from.x) / length, (to.y - from.y) / length);
  const float width = std::max(1.5f, 0.11f * ImGui::GetFontSize());
  draw_arrows(list, from, to, along, kEdge, width + 2);
  draw_arrows(list, from, to, along, kRuler, width);
  // The text is centred above a horizontal line that is longer than it, otherwise placed at the right.
  const ImVec2 size = ImGui::CalcTextSize(ruler.text.c_str());
  const ImVec2 middle(0.5f * (from.x + to.x), 0.5f * (from.y + to.y));
  const float gap = 0.5f * ImGui::GetFontSize();
  const bool over = std::abs(along.x) > std::abs(along.y) && length > size.x;
  const float right = std::max(from.x, to.x);
  draw_text(list,
            over ? ImVec2(middle.x - 0.5f * size.x, middle.y - size.y - gap)
                 : ImVec2(right + gap, middle.y - 0.5f * size.y),
            ruler.text);
}

// Draws dimension lines with arrow heads at their ends and their texts next to them.
void draw_rulers(const std::vector<Ruler>& rulers, const CameraView& view) {
  for (const Ruler& ruler : rulers) draw_ruler(ruler, view);
}

// Fills the image with the paper colour and writes a text of at most two lines on it.
void draw_caption_strip(const std::string& text) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 picture = ImGui::GetIO().DisplaySize;
  const float margin = kMargin * ImGui::GetFontSize(), width = picture.x - 2 * margin;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
  list.AddRectFilled({0, 0}, picture, kPaper);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {margin, 0.5f * (picture.y - size.y)}, kInk,
               text.c_str(), nullptr, width);
}

// Returns the rows of an image, followed by those of its caption.
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
  const OffscreenRenderer* renderer = drawn->renderer.get();
  OffscreenGui gui(look_for(size, kPrintHeight));
  if (!figure.rulers.empty())
    gui.draw(renderer->framebuffer(), [&] { draw_rulers(figure.rulers, renderer->view()); });
  return write_png(with_caption(renderer->framebuffer(), figure.caption, strip_height(size), gui), png);
}

// The recent history that the HUD and the effects of a match show.
struct MatchScreen {
  MatchPicture picture;
  GameCamera camera;
  HudState hud;

  void follow(const Match& match, const Controls& controls, bool first) {
    if (first) {
      picture.show(match);
    } else {
      picture.follow(match);
    }
    hud.on_tick(match);
    hud.advance(kTick);
    picture.advance(match, kTick);
    camera.follow(match, aim_of(controls), kTick);
  }
};

// Draws a moment of a recorded match as its player saw it, with the HUD. An OpenGL context must be current.
//
// Replays the match up to the tick by the current rules: if these changed since the recording, the figure
// shows a different fight. Fails if the recording or its rules cannot be read, or if the recording is too
// short.
Status draw_match_figure(const std::filesystem::path& file, Ticks tick, const gl::Framebuffer& picture,
                         OffscreenGui& gui) {
  const auto recording = read_recording(file);
  if (!recording) return recording.error();
  if (tick == 0 || recording->controls.size() < tick)
    return bad_input(file.string() + ": the match has " + std::to_string(recording->controls.size()) +
                     " ticks, and the figure needs tick " + std::to_string(tick));
  auto rules = load_rules(recording->rules, nullptr, recording->player);
  if (!rules) return rules.error();
  auto drawn = MatchPicture::create();
  if (!drawn) return drawn.error();
  MatchScreen screen{std::move(*drawn), {}, {}};
  Match match({*rules, recording->seed, recording->difficulty});
  const Ticks begins = tick - std::min(tick, kRemembered);
  for (Ticks t = 0; t < tick; ++t) {
    match.tick(recording->controls[t]);
    if (t >= begins) screen.follow(match, recording->controls[t], t == begins);
  }
  const Controls& last = recording->controls[tick - 1];
  const gl::Framebuffer::Shape& shape = picture.shape();
  const CameraView view =
      screen.camera.view(static_cast<double>(shape.width) / shape.height, kMatchFieldOfView);
  screen.picture.draw(match, view, {picture.name(), 0, 0, shape.width, shape.height}, PicturePreset::kHigh);
  const double width = static_cast<double>(last.width) / Controls::kFull;
  const Sight sight(match.world());
  const auto sighted = sighted_part(match, sight, aim_of(last));
  gui.draw(picture, [&] {
    draw_hud({match, screen.hud, view, sight, aim_of(last), width, false, "", sighted});
  });
  return Done{};
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
