#include "ui/render/shadow_pass.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

#include "ui/render/bodies/face_slots.h"
#include "ui/render/view/colours.h"

namespace kerf {

LightOnBody light_on_body(const Light& light, const Placement& placement, const FloatFrame& frame,
                          const BodyLooks& looks) {
  const auto seen_from = [&](const PieceLook& look) -> LightPoint {
    const Vec3 at = light.kind == Light::Kind::kDirectional ? light.at : light.at - look.offset;
    const Vec3 before = look.is_turned() ? glm::conjugate(look.turn) * at : at;
    if (light.kind == Light::Kind::kDirectional) return {glm::conjugate(placement.orientation) * before, 0};
    return {frame.scaled(placement.to_body(before)), 1};
  };
  LightOnBody on{seen_from(PieceLook()), {}};
  for (const auto& [group, look] : looks.by_group()) {
    const bool sees_otherwise =
        look.is_turned() || (light.kind == Light::Kind::kPoint && look.offset != Vec3(0));
    if (!look.hidden && !sees_otherwise) continue;
    if (on.pieces.size() <= group) on.pieces.resize(group + 1, on.light);
    on.pieces[group] = look.hidden ? std::nullopt : std::optional(seen_from(look));
  }
  return on;
}

glm::vec4 light_in_frame(const Light& light, const FrameSpace& space) {
  KERF_ASSERT(light.kind != Light::Kind::kDirectional || light.at != Vec3(0));
  if (light.kind == Light::Kind::kDirectional) return {glm::vec3(glm::normalize(space.turned(light.at))), 0};
  return {space.from_world(light.at), 1};
}

glm::vec4 light_colour(const Light& light, const FrameSpace& space) {
  const float reference = space.length(space.size);
  return {glm::vec3(light.colour * light.intensity), reference * reference};
}

Vec3 direction_to(const Light& light, const Vec3& from) {
  const Vec3 way = light.kind == Light::Kind::kDirectional ? light.at : light.at - from;
  const double length = glm::length(way);
  return length > 0 ? way / length : Vec3(0, 1, 0);
}

using namespace overlay_colours;

namespace {

constexpr int kSignsUnit = 4;  // of the textures; programs with shadow_cap.vert use it for nothing else
constexpr int kCopies = 2;     // of a side that are drawn at once
constexpr uint32_t kGapOfItems = 16;  // clean items worth uploading to save a call
constexpr uint32_t kNoChunks = 0x80000000u;

gl::State counting(const gl::Stencil& stencil) {
  return {.writes_depth = false, .writes_colour = false, .writes_alpha = false, .stencil = stencil};
}

// Counts both sides of geometry behind the visible surface. `outward`: front faces look out of the volume.
gl::State counting_behind(bool outward) {
  if (outward) return counting({.front_behind = GL_DECR_WRAP, .back_behind = GL_INCR_WRAP});
  return counting({.front_behind = GL_INCR_WRAP, .back_behind = GL_DECR_WRAP});
}

// The minimum height of the unit vector towards a light for volumes that end at a floor: below it they get
// long.
constexpr float kMinRise = 0.1f;

std::optional<float> floor_for(const glm::vec4& light, std::optional<float> floor) {
  return light.w == 0 && light.y >= kMinRise ? floor : std::nullopt;
}

void set_floor(const gl::Program& program, std::optional<float> floor) {
  program.set("has_floor", floor ? 1 : 0);
  program.set("floor_height", floor.value_or(0));
}

std::vector<uint32_t> take_slots(DirtySlots& dirty) {
  std::vector<uint32_t> slots;
  for (const SlotRange range : dirty.take(0, FaceBuffer::kChunkFaces)) {
    for (uint32_t f = range.begin; f < range.end; ++f) slots.push_back(f);
  }
  return slots;
}

constexpr float kSheetReach = 0.9f;  // drawn length of sheets, in diagonals of the world

// The colours of edges with one, two and more sides.
std::array<glm::vec4, 3> silhouette_colours(float opacity) {
  return {srgb(kOneSide, 0.75f * opacity), srgb(kTwoSides, opacity), srgb(kMoreSides, opacity)};
}
std::array<glm::vec4, 3> all_of(const glm::vec4& colour) { return {colour, colour, colour}; }

constexpr float kCountOpacity = 0.78f;

// A row of colour fields, each with its number; `row` counts strips from below.
void draw_legend(std::span<const glm::vec4> colours, uint32_t first, int row, FaceNumbers& numbers,
                 int height) {
  const int zoom = 1 + height / 700, side = 22 * zoom, margin = 10 * zoom;
  const int y = margin + row * (side + margin);
  std::vector<FaceLabel> labels;
  gl::fill(margin - zoom, y - zoom, static_cast<int>(colours.size()) * side + 2 * zoom, side + 2 * zoom,
           srgb(0x0b0d10, 0));
  for (size_t i = 0; i < colours.size(); ++i) {
    const int x = margin + static_cast<int>(i) * side;
    gl::fill(x, y, side - zoom, side, glm::vec4(glm::vec3(colours[i]), 0));
    const glm::vec2 middle(x + side / 2 - 3 * zoom, y + side / 2 - 4 * zoom);
    labels.push_back({first + static_cast<uint32_t>(i), false, middle, {}});
  }
  numbers.draw_labels(labels, zoom);
}

}  // namespace

VolumeBuffer::Sides::Sides() {
  glBindVertexArray(layout.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  gl::read_floats(0, {3, GL_FLOAT, offsetof(Side, low)}, sizeof(Side));
  gl::read_floats(1, {3, GL_FLOAT, offsetof(Side, high)}, sizeof(Side));
  gl::read_whole(2, {1, GL_UNSIGNED_INT, offsetof(Side, piece)}, sizeof(Side));
  gl::read_whole(3, {1, GL_INT, offsetof(Side, multiplicity)}, sizeof(Side));
  for (const GLuint i : {0u, 1u, 2u, 3u}) glVertexAttribDivisor(i, 1);
  glBindVertexArray(0);
}

void VolumeBuffer::Sides::replace(const std::vector<Side>& all) {
  count = static_cast<GLsizei>(all.size());
  room = all.size() + all.size() / 2;
  gl::fill_buffer(GL_ARRAY_BUFFER, buffer, room * sizeof(Side));
  gl::put_items<Side>(GL_ARRAY_BUFFER, buffer, 0, all);
}

VolumeBuffer::Side VolumeBuffer::side(const ShadowCaster& caster, const SilhouetteEdge& edge) const {
  const ShadowCaster::Ends ends = caster.ends(edge.edge);
  return {ends.low, ends.high, packed_piece(ends.piece), edge.multiplicity};
}

size_t VolumeBuffer::bytes() const { return signs_room_ + (sides_.room + many_.room) * sizeof(Side); }

void VolumeBuffer::update(const ShadowCaster& caster) {
  KERF_ASSERT(volume_.signs().size() == caster.face_slots());
  const ShadowVolume::Touched touched = volume_.take_touched();
  if (!touched.all && touched.faces.empty() && touched.places.empty()) return;
  send_signs(touched);
  send_sides(caster, touched);
  send_many(caster);
}

void VolumeBuffer::send_signs(const ShadowVolume::Touched& touched) {
  constexpr uint32_t kChunk = FaceBuffer::kChunkFaces;
  const auto faces = static_cast<uint32_t>(volume_.signs().size());
  const bool regrown = faces > signs_room_;
  if (regrown) make_room(faces);
  DirtySlots dirty;
  if (touched.all || regrown) dirty.mark_all(faces);
  for (const uint32_t f : touched.faces) dirty.mark(f);
  for (const SlotRange range : dirty.take(kGapOfItems, kChunk)) {
    glBindBuffer(GL_TEXTURE_BUFFER, signs_[range.begin / kChunk].buffer.name());
    glBufferSubData(GL_TEXTURE_BUFFER, range.begin % kChunk, range.end - range.begin,
                    &volume_.signs()[range.begin]);
  }
}

// All signs are uploaded again afterwards.
void VolumeBuffer::make_room(uint32_t faces) {
  constexpr uint32_t kChunk = FaceBuffer::kChunkFaces;
  signs_room_ = faces <= kChunk ? std::bit_ceil(faces) : (faces + kChunk - 1) / kChunk * kChunk;
  signs_.resize((signs_room_ + kChunk - 1) / kChunk);
  for (const Signs& signs : signs_)
    gl::fill_buffer(GL_TEXTURE_BUFFER, signs.buffer, std::min(signs_room_, kChunk));
}

void VolumeBuffer::send_sides(const ShadowCaster& caster, const ShadowVolume::Touched& touched) {
  const std::span<const SilhouetteEdge> edges = volume_.silhouette();
  std::vector<Side> sides;
  if (touched.all || edges.size() > sides_.room) {
    for (const SilhouetteEdge& e : edges) sides.push_back(side(caster, e));
    return sides_.replace(sides);
  }
  DirtySlots dirty;
  for (const uint32_t place : touched.places) {
    if (place < edges.size()) dirty.mark(place);
  }
  for (const SlotRange range : dirty.take(kGapOfItems, kNoChunks)) {
    sides.clear();
    const uint32_t end = std::min<uint32_t>(range.end, static_cast<uint32_t>(edges.size()));
    for (uint32_t i = range.begin; i < end; ++i) sides.push_back(side(caster, edges[i]));
    gl::put_items<Side>(GL_ARRAY_BUFFER, sides_.buffer, range.begin, sides);
  }
  sides_.count = static_cast<GLsizei>(edges.size());
}

// Few edges have more than two copies, but the search needs a pass over the silhouette, which is short
// compared with the mesh.
void VolumeBuffer::send_many(const ShadowCaster& caster) {
  std::vector<Side> more;
  for (const SilhouetteEdge& e : volume_.silhouette()) {
    for (int left = std::abs(e.multiplicity) - kCopies; left > 0; left -= kCopies) {
      const int copies = std::min(left, kCopies);
      more.push_back(side(caster, {e.edge, e.multiplicity > 0 ? copies : -copies}));
    }
  }
  if (!more.empty() || many_.count > 0) many_.replace(more);
}

void VolumeBuffer::bind_signs(const gl::Program& program, size_t chunk) const {
  program.set("signs", kSignsUnit);
  glActiveTexture(GL_TEXTURE0 + kSignsUnit);
  glBindTexture(GL_TEXTURE_BUFFER, signs_[chunk].texture.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_R8I, signs_[chunk].buffer.name());
  glActiveTexture(GL_TEXTURE0);
}

void VolumeBuffer::draw_sides(const gl::Program& program, int vertices_of_side) const {
  program.set("vertices_of_side", vertices_of_side);
  for (const Sides* sides : {&sides_, &many_}) {
    if (sides->count == 0) continue;
    glBindVertexArray(sides->layout.name());
    glDrawArraysInstanced(GL_TRIANGLES, 0, kCopies * vertices_of_side, sides->count);
  }
}

void VolumeBuffer::draw_edges(int vertices) const {
  if (sides_.count == 0) return;
  glBindVertexArray(sides_.layout.name());
  glDrawArraysInstanced(GL_TRIANGLES, 0, vertices, sides_.count);
}

ShadowPass::ShadowPass(Shaders& shaders)
    : cap_(shaders.load(
          {{"frame.glsl", "placed.glsl", "shadow_light.glsl", "shadow_cap.vert"}, {"empty.frag"}})),
      side_(shaders.load(
          {{"frame.glsl", "placed.glsl", "shadow_light.glsl", "shadow_side.vert"}, {"empty.frag"}})) {}

void ShadowPass::rename_body(BodyId from, BodyId to) {
  const auto found = bodies_.find(from);
  if (found == bodies_.end()) return;
  bodies_.insert_or_assign(to, std::move(found->second));
  bodies_.erase(found);
}

void ShadowPass::follow(const Delta& delta) {
  for (const BodyDelta& d : delta.bodies) {
    const auto found = bodies_.find(d.body);
    if (found == bodies_.end()) continue;
    found->second.dirty.mark(d.added);
    found->second.dirty.mark(d.dead);
    found->second.relabelled.mark(d.relabelled);
  }
}

void ShadowPass::record_effort(const ShadowVolume::Effort& before, const ShadowVolume::Effort& after) {
  work_.faces += after.faces - before.faces;
  work_.edges += after.edges - before.edges;
}

void ShadowPass::catch_up(BodyShadows& shadows, const Body& body, const FloatFrame& frame,
                          const BodyLooks& looks) {
  if (!shadows.caster) {
    shadows.caster = std::make_unique<ShadowCaster>(body.mesh, frame);
    shadows.dirty = {};
    shadows.relabelled = {};
    shadows.groups.reset();
    ++work_.casters;
  }
  shadows.relabelled.mark(regrouped(body.mesh, shadows.groups.get(), looks.groups().get()));
  shadows.groups = looks.groups();
  if (shadows.dirty.empty() && shadows.relabelled.empty()) return;
  const std::vector<uint32_t> slots = take_slots(shadows.dirty), labels = take_slots(shadows.relabelled);
  const ShadowCaster::Change change =
      shadows.caster->update(body.mesh, slots, labels, labels_of(shadows.groups));
  for (auto& [key, kept] : shadows.volumes) {
    const ShadowVolume::Effort before = kept.buffer.volume().effort();
    kept.buffer.volume().follow(*shadows.caster, change);
    record_effort(before, kept.buffer.volume().effort());
  }
}

ShadowPass::Kept& ShadowPass::bring_up_to_date(const Subject& subject, BodyId id, const Body& body,
                                               const BodyPicture& picture, VolumeKey key) {
  BodyShadows& shadows = bodies_[id];
  const FloatFrame& frame = picture.faces().frame();
  const BodyLooks looks(id, body, subject.options);
  catch_up(shadows, body, frame, looks);
  const auto [found, fresh] = shadows.volumes.try_emplace(key, key.second);
  Kept& kept = found->second;
  kept.used = true;
  LightOnBody light = light_on_body(subject.options.lights[key.first], body.placement, frame, looks);
  ShadowVolume& volume = kept.buffer.volume();
  if (fresh || !(volume.light() == light)) {
    const ShadowVolume::Effort before = volume.effort();
    volume.rebuild(*shadows.caster, std::move(light));
    record_effort(before, volume.effort());
    ++work_.rebuilt;
  }
  kept.buffer.update(*shadows.caster);
  return kept;
}

const VolumeBuffer* ShadowPass::volume(const Subject& subject, BodyId id, size_t light, ShadowMethod method) {
  const auto found = subject.bodies.find(id);
  if (found == subject.bodies.end() || !subject.world.contains(id)) return nullptr;
  return &bring_up_to_date(subject, id, subject.world.body(id), found->second, {light, method}).buffer;
}

const ShadowCaster* ShadowPass::caster(BodyId id) const {
  const auto found = bodies_.find(id);
  return found == bodies_.end() ? nullptr : found->second.caster.get();
}

void ShadowPass::drop_unused() {
  for (auto& [id, shadows] : bodies_) {
    std::erase_if(shadows.volumes, [](const auto& entry) { return !entry.second.used; });
    for (auto& [key, kept] : shadows.volumes) kept.used = false;
  }
}

void ShadowPass::draw_caps(const Subject& subject, VolumeKey key, int sign, bool pushed) {
  cap_.set("wanted", sign);
  cap_.set("pushed", pushed ? 1 : 0);
  for_each_body(subject, [&](BodyId id, const Body& body, const BodyPicture& picture) {
    const VolumeBuffer& volume = bodies_.at(id).volumes.at(key).buffer;
    picture.bind(cap_, subject.space, body.placement);
    picture.faces().draw_chunks([&](size_t chunk) { volume.bind_signs(cap_, chunk); });
  });
}

void ShadowPass::draw_sides(const Subject& subject, VolumeKey key, int vertices) {
  for_each_body(subject, [&](BodyId id, const Body& body, const BodyPicture& picture) {
    picture.bind(side_, subject.space, body.placement);
    bodies_.at(id).volumes.at(key).buffer.draw_sides(side_, vertices);
  });
}

// A section plane removes nothing from the caps; but they are drawn in two parts, so that the visible part
// is clipped to the very triangles of the frame.
void ShadowPass::count_near_caps(const Subject& subject, VolumeKey key) {
  const NearCaps how = subject.options.shadow.near_caps;
  const SectionClip clip(subject.options);
  for (const int under : {1, -1}) {
    if (under < 0 && shown_section(subject.options) == nullptr) continue;
    cap_.set("under", under);
    for (const int sign : {1, -1}) {
      gl::State state = counting_behind(sign > 0);
      if (how == NearCaps::kLessOrEqual) state.depth = GL_LEQUAL;
      if (how == NearCaps::kDisplaced) state.offset = gl::DepthOffset{0, -1};
      const gl::ScopedState scope(state);
      draw_caps(subject, key, sign, false);
    }
  }
}

// Triangles are drawn with their corners in the order of the frame, so that their depths are bit-identical.
// The front of a near cap looks out of the volume depending on whether it faces the light; at a far cap it
// is the other way round. Near caps are clipped like the frame; geometry at infinity must not be clipped at
// all. Without a floor, all points at infinity of a directional light coincide, and there are no far caps.
void ShadowPass::count_robustly(const Subject& subject, VolumeKey key, const glm::vec4& light,
                                std::optional<float> floor) {
  cap_.use();
  cap_.set("light", light);
  set_floor(cap_, floor);
  count_near_caps(subject, key);
  const auto clamped = [](gl::State state) {
    state.clamps_depth = true;
    return state;
  };
  const bool ends_in_a_point = light.w == 0 && !floor;
  if (!ends_in_a_point) {
    for (const int sign : {1, -1}) {
      const gl::ScopedState state(clamped(counting_behind(sign < 0)));
      draw_caps(subject, key, sign, true);
    }
  }
  side_.use();
  side_.set("light", light);
  set_floor(side_, floor);
  side_.set("reach", 0.0f);
  const gl::ScopedState state(clamped(counting_behind(true)));
  draw_sides(subject, key, ends_in_a_point ? 3 : 6);
}

void ShadowPass::count_as_the_paper(const Subject& subject, VolumeKey key, const glm::vec4& light) {
  side_.use();
  side_.set("light", light);
  const double diagonal = subject.world.bounds().diagonal();
  side_.set("reach", subject.space.length(subject.options.shadow.extrusion * diagonal));
  const auto count_sides = [&](GLenum culled, GLenum change) {
    gl::State state = counting({.passed = change});
    state.culled = culled;
    const gl::ScopedState scope(state);
    draw_sides(subject, key, 6);
  };
  count_sides(GL_BACK, GL_INCR);
  count_sides(GL_FRONT, GL_DECR);
}

void ShadowPass::count(const Subject& subject, size_t light, ShadowMethod method,
                       std::optional<float> hidden_below) {
  KERF_ASSERT(light < subject.options.lights.size());
  const VolumeKey key{light, method};
  for_each_body(subject, [&](BodyId id, const Body& body, const BodyPicture& picture) {
    bring_up_to_date(subject, id, body, picture, key);
  });
  glClear(GL_STENCIL_BUFFER_BIT);
  const glm::vec4 in_frame = light_in_frame(subject.options.lights[light], subject.space);
  if (method == ShadowMethod::kRobust) {
    count_robustly(subject, key, in_frame, floor_for(in_frame, hidden_below));
  } else {
    count_as_the_paper(subject, key, in_frame);
  }
}

PictureMemory ShadowPass::memory() const {
  PictureMemory memory;
  for (const auto& [id, shadows] : bodies_) {
    if (shadows.caster) memory.shadows += shadows.caster->bytes();
    for (const auto& [key, kept] : shadows.volumes) {
      memory.shadows += kept.buffer.volume().bytes();
      memory.graphics += kept.buffer.bytes();
    }
  }
  return memory;
}

// The inspected light and its data.
struct ShadowOverlay::Inspected {
  const Subject& subject;
  ShadowPass& shadows;
  size_t light;
  ShadowMethod method;
  glm::vec4 in_frame;
  int height;  // of the frame, pixels

  template <typename Visit>
  void for_each_volume(const Visit& visit) const {
    for_each_body(subject, [&](BodyId id, const Body& body, const BodyPicture& picture) {
      const VolumeBuffer* volume = shadows.volume(subject, id, light, method);
      KERF_ASSERT(volume != nullptr);
      visit(*volume, body, picture);
    });
  }
};

ShadowOverlay::ShadowOverlay(Shaders& shaders)
    : line_(shaders.load({{"frame.glsl", "placed.glsl", "line.glsl", "shadow_light.glsl", "shadow_line.vert"},
                          {"box.frag"}})),
      sheet_(shaders.load({{"frame.glsl", "placed.glsl", "shadow_light.glsl", "shadow_side.vert"},
                           {"shadow_sheet.frag"},
                           {"SHEET"}})),
      facing_(shaders.load({{"frame.glsl", "placed.glsl", "facing.vert"}, {"facing.frag"}})),
      solid_(shaders.load({{"screen.vert"}, {"solid.frag"}})) {}

void ShadowOverlay::draw(const Subject& subject, ShadowPass& shadows, FaceNumbers& numbers,
                         const gl::Framebuffer& picture) const {
  const ViewOptions& options = subject.options;
  const ShowOptions& show = options.show;
  if (options.lights.empty()) return;
  const size_t light = std::min({options.shadow.inspected, options.lights.size() - 1, kMaxLights - 1});
  const glm::vec4 in_frame = light_in_frame(options.lights[light], subject.space);
  const Inspected seen{subject, shadows, light, options.shadow.method, in_frame, picture.shape().height};
  if (show.shadow_facing) draw_facing(seen);
  if (show.shadow_stencil) draw_counts(seen, numbers);
  if (show.shadow_volumes) draw_volumes(seen);
  if (show.silhouette) draw_silhouette(seen, numbers);
}

void ShadowOverlay::draw_facing(const Inspected& seen) const {
  const gl::ScopedState state({.depth = GL_EQUAL});
  const SectionClip clip(seen.subject.options);
  facing_.use();
  facing_.set("facing_colour", srgb(kFacing));
  facing_.set("averted_colour", srgb(kAverted));
  facing_.set("neither_colour", srgb(kEdgeOn));
  seen.for_each_volume([&](const VolumeBuffer& volume, const Body& body, const BodyPicture& picture) {
    picture.bind(facing_, seen.subject.space, body.placement);
    picture.faces().draw_chunks([&](size_t chunk) { volume.bind_signs(facing_, chunk); });
  });
}

void ShadowOverlay::draw_counts(const Inspected& seen, FaceNumbers& numbers) const {
  seen.shadows.count(seen.subject, seen.light, seen.method);
  gl::ScopedState state({});
  solid_.use();
  const auto fill = [&](GLenum test, size_t count, const glm::vec4& colour) {
    // The quad is as far as the sky, which has no count.
    state.set({.depth = GL_GREATER,
               .writes_depth = false,
               .blend = gl::kOver,
               .stencil = gl::Stencil{.test = test, .reference = static_cast<GLint>(count)}});
    solid_.set("colour", colour);
    no_vertices_.draw_screen();
  };
  fill(GL_EQUAL, 0, srgb(kLit, 0.55f));
  for (size_t n = 1; n < kCounts.size(); ++n) fill(GL_EQUAL, n, srgb(kCounts[n - 1], kCountOpacity));
  fill(GL_LEQUAL, kCounts.size(), srgb(kCounts.back(), kCountOpacity));
  std::vector<glm::vec4> colours{srgb(kLit)};
  for (const uint32_t c : kCounts) colours.push_back(srgb(c));
  if (seen.subject.options.legends) draw_legend(colours, 0, 0, numbers, seen.height);
}

void ShadowOverlay::draw_lines(const Inspected& seen, float half_width, float reach,
                               std::span<const glm::vec4> colours) const {
  line_.use();
  line_.set("light", seen.in_frame);
  line_.set("half_width",
            half_width * static_cast<float>(seen.subject.options.mark_scale * (1 + seen.height / 1400)));
  line_.set("reach", reach);
  line_.set("single_colour", colours[0]);
  line_.set("double_colour", colours[1]);
  line_.set("many_colour", colours[2]);
  seen.for_each_volume([&](const VolumeBuffer& volume, const Body& body, const BodyPicture& picture) {
    picture.bind(line_, seen.subject.space, body.placement);
    volume.draw_edges(kVerticesOfLine);
  });
}

void ShadowOverlay::draw_volumes(const Inspected& seen) const {
  const double diagonal = seen.subject.world.bounds().diagonal();
  const float reach = seen.subject.space.length(kSheetReach * diagonal);
  const gl::ScopedState state({.writes_depth = false, .clamps_depth = true, .blend = gl::kOver});
  sheet_.use();
  sheet_.set("light", seen.in_frame);
  sheet_.set("reach", reach);
  sheet_.set("front", srgb(kVolumeFront, 0.15f));
  sheet_.set("back", srgb(kVolumeBack, 0.12f));
  seen.for_each_volume([&](const VolumeBuffer& volume, const Body& body, const BodyPicture& picture) {
    picture.bind(sheet_, seen.subject.space, body.placement);
    volume.draw_sides(sheet_, 6);
  });
  draw_lines(seen, 0.45f, 0.6f * reach, all_of(srgb(0x8fc6ff, 0.22f)));
  draw_lines(seen, 0.6f, 0, all_of(srgb(0xd6ebff, 0.75f)));
}

// Faint if occluded; the visible part over a dark outline.
void ShadowOverlay::draw_silhouette(const Inspected& seen, FaceNumbers& numbers) const {
  gl::ScopedState state({.depth = GL_NONE, .blend = gl::kOver});
  draw_lines(seen, 0.6f, 0, silhouette_colours(0.22f));
  state.set({.writes_depth = false, .blend = gl::kOver});
  draw_lines(seen, 2.2f, 0, all_of(srgb(0x05070a, 0.6f)));
  draw_lines(seen, 1.3f, 0, silhouette_colours(1));
  if (!seen.subject.options.legends) return;
  draw_legend(silhouette_colours(1), 1, seen.subject.options.show.shadow_stencil ? 1 : 0, numbers,
              seen.height);
}

}  // namespace kerf
