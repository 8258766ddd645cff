#include "ui/figures/draw_figure.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/ids.h"
#include "core/document/cut_effects.h"
#include "core/document/journal.h"
#include "core/document/replay.h"
#include "core/game/match/recording.h"
#include "core/mesh/build_mesh.h"
#include "core/mesh/measures.h"
#include "core/mesh/refinement.h"
#include "ui/game/game_camera.h"
#include "ui/game/hud.h"
#include "ui/game/match_picture.h"
#include "ui/gl/context.h"
#include "ui/gl/image.h"
#include "ui/render/picture.h"
#include "ui/window/gui.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr double kSqrt3 = 1.7320508075688772;
constexpr size_t kSplits = 2;

constexpr ImU32 kBackground = IM_COL32(0xf4, 0xf5, 0xf7, 255), kStroke = IM_COL32(0x1b, 0x1f, 0x26, 255);
constexpr ImU32 kFace = IM_COL32(0xb9, 0xc9, 0xda, 255), kHit = IM_COL32(0xff, 0x9d, 0x2e, 255);
constexpr ImU32 kLine = IM_COL32(0x33, 0x41, 0x55, 255), kBeam = IM_COL32(0xd4, 0x2a, 0x1c, 255);

// A mesh of one triangle, split by the scheme.
class SplitTriangle {
 public:
  SplitTriangle() {
    Soup soup;
    for (const Vec2& corner : diagram_triangle()) soup.positions.emplace_back(corner.x, corner.y, 0);
    soup.triangles = {{0, 1, 2}};
    mesh_ = std::move(build_mesh(soup)->mesh);
  }

  // Returns the current elements and marks those that the beam intersects.
  std::vector<DiagramTriangle> triangles(const Vec2& beam, double radius) const {
    std::vector<DiagramTriangle> all;
    for (const FaceId f : elements()) all.push_back(drawn(f, beam, radius));
    return all;
  }

  void split_hit(const Vec2& beam, double radius) {
    std::vector<FaceId> hit;
    for (const FaceId f : elements()) {
      if (meets(scheme_.triangle(mesh_, f), beam, radius)) hit.push_back(f);
    }
    std::vector<Replacement> replacements;
    for (const FaceId f : hit) scheme_.split(mesh_, f, replacements);
  }

 private:
  static bool meets(const Triangle& t, const Vec2& beam, double radius) {
    return squared_distance({beam.x, beam.y, 0}, t) <= radius * radius;
  }

  // Returns one face of each element, by slot.
  std::vector<FaceId> elements() const {
    std::vector<FaceId> all;
    for (uint32_t i = 0; i < mesh_.face_slots(); ++i) {
      const FaceId f(i);
      if (!mesh_.is_live(f)) continue;
      const OneToFour::Element element = scheme_.element(mesh_, f);
      if (element.face_count == 1 || f == std::min(element.faces[0], element.faces[1])) all.push_back(f);
    }
    return all;
  }

  DiagramTriangle drawn(FaceId f, const Vec2& beam, double radius) const {
    const Triangle whole = scheme_.triangle(mesh_, f), face = mesh_.triangle(f);
    DiagramTriangle out;
    for (size_t i = 0; i < 3; ++i) out.corners[i] = Vec2(whole[i]);
    out.hit = meets(whole, beam, radius);
    for (const Vec3& p : face) {
      if (std::find(whole.begin(), whole.end(), p) == whole.end()) out.bisected = Vec2(p);
    }
    if (!out.bisected) return out;
    const auto off_middle = [&](size_t i) {
      return glm::length(0.5 * (out.corners[(i + 1) % 3] + out.corners[(i + 2) % 3]) - *out.bisected);
    };
    for (size_t i = 1; i < 3; ++i) {
      if (off_middle(i) < off_middle(out.corner)) out.corner = i;
    }
    return out;
  }

  Mesh mesh_;
  OneToFour scheme_;
};

// A panel of the diagram: the centre of its triangle in the image, and pixels per unit.
struct Panel {
  ImVec2 centre;
  float scale;
  ImVec2 at(const Vec2& p) const {
    return {centre.x + scale * static_cast<float>(p.x), centre.y - scale * static_cast<float>(p.y)};
  }
};

void draw_dashed(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 colour, float width) {
  const float dash = 0.35f * ImGui::GetFontSize();
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  for (float s = 0; s < length; s += 2 * dash) {
    const float e = std::min(s + dash, length);
    list.AddLine({from.x + (to.x - from.x) * s / length, from.y + (to.y - from.y) * s / length},
                 {from.x + (to.x - from.x) * e / length, from.y + (to.y - from.y) * e / length}, colour,
                 width);
  }
}

