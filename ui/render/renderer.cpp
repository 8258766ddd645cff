#include "ui/render/renderer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/geometry.h"
#include "core/heat/black_body.h"
#include "core/mesh/looks.h"
#include "ui/gl/buffers.h"
#include "ui/gl/context.h"
#include "ui/gl/program.h"
#include "ui/render/passes/heat_colours.h"

namespace kerf {

namespace {

constexpr int kSamples = 4;
constexpr double kGlowWidth = 1.0 / 220;  // of the diagonal of the world as loaded

// Shifts a projection by the shift of the target.
glm::mat4 shifted(const glm::mat4& clip_from_frame, const Target& target) {
  glm::mat4 shift(1);
  shift[3].x = 2 * target.shift.x / static_cast<float>(target.width);
  shift[3].y = 2 * target.shift.y / static_cast<float>(target.height);
  return shift * clip_from_frame;
}

constexpr int64_t kSurelyHeld = 4096 * 4096;  // pixels

// Returns true if OpenGL has memory for the largest framebuffers of a frame: the canvas and its resolved copy
// (see Renderer::select_canvas), and the light in linear colours (see LitScene).
bool holds_canvases(int width, int height, bool antialias) {
  using gl::Framebuffer;
  const Framebuffer drawn({width, height, antialias ? kSamples : 1, true});
  if (!drawn.complete()) return false;
  const Framebuffer linear({width, height, 1, false, GL_RGBA16F}, drawn);
  return linear.complete() && (!antialias || Framebuffer({width, height, 1, false}).complete());
}

}  // namespace

Result<bool> affordable_antialias(int width, int height, bool wanted) {
  if (int64_t{width} * height <= kSurelyHeld) return wanted;
  gl::ignore_gl_errors();  // such as a lack of memory
  const bool as_wanted = holds_canvases(width, height, wanted);
  const bool at_all = as_wanted || (wanted && holds_canvases(width, height, false));
  gl::report_gl_errors();
  if (!at_all) return failed("OpenGL has no memory for an image of this size; use a smaller one");
  return wanted && as_wanted;
}

Renderer::Renderer(Shaders& shaders)
    : passes_{LitScene(shaders),    BloomPass(shaders),     BeamPass(shaders),      EffectsPass(shaders),
              LineOverlay(shaders), VeilPass(shaders),      OutlinePass(shaders),   FaceNumbers(shaders),
              ShadowProbe(shaders), ShadowOverlay(shaders), ReferencePass(shaders), GraphPass(shaders),
              StagePass(shaders),   SectionPass(shaders),   BodyPass(shaders),      WirePass(shaders)} {}

Result<Renderer> Renderer::create() {
  Shaders shaders;
  Renderer renderer(shaders);
  if (!shaders.status()) return shaders.status().error();
  return renderer;
}

void Renderer::send_faces(const World& world) {
  for (auto& [id, picture] : bodies_) {
    if (!world.contains(id)) continue;
    if (picture.faces().is_sending()) contact_old_ = true;
    uploaded_ += picture.faces().update(world.body(id), max_faces_sent_);
  }
}

void Renderer::catch_up(const World& world) {
  send_faces(world);
  for (const auto& textures : textures_) textures->update(max_faces_sent_ == DirtySlots::kAll);
  find_finest();
  follow_heat(world);
}

void Renderer::follow_heat(const World& world) {
  const HeatMoment now{world.clock(), world.energy()};
  const bool passed = heat_of_ != now;
  heat_of_ = now;
  for (auto& [id, picture] : bodies_) {
    if (world.contains(id)) uploaded_ += picture.faces().update_heat(world.body(id), passed);
  }
}

double Renderer::warmest() const {
  double warmest = kAmbient;
  for (const auto& [id, picture] : bodies_) warmest = std::max(warmest, picture.faces().heat().warmest());
  return warmest;
}

bool Renderer::is_sending() const {
  return std::any_of(bodies_.begin(), bodies_.end(),
                     [](const auto& entry) { return entry.second.faces().is_sending(); });
}

bool Renderer::is_loading_images() const {
  return std::ranges::any_of(textures_, [](const auto& textures) { return textures->is_loading(); });
}

double Renderer::sent_share() const {
  size_t all = 0, unsent = 0;
  for (const auto& [id, picture] : bodies_) {
    all += picture.faces().slots();
    unsent += picture.faces().unsent();
  }
  return all > 0 ? 1 - static_cast<double>(unsent) / static_cast<double>(all) : 1;
}

PictureMemory Renderer::memory() const {
  PictureMemory memory = passes_.scene.shadows().memory();
  for (const auto& textures : textures_) memory.graphics += textures->bytes();
  for (const auto& [id, picture] : bodies_) memory += picture.faces().memory();
  return memory;
}

void Renderer::find_finest() {
  finest_ = 0;
  for (const auto& [id, picture] : bodies_) {
    const FaceBuffer::Halvings& faces = picture.faces().halvings_of_faces();
    for (uint32_t h = finest_ + 1; h < faces.size(); ++h) {
      if (faces[h] > 0) finest_ = h;
    }
  }
}

// Returns true if any surface looks different because of a rim, current or past heat, or a number.
bool Renderer::has_rims(const ViewOptions& options) const {
  if (options.show.heat || options.scalar) return true;
  return options.rim_glow && !options.show.sizes &&
         std::any_of(bodies_.begin(), bodies_.end(), [](const auto& body) {
           return body.second.faces().has_rim() || body.second.faces().heat().any();
         });
}

// Returns true if anything on a body glows, so that the frame needs bloom.
bool Renderer::glows(const ViewOptions& options) const {
  return !options.show.heat && !options.scalar && has_rims(options) &&
         std::any_of(bodies_.begin(), bodies_.end(), [](const auto& body) {
           const FaceBuffer& faces = body.second.faces();
           return faces.heat().any() ? faces.heat().warmest() > kGlowFrom : faces.has_rim();
         });
}

void Renderer::update_looks(const World& world, const ViewOptions& options) {
  for (auto& [id, picture] : bodies_) {
    if (!world.contains(id)) continue;
    const Body& body = world.body(id);
    const BodyLooks looks(id, body, options);
    if (picture.looks().update(body, looks, space_)) contact_old_ = true;
    picture.faces().group(body.mesh, looks.groups());
  }
}

// Returns the bases of a body that are smooth everywhere; those by angle if its loaded shading is unknown.
std::shared_ptr<const BaseFaces> Renderer::smooth_bases(const Body& body) {
  const auto loaded = loaded_.find(body.loaded_as);
  if (loaded == loaded_.end()) return nullptr;
  std::shared_ptr<const BaseFaces>& smooth = smooth_[body.loaded_as];
  if (!smooth) smooth = std::make_shared<const BaseFaces>(loaded->second.bases->smoothed());
  if (body.loaded_faces.empty()) return smooth;
  return std::make_shared<const BaseFaces>(smooth->pick(body.loaded_faces));
}

void Renderer::update_shading(const World& world, const ViewOptions& options) {
  const bool smooth = options.shading == Shading::kSmooth;
  if (!smooth) smooth_.clear();
  for (auto& [id, picture] : bodies_) {
    if (!world.contains(id) || picture.faces().is_smooth() == smooth) continue;
    const Body& body = world.body(id);
    picture.faces().shade(body.mesh, smooth ? smooth_bases(body) : nullptr);
  }
}

// Bodies missing in the field have no numbers.
void Renderer::update_scalars(const ViewOptions& options) {
  static const auto kNone = std::make_shared<const FaceScalars>();
  for (auto& [id, picture] : bodies_) {
    std::shared_ptr<const FaceScalars> scalars;
    if (options.scalar) {
      const auto found = options.scalar->of_bodies.find(id);
      scalars = found != options.scalar->of_bodies.end() ? found->second : kNone;
    }
    uploaded_ += picture.faces().update_scalars(scalars);
  }
}

// The looks of pieces are in the frame of the eye, and are therefore updated after it.
void Renderer::look_from(const World& world, const CameraView& view) {
  space_.eye = view.near().eye;
  space_.seen_from = view.eye;
  if (space_.up == view.up_axis) return;
  space_.up = view.up_axis;
  place_ground(world);
  contact_old_ = true;
}

double Renderer::near_of(const World& world, const CameraView& view, const ViewOptions& options) {
  World::Bounds drawn = world.bounds();
  const Vec3 middle = 0.5 * (drawn.min + drawn.max);
  double moved = 0;
  for (const auto& [key, look] : options.pieces) {
    const double turned = look.is_turned() ? drawn.diagonal() : 0;
    moved = std::max(moved, glm::length(look.turn * middle + look.offset - middle) + turned);
  }
  drawn.min -= moved;
  drawn.max += moved;
  return near_plane(view, drawn, passes_.scene.ground().height());
}

void Renderer::set_up(const World& world, const CameraView& view, const ViewOptions& options,
                      const std::optional<BeamPicture>& beam, const Target& target) {
  near_ = near_of(world, view, options);
  FrameUniforms& frame = frame_ = uniforms_of(view, near_, space_, target.width, target.height);
  frame.clip_from_frame = shifted(frame.clip_from_frame, target);
  passes_.scene.ground().fill_in(frame, space_);
  const Light key = options.lights.empty() ? Light{} : options.lights.front();
  frame.key_light = glm::vec4(glm::vec3(space_.turned(direction_to(key, middle_))), 0);
  if (beam) BeamPass::fill_in(frame, space_, *beam);
  const bool below = height_of(space_.seen_from, space_.up) <= passes_.scene.ground().height();
  frame.stage = below ? stage_colours_from_below(options.by_day) : stage_colours(options.by_day);
  if (const SectionPlane* section = shown_section(options)) {
    const Vec3 normal = space_.turned(section->normal);
    KERF_ASSERT(is_unit(normal));
    frame.section = -glm::vec4(glm::vec3(normal), space_.length(section->height_of(space_.eye)));
  }
  const int colours = options.show.sizes ? 2 : options.show.pieces ? 1 : options.tint_pieces ? 0 : -1;
  frame.body_look = {finest_, colours, options.two_sided ? 1 : 0,
                     options.show.heat ? end_of_heat_scale(world) : 0};
  if (options.scalar) {
    KERF_ASSERT(options.scalar->low < options.scalar->high);
    const float scale = options.scalar->scale == ColourScale::kDiverging ? 2 : 1;
    frame.face_view = {options.scalar->low, options.scalar->high, scale, 0};
  }
  frame.face_view.w = options.shading == Shading::kFlat ? 1 : 0;
  gl::fill_buffer(GL_UNIFORM_BUFFER, uniforms_, sizeof(frame), &frame, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBlock, uniforms_.name());
}

void Renderer::select_canvas(const Target& target, bool antialias) {
  canvas_ = antialias ? 1 : 0;
  Canvas& canvas = canvases_[canvas_];
  const int w = target.width, h = target.height;
  if (canvas.drawn && canvas.drawn->shape().width == w && canvas.drawn->shape().height == h) return;
  canvas.drawn.emplace(gl::Framebuffer::Shape{w, h, antialias ? kSamples : 1, true});
  canvas.resolved.reset();
  if (canvas.drawn->shape().samples > 1) canvas.resolved.emplace(gl::Framebuffer::Shape{w, h, 1, false});
}

void Renderer::draw_overlays(const Subject& subject, const CameraView& view,
                             const std::optional<BeamPicture>& beam) {
  const ViewOptions& options = subject.options;
  const gl::Framebuffer& picture = *canvases_[canvas_].drawn;
  passes_.shadow_overlay.draw(subject, passes_.scene.shadows(), passes_.numbers, picture);
  picture.bind();
  passes_.section.draw(subject, picture.shape().height);
  if (options.show.face_numbers) passes_.veil.draw(subject, VeilPass::Style::kRed);
  for_each_body(subject, [&](BodyId id, const Body& body, const BodyPicture& p) {
    if (!body.hidden) passes_.lines.draw(id, body, p, space_, frame_.clip_from_frame, options);
  });
  draw_beams(view, options, beam);
  if (options.ghost && !options.show.face_numbers) passes_.veil.draw(subject, VeilPass::Style::kVeil);
  passes_.outline.draw(subject, picture);
  passes_.graph.draw(subject, frame_);
  passes_.wire.draw(subject, frame_);
  passes_.stage.draw(subject);
  passes_.bodies.draw(subject, subject.world.loaded_bounds().diagonal());
  if (options.show.face_numbers) passes_.numbers.draw(subject, frame_, picture);
  if (options.show.heat && options.legends)
    draw_heat_bar(end_of_heat_scale(subject.world), passes_.numbers, picture.shape().height);
  if (options.show.shadow_compare) draw_comparison(subject, picture);
}

void Renderer::draw_beams(const CameraView& view, const ViewOptions& options,
                          const std::optional<BeamPicture>& beam) {
  const gl::Framebuffer::Shape& shape = canvases_[canvas_].drawn->shape();
  const auto draw = [&](const BeamPicture& b) {
    passes_.beam.draw(view, b, space_, near_, shape.width, shape.height);
  };
  if (options.effects) {
    passes_.effects.draw(*options.effects, space_);
    for (const BeamPicture& other : options.effects->beams)
      draw(ended_on_ground(other, passes_.scene.ground().height(), view.up_axis));
  }
  if (beam) draw(*beam);
}

// A line between the two methods, and next to it, as a legend, the number of differing pixels.
void Renderer::draw_comparison(const Subject& subject, const gl::Framebuffer& picture) {
  const ShadowOptions& shadow = subject.options.shadow;
  const size_t lights = std::min(subject.options.lights.size(), kMaxLights);
  differing_ = 0;
  if (lights == 0) return;
  const int w = picture.shape().width, h = picture.shape().height;
  const auto counted = [&](ShadowMethod method) {
    return passes_.probe.look(subject, passes_.scene.shadows(), std::min(shadow.inspected, lights - 1),
                              method, &passes_.scene.ground(), w, h);
  };
  const ShadowCounts one = counted(shadow.method);
  differing_ = kerf::differing_pixels(one, counted(shadow.beside));
  picture.bind();
  const int zoom = 1 + h / 1000, split = static_cast<int>(std::clamp(shadow.split, 0.0, 1.0) * w);
  gl::fill(split - 2 * zoom, 0, 4 * zoom, h, {0.03f, 0.035f, 0.04f, 0});
  gl::fill(split - zoom, 0, 2 * zoom, h, {0.90f, 0.92f, 0.94f, 0});
  if (!subject.options.legends) return;
  passes_.numbers.draw_labels(
      {{static_cast<uint32_t>(differing_), false, glm::vec2(split + 8 * zoom, h - 20 * zoom), {}}}, 2 * zoom);
}

void Renderer::hand_over(const Target& target) {
  gl::reset_state();
  const Canvas& canvas = canvases_[canvas_];
  if (!shining_) {
    gl::blit(*canvas.drawn, target.framebuffer, target.x, target.y);
  } else {
    if (canvas.resolved) gl::blit(*canvas.drawn, canvas.resolved->name(), 0, 0);
    passes_.bloom.draw(canvas.resolved ? *canvas.resolved : *canvas.drawn, target.framebuffer, target.x,
                       target.y);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
}

ShadowCounts Renderer::shadow_counts(const World& world, const CameraView& view, const ViewOptions& options,
                                     size_t light, ShadowMethod method, bool ground, int width, int height) {
  gl::reset_state();
  look_from(world, view);
  update_looks(world, options);
  catch_up(world);
  set_up(world, view, options, std::nullopt, {0, 0, 0, width, height});
  LitScene& scene = passes_.scene;
  return passes_.probe.look({world, bodies_, space_, options}, scene.shadows(), light, method,
                            ground ? &scene.ground() : nullptr, width, height);
}

ShadowReference Renderer::shadow_reference(const World& world, const CameraView& view,
                                           const ViewOptions& options, size_t light, bool ground, int width,
                                           int height) {
  KERF_ASSERT(light < options.lights.size());
  const std::optional<double> floor = ground ? std::optional(passes_.scene.ground().height()) : std::nullopt;
  const SectionPlane* section = shown_section(options);
  return {rays_through({world, bodies_, space_, options}),
          view,
          near_of(world, view, options),
          section != nullptr ? std::optional(*section) : std::nullopt,
          options.lights[light],
          floor,
          width,
          height};
}

void Renderer::draw_reference(const ShadowReference& traced, const ShadowCounts& drawn,
                              const Target& target) const {
  KERF_ASSERT(target.width == traced.width() && target.height == traced.height());
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  glViewport(target.x, target.y, target.width, target.height);
  passes_.reference.draw(traced, drawn);
}

void Renderer::draw_traced(const World& world, const CameraView& view, const ViewOptions& options,
                           const Target& target) {
  const size_t light = options.shadow.inspected;
  if (light >= options.lights.size()) return;
  ShadowReference traced = shadow_reference(world, view, options, light, true, target.width, target.height);
  traced.trace(static_cast<size_t>(target.width) * static_cast<size_t>(target.height));
  const ShadowCounts drawn =
      shadow_counts(world, view, options, light, options.shadow.method, true, target.width, target.height);
  draw_reference(traced, drawn, target);
}

void Renderer::draw(const World& world, const CameraView& view, const ViewOptions& options,
                    std::optional<BeamPicture> beam, const Target& target) {
  gl::reset_state();
  look_from(world, view);
  update_looks(world, options);
  update_shading(world, options);
  catch_up(world);
  update_scalars(options);
  select_canvas(target, options.antialias);
  if (beam) beam = ended_on_ground(*beam, passes_.scene.ground().height(), view.up_axis);
  set_up(world, view, options, beam, target);
  const Subject subject{world, bodies_, space_, options};
  if (std::exchange(contact_old_, false))
    passes_.scene.ground().update_contact(space_,
                                          [&](const gl::Program& program) { draw_bodies(subject, program); });
  const bool spot = beam && (beam->strike || beam->on_ground);
  passes_.scene.draw(subject, {.spot = spot, .rims = has_rims(options)}, *canvases_[canvas_].drawn);
  draw_overlays(subject, view, beam);
  shining_ = beam || options.effects || glows(options);
  hand_over(target);
}

bool Renderer::draw_again(const Target& target) {
  const auto& drawn = canvases_[canvas_].drawn;
  if (!drawn || drawn->shape().width != target.width || drawn->shape().height != target.height) return false;
  hand_over(target);
  return true;
}

void Renderer::show(const World& world, const std::map<std::string, Paint>& paints, PreparedBodies prepared) {
  bodies_.clear();
  heat_of_.reset();
  paints_ = paints;
  passes_.lines.forget();
  passes_.scene.shadows().forget();
  contact_old_ = true;
  const World::Bounds bounds = world.loaded_bounds();
  const double diagonal = bounds.diagonal();
  glow_width_ = kGlowWidth * diagonal;
  loaded_.clear();
  smooth_.clear();
  textures_.clear();
  for (const auto& [id, body] : prepared) loaded_.emplace(id, LoadedShading{body.frame, body.bases});
  for (const BodyId id : world.ids()) {
    PreparedBody ahead = prepare_shading(world.body(id), loaded_);
    ahead.caster = std::move(prepared[id].caster);
    prepared[id] = std::move(ahead);
    add(id, world.body(id), prepared);
  }
  middle_ = bounds.min + (bounds.max - bounds.min) * 0.5;
  space_.size = diagonal > 0 && std::isfinite(diagonal) ? diagonal : 1;
  space_.unit = std::ldexp(1.0, std::ilogb(space_.size));
  place_ground(world);
}

void Renderer::place_ground(const World& world) {
  passes_.scene.ground().place_under(world.loaded_bounds(), space_.up,
                                     height_of_drawn_ground(world, space_.up));
}

void Renderer::add(BodyId id, const Body& body, PreparedBodies& prepared) {
  KERF_ASSERT(!bodies_.contains(id));
  const auto found = prepared.find(id);
  PreparedBody ahead = found != prepared.end() ? std::move(found->second) : prepare_shading(body, loaded_);
  if (body.loaded_faces.empty()) loaded_.try_emplace(body.loaded_as, LoadedShading{ahead.frame, ahead.bases});
  if (ahead.caster) passes_.scene.shadows().adopt(id, std::move(ahead.caster));
  bodies_.emplace(id, BodyPicture(body, paints_, std::move(ahead), textures_of(body), glow_width_));
}

std::shared_ptr<const SurfaceTextures> Renderer::textures_of(const Body& body) {
  if (!body.looks || !body.looks->surfaces()) return nullptr;
  for (const auto& textures : textures_) {
    if (textures->library() == body.looks->surfaces()) return textures;
  }
  return textures_.emplace_back(std::make_shared<SurfaceTextures>(body.looks->surfaces()));
}

void Renderer::take_casters(PreparedBodies prepared) {
  for (auto& [id, body] : prepared) {
    KERF_ASSERT(bodies_.contains(id));
    if (body.caster) passes_.scene.shadows().adopt(id, std::move(body.caster));
  }
}

void Renderer::drop(BodyId id) {
  bodies_.erase(id);
  passes_.lines.forget(id);
  passes_.scene.shadows().forget(id);
}

void Renderer::rename_body(BodyId from, BodyId to) {
  const auto found = bodies_.find(from);
  if (found == bodies_.end()) return;  // the body was created later in the same delta
  bodies_.insert_or_assign(to, std::move(found->second));
  bodies_.erase(found);
  passes_.lines.forget(from);
  passes_.lines.forget(to);
  passes_.scene.shadows().rename_body(from, to);
}

// Detached pieces are no added meshes: they may have moved below the ground, which then stays.
bool Renderer::adds_mesh_below_ground(const World& world, const Delta& delta) {
  const auto is_loaded = [&](const BodyId id) { return world.body(id).loaded_as == id; };
  return delta.detached.empty() && std::ranges::any_of(delta.created, is_loaded) &&
         height_of_drawn_ground(world, space_.up) < passes_.scene.ground().height();
}

void Renderer::follow(const World& world, const Delta& delta, PreparedBodies prepared) {
  if (delta.replaced) return resend(world, std::move(prepared));
  if (delta.empty()) return;
  for (const BodyId id : delta.destroyed) drop(id);
  for (const Detached& d : delta.detached) {
    if (d.keeps_slots) rename_body(d.from, d.to);
  }
  for (const BodyId id : delta.created) add(id, world.body(id), prepared);
  for (const BodyDelta& d : delta.bodies) {
    const auto found = bodies_.find(d.body);
    if (found != bodies_.end()) found->second.faces().follow(d);
    passes_.lines.forget(d.body);
  }
  passes_.scene.shadows().follow(delta);
  if (delta.environment || adds_mesh_below_ground(world, delta)) place_ground(world);
  contact_old_ = true;
}

void Renderer::resend(const World& world, PreparedBodies prepared) {
  heat_of_.reset();
  bodies_.clear();
  passes_.lines.forget();
  passes_.scene.shadows().forget();
  for (const BodyId id : world.ids()) add(id, world.body(id), prepared);
  place_ground(world);
  contact_old_ = true;
}

}  // namespace kerf
