#include "ui/render/renderer.h"

#include <cmath>

namespace kerf {

namespace {

constexpr int kSamples = 4;
// A face that was halved less often than this since its base face is never white-hot, however fine it is
// among others.
constexpr uint32_t kLeastWhiteHot = 6;
constexpr uint32_t kLeastSmall = 4;

// Which of the four programs of bodies.
constexpr size_t kWire = 1, kSpot = 2;

}  // namespace

Result<Renderer::BodyPrograms> Renderer::load_bodies(const std::filesystem::path& shaders) {
  BodyPrograms programs;
  for (size_t i = 0; i < programs.size(); ++i) {
    gl::ProgramFiles files{{"frame.glsl", "body.vert"}, {"frame.glsl", "light.glsl", "body.frag"}};
    if (i & kWire) files.defines.emplace_back("WIRE");
    if (i & kSpot) files.defines.emplace_back("SPOT");
    auto program = gl::Program::load(shaders, files);
    if (!program) return program.error();
    program->bind_block("Frame", kFrameBlock);
    program->bind_block("Paints", kPaintBlock);
    programs[i] = std::move(*program);
  }
  return programs;
}

Result<Renderer> Renderer::create() {
  const std::filesystem::path shaders = std::filesystem::path(KERF_ASSETS) / "shaders";
  auto body = load_bodies(shaders);
  if (!body) return body.error();
  auto sky = gl::Program::load(shaders, {{"screen.vert"}, {"frame.glsl", "light.glsl", "sky.frag"}});
  if (!sky) return sky.error();
  auto ground = GroundPass::create(shaders);
  if (!ground) return ground.error();
  auto bloom = BloomPass::create(shaders);
  if (!bloom) return bloom.error();
  auto beam = BeamPass::create(shaders);
  if (!beam) return beam.error();
  auto lines = LineOverlay::create(shaders);
  if (!lines) return lines.error();
  return Renderer(std::move(*body), std::move(*sky), std::move(*ground), std::move(*bloom), std::move(*beam),
                  std::move(*lines));
}

Renderer::Renderer(BodyPrograms bodies, gl::Program sky, GroundPass ground, BloomPass bloom, BeamPass beam,
                   LineOverlay lines)
    : body_(std::move(bodies)),
      sky_(std::move(sky)),
      ground_(std::move(ground)),
      bloom_(std::move(bloom)),
      beam_(std::move(beam)),
      lines_(std::move(lines)) {
  sky_.bind_block("Frame", kFrameBlock);
}

void Renderer::show(const World& world, const std::map<std::string, Paint>& paints) {
  bodies_.clear();
  lines_.forget();
  contact_old_ = true;
  for (const BodyId id : world.ids()) bodies_.emplace(id, BodyPicture(world.body(id), paints));
  const World::Bounds bounds = world.bounds();
  const double diagonal = bounds.diagonal();
  space_.unit = diagonal > 0 && std::isfinite(diagonal) ? std::ldexp(1.0, std::ilogb(diagonal)) : 1;
  ground_.place_under(bounds);
}

void Renderer::follow(const Delta& delta) {
  for (const BodyDelta& d : delta.bodies) {
    const auto found = bodies_.find(d.body);
    if (found != bodies_.end()) found->second.faces().follow(d);
  }
  if (delta.empty()) return;
  contact_old_ = true;
  lines_.forget();
}

void Renderer::resend(const World& world) {
  for (auto& [id, picture] : bodies_) {
    if (world.contains(id)) picture.faces().forget_all(world.body(id).mesh);
  }
  contact_old_ = true;
  lines_.forget();
}

void Renderer::upload(const World& world) {
  for (auto& [id, picture] : bodies_) {
    if (world.contains(id)) uploaded_ += picture.faces().update(world.body(id).mesh);
  }
  find_white_hot();
}

// The median of the faces that are small at all: base faces differ in size, so the finest of some are halved
// far more often than the finest of others, and both should glow.
void Renderer::find_white_hot() {
  FaceBuffer::Halvings sum{};
  for (const auto& [id, picture] : bodies_) {
    for (size_t h = 0; h < sum.size(); ++h) sum[h] += picture.faces().halvings_of_faces()[h];
  }
  size_t small = 0;
  for (size_t h = kLeastSmall; h < sum.size(); ++h) small += sum[h];
  white_hot_ = small > 0 ? kLeastWhiteHot : 0;
  size_t below = 0;
  for (uint32_t h = kLeastSmall; h < sum.size() && 2 * (below += sum[h]) < small; ++h) {
    white_hot_ = std::max(kLeastWhiteHot, h + 1);
  }
}

void Renderer::set_up(const CameraView& view, const ViewOptions& options,
                      const std::optional<BeamPicture>& beam, const Target& target) {
  space_.eye = view.eye;
  FrameUniforms frame = uniforms_of(view, space_, target.width, target.height);
  ground_.fill_in(frame, space_);
  if (beam) BeamPass::fill_in(frame, space_, *beam);
  frame.heat = {white_hot_, options.level_colours && white_hot_ > 0 ? 1 : 0, options.show.pieces ? 1 : 0,
                options.show.wire ? 1 : 0};
  glBindBuffer(GL_UNIFORM_BUFFER, uniforms_.name());
  glBufferData(GL_UNIFORM_BUFFER, sizeof(frame), &frame, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBlock, uniforms_.name());
}

void Renderer::choose_canvas(const Target& target, bool antialias) {
  canvas_ = antialias ? 1 : 0;
  Canvas& canvas = canvases_[canvas_];
  const int w = target.width, h = target.height;
  if (canvas.drawn && canvas.drawn->shape().width == w && canvas.drawn->shape().height == h) return;
  canvas.drawn.emplace(gl::Framebuffer::Shape{w, h, antialias ? kSamples : 1, true});
  canvas.resolved.reset();
  if (canvas.drawn->shape().samples > 1) canvas.resolved.emplace(gl::Framebuffer::Shape{w, h, 1, false});
}

void Renderer::draw_bodies(const World& world, const gl::Program& program) const {
  for (const auto& [id, picture] : bodies_) {
    if (world.contains(id)) picture.draw(program, space_, world.body(id).placement);
  }
}

void Renderer::draw_scene(const World& world, const ViewOptions& options, bool spot) {
  canvases_[canvas_].drawn->bind();
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  const gl::Program& body = body_[(options.show.wire ? kWire : 0) + (spot ? kSpot : 0)];
  body.use();
  draw_bodies(world, body);
  ground_.draw(space_, spot, [&](const gl::Program& program) { draw_bodies(world, program); });
  glDepthFunc(GL_LEQUAL);
  sky_.use();
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::draw_overlays(const World& world, const CameraView& view, const ViewOptions& options,
                             const std::optional<BeamPicture>& beam) {
  for (const auto& [id, picture] : bodies_) {
    if (world.contains(id)) lines_.draw(id, world.body(id), picture.faces().frame(), space_, options.show);
  }
  if (beam) beam_.draw(view, space_, *beam, canvases_[canvas_].drawn->shape().height);
}

void Renderer::hand_over(const Target& target) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  const Canvas& canvas = canvases_[canvas_];
  if (!shining_) {
    gl::blit(*canvas.drawn, target.framebuffer, target.x, target.y);
  } else {
    if (canvas.resolved) gl::blit(*canvas.drawn, canvas.resolved->name(), 0, 0);
    bloom_.draw(canvas.resolved ? *canvas.resolved : *canvas.drawn, target.framebuffer, target.x, target.y);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
}

void Renderer::draw(const World& world, const CameraView& view, const ViewOptions& options,
                    const std::optional<BeamPicture>& beam, const Target& target) {
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_STENCIL_TEST);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  upload(world);
  choose_canvas(target, options.antialias);
  set_up(view, options, beam, target);
  if (contact_old_) {
    ground_.update_contact(space_, [&](const gl::Program& program) { draw_bodies(world, program); });
    contact_old_ = false;
  }
  draw_scene(world, options, beam && beam->strike);
  draw_overlays(world, view, options, beam);
  shining_ = beam || (options.level_colours && white_hot_ > 0);
  hand_over(target);
}

bool Renderer::draw_again(const Target& target) {
  const auto& drawn = canvases_[canvas_].drawn;
  if (!drawn || drawn->shape().width != target.width || drawn->shape().height != target.height) return false;
  hand_over(target);
  return true;
}

}  // namespace kerf