void draw_triangle(ImDrawList& list, const Panel& panel, const DiagramTriangle& t, float width) {
  const ImVec2 a = panel.at(t.corners[0]), b = panel.at(t.corners[1]), c = panel.at(t.corners[2]);
  if (t.removed) {
    for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}})
      draw_dashed(list, from, to, kBeam, width);
    return;
  }
  list.AddTriangleFilled(a, b, c, t.hit ? kHit : kFace);
  list.AddTriangle(a, b, c, kLine, width);
  if (t.bisected)
    draw_dashed(list, panel.at(t.corners[t.corner]), panel.at(*t.bisected), kLine, 0.6f * width);
}

void draw_panel(ImDrawList& list, const Panel& panel, const std::vector<DiagramTriangle>& stage,
                const Vec2& beam, double radius, const char* label) {
  const float width = std::max(1.5f, 0.11f * ImGui::GetFontSize());
  for (const bool removed : {true, false}) {
    for (const DiagramTriangle& t : stage) {
      if (t.removed == removed) draw_triangle(list, panel, t, width);
    }
  }
  list.AddCircle(panel.at(beam), panel.scale * static_cast<float>(radius), kBeam, 48, 1.6f * width);
  const ImVec2 size = ImGui::CalcTextSize(label);
  list.AddText({panel.centre.x - 0.5f * size.x, panel.centre.y + 0.72f * panel.scale}, kStroke, label);
}

void draw_arrow(ImDrawList& list, ImVec2 at) {
  const float em = ImGui::GetFontSize();
  list.AddLine({at.x - em, at.y}, {at.x + 0.6f * em, at.y}, kStroke, 0.14f * em);
  list.AddTriangleFilled({at.x + em, at.y}, {at.x + 0.4f * em, at.y - 0.4f * em},
                         {at.x + 0.4f * em, at.y + 0.4f * em}, kStroke);
}

constexpr double kFilmFieldOfView = 45;  // degrees

// Returns the best moment of a match; nullopt if `progress` stopped the search.
std::optional<MatchMoment> best_moment(const MatchSetup& setup, const std::vector<Controls>& controls,
                                       const Progress& progress) {
  ScoreLog log;
  Match match(setup);
  for (const Controls& c : controls) {
    if (!progress.report(0)) return std::nullopt;
    match.tick(c);
    log.on_tick(match);
  }
  return log.best();
}

constexpr double kTraversal = 6, kAfterTraversal = 1.5;  // s
constexpr double kTurnOfLight = 8;                       // s

// Films a static world. Calls `draw` with the elapsed fraction of the film, 0 to 1.
Status film_still(const FilmFormat& format, double seconds, const Progress& progress,
                  const OffscreenRenderer& renderer, const std::function<void(double)>& draw) {
  KERF_ASSERT(format.frames_per_second > 0);
  const auto frames = static_cast<size_t>(std::lround(seconds * format.frames_per_second));
  for (size_t i = 0; i < frames; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(frames);
    if (!progress.report(share)) return cancelled();
    draw(share);
    if (const Status written = renderer.write(frame_file(format.folder, i)); !written) return written;
  }
  return remove_later_frames(format.folder, frames);
}

Result<RenderedImage> draw_first(const std::filesystem::path& file, const FilmFormat& format) {
  auto work = open_file(file);
  if (!work) return work.error();
  const auto options = options_for(file, work->scene, format.width, format.height);
  if (!options) return options.error();
  return draw_picture(std::move(*work), *options);
}

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
  auto rules = load_rules(recording->rules, nullptr, recording->player, recording->arena);
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
    HudView hud{match, screen.hud, view, sight, aim_of(last), width};
    hud.sighted = sighted;
    draw_hud(hud);
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

std::array<Vec2, 3> diagram_triangle() {
  return {Vec2(-1, -kSqrt3 / 3), {1, -kSqrt3 / 3}, {0, 2 * kSqrt3 / 3}};
}

std::vector<std::vector<DiagramTriangle>> split_stages(const Vec2& beam, double radius) {
  SplitTriangle triangle;
  std::vector<std::vector<DiagramTriangle>> stages{triangle.triangles(beam, radius)};
  for (size_t i = 0; i < kSplits; ++i) {
    triangle.split_hit(beam, radius);
    stages.push_back(triangle.triangles(beam, radius));
  }
  stages.push_back(stages.back());
  for (DiagramTriangle& t : stages.back()) t.removed = t.hit;
  return stages;
}

