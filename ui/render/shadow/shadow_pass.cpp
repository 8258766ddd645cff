#include "ui/render/shadow/shadow_pass.h"

#include "core/base/assert.h"
#include "ui/gl/state.h"
#include "ui/render/shadow/seen_light.h"
#include "ui/render/view/section_clip.h"

namespace kerf {

namespace {

// Writes the stencil alone.
gl::State counting(const gl::Stencil& stencil) {
  return {.writes_depth = false, .writes_colour = false, .writes_alpha = false, .stencil = stencil};
}

// Counts the two sides of what is drawn where they lie behind the surface that is seen. `outward`: front
// faces look out of the volume.
gl::State counting_behind(bool outward) {
  if (outward) return counting({.front_behind = GL_DECR_WRAP, .back_behind = GL_INCR_WRAP});
  return counting({.front_behind = GL_INCR_WRAP, .back_behind = GL_DECR_WRAP});
}

// The least height of the unit vector towards a light for which volumes end at a floor: they get long below
// it.
constexpr float kLeastRise = 0.1f;

std::optional<float> floor_for(const glm::vec4& light, std::optional<float> floor) {
  return light.w == 0 && light.y >= kLeastRise ? floor : std::nullopt;
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

}  // namespace

ShadowPass::ShadowPass(Shaders& shaders)
    : cap_(shaders.load(
          {{"frame.glsl", "placed.glsl", "shadow_light.glsl", "shadow_cap.vert"}, {"empty.frag"}})),
      side_(shaders.load(
          {{"frame.glsl", "placed.glsl", "shadow_light.glsl", "shadow_side.vert"}, {"empty.frag"}})) {}

void ShadowPass::carry_on(BodyId from, BodyId to) {
  const auto found = bodies_.find(from);
  if (found == bodies_.end()) return;
  bodies_.insert_or_assign(to, std::move(found->second));
  bodies_.erase(found);
}

void ShadowPass::follow(const Delta& delta) {
  for (const BodyDelta& d : delta.bodies) {
    const auto found = bodies_.find(d.body);
    if (found == bodies_.end()) continue;
    found->second.dirty.mark(d.born);
    found->second.dirty.mark(d.gone);
    found->second.relabelled.mark(d.relabelled);
  }
}

void ShadowPass::note_effort(const ShadowVolume::Effort& before, const ShadowVolume::Effort& after) {
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
    note_effort(before, kept.buffer.volume().effort());
  }
}

ShadowPass::Kept& ShadowPass::bring_up_to_date(const Subject& subject, BodyId id, const Body& body,
                                               const BodyPicture& picture, VolumeKey key) {
  BodyShadows& shadows = bodies_[id];
  const FloatFrame& frame = picture.faces().frame();
  const BodyLooks looks(id, subject.options);
  catch_up(shadows, body, frame, looks);
  const auto [found, fresh] = shadows.volumes.try_emplace(key, key.second);
  Kept& kept = found->second;
  kept.used = true;
  LightOnBody light = light_on_body(subject.options.lights[key.first], body.placement, frame, looks);
  ShadowVolume& volume = kept.buffer.volume();
  if (fresh || !(volume.light() == light)) {
    const ShadowVolume::Effort before = volume.effort();
    volume.rebuild(*shadows.caster, std::move(light));
    note_effort(before, volume.effort());
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

// A section plane takes nothing from the caps; but they are drawn in two parts, so that the part that is seen
// has been clipped to the very triangles of the picture.
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

// A triangle is drawn with its corners in the order that the picture has, so that its depths are the same to
// the bit; whether its front looks out of the volume at its near cap depends on whether it faces the light,
// and at its far cap it is the other way round. Near caps are clipped as the picture is; what lies at
// infinity must not be clipped at all. Without a floor, all points at infinity of a light from one direction
// are one, and there are no far caps.
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

}  // namespace kerf