void draw_split_diagram() {
  static constexpr std::array kLabels{"The beam meets a triangle", "It is split into four",
                                      "What is hit is split again", "What is hit is removed"};
  const Vec2 beam(0.52, -0.33);
  const double radius = 0.13;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  list.AddRectFilled({0, 0}, size, kBackground);
  const auto stages = split_stages(beam, radius);
  KERF_ASSERT(stages.size() == kLabels.size());
  const auto count = static_cast<float>(stages.size());
  const float scale = std::min(0.42f * size.x / count, 0.42f * size.y);
  for (size_t i = 0; i < stages.size(); ++i) {
    const float x = size.x * (static_cast<float>(i) + 0.5f) / count;
    draw_panel(list, {{x, 0.53f * size.y}, scale}, stages[i], beam, radius, kLabels[i]);
    if (i > 0) draw_arrow(list, {size.x * static_cast<float>(i) / count, 0.42f * size.y});
  }
}

Status film_cut(const std::filesystem::path& journal, const FilmFormat& format, const Progress& progress) {
  auto work = open_journal(journal);
  if (!work) return work.error();
  const auto options = options_for(journal, work->scene, format.width, format.height);
  if (!options) return options.error();
  auto film = Film::begin(work->scene, {*options, format.frames_per_second, format.folder}, work->journal);
  if (!film) return film.error();
  Document document = document_of(std::move(work->scene.world), work->scene);
  Replay replay(work->journal, document);
  QueueRun how;
  how.moves_a_step = 1;
  how.progress = &progress;
  how.told = [&](const Result<StepResult>& step) { return film->follow(document, step ? &*step : nullptr); };
  if (const Status run = replay.run(how); !run) return run;
  return film->end(document);
}

Status film_fight(const std::filesystem::path& file, const FilmFormat& format, const Progress& progress) {
  const auto recording = read_recording(file);
  if (!recording) return recording.error();
  auto rules = load_rules(recording->rules, nullptr, recording->player, recording->arena);
  if (!rules) return rules.error();
  if (recording->controls.empty()) return bad_input(file.string() + ": the match has no ticks to film");
  const MatchSetup setup{*rules, recording->seed, recording->difficulty};
  const auto moment = best_moment(setup, recording->controls, progress);
  if (!moment) return cancelled();
  KERF_ASSERT(moment->from <= moment->to && moment->to <= recording->controls.size());
  auto frames = MatchFrames::open(format.folder, format.width, format.height);
  if (!frames) return frames.error();
  const auto match = match_at(setup, moment->start, recording->controls, moment->from);
  ReplayCamera camera(moment->vehicle, 0);
  frames->picture.show(*match);
  const Ticks ticks = moment->to - moment->from;
  for (Ticks t = 0; t < ticks; ++t) {
    if (!progress.report(static_cast<double>(t) / static_cast<double>(ticks))) return cancelled();
    match->tick(recording->controls[moment->from + t]);
    frames->picture.follow(*match);
    frames->picture.advance(*match, kTick);
    camera.follow(*match, kTick);
    if (static_cast<double>(frames->taken) > seconds_of_ticks(t) * format.frames_per_second) continue;
    const CameraView view = camera.view(frames->aspect(), kFilmFieldOfView);
    if (const Status taken = frames->take(*match, view); !taken) return taken;
  }
  return frames->end();
}

Status film_graph(const std::filesystem::path& work, const FilmFormat& format, const Progress& progress) {
  const auto picture = draw_first(work, format);
  if (!picture) return picture.error();
  const auto whole = graph_around_last_cut(*picture->document);
  if (!whole) return bad_input(work.string() + ": all faces were removed, so there is no graph to film");
  OffscreenRenderer& renderer = *picture->renderer;
  return film_still(format, kTraversal + kAfterTraversal, progress, renderer, [&](double share) {
    const double done = std::min(1.0, share * (kTraversal + kAfterTraversal) / kTraversal);
    auto drawn = std::make_shared<DrawnGraph>(*whole);
    drawn->marked = static_cast<size_t>(std::lround(done * static_cast<double>(whole->reached)));
    renderer.look().graph = std::move(drawn);
    renderer.draw(picture->document->world(), std::nullopt);
  });
}

Status film_shadow(const std::filesystem::path& scene, const FilmFormat& format, const Progress& progress) {
  const auto picture = draw_first(scene, format);
  if (!picture) return picture.error();
  OffscreenRenderer& renderer = *picture->renderer;
  KERF_ASSERT(!renderer.look().lights.empty());
  const Vec3 first = renderer.look().lights[0].at;
  return film_still(format, kTurnOfLight, progress, renderer, [&](double share) {
    renderer.look().lights[0].at = axis_angle({0, 1, 0}, share * 2 * kPi) * first;
    renderer.draw(picture->document->world(), std::nullopt);
  });
}

Status draw_figure(const Figure& figure, const FigureSize& size, const std::filesystem::path& png) {
  KERF_ASSERT(std::min(size.width, size.height) >= 64);
  KERF_ASSERT((!figure.scene.empty() + !figure.match.empty() + !figure.diagram.empty()) == 1);
  return figure.scene.empty() ? draw_without_scene(figure, size, png) : draw_scene(figure, size, png);
}

}  // namespace kerf
