#include "ui/render/bodies/body_picture.h"

#include <algorithm>
#include <limits>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/base/platform.h"
#include "ui/render/bodies/face_slots.h"
#include "ui/render/bodies/overlay_marks.h"
#include "ui/render/view/colours.h"

namespace kerf {

BodyLooks::BodyLooks(BodyId id, const Body& body, const ViewOptions& options) {
  for (auto i = options.pieces.lower_bound({id, 0}); i != options.pieces.end() && i->first.body == id; ++i) {
    if (!(i->second == PieceLook{})) by_group_.emplace(i->first.label, i->second);
  }
  for (uint32_t label = 0; body.hidden && label < body.pieces.size(); ++label) by_group_[label].hidden = true;
  record_separation(id, options);
  const auto found = options.groups.find(id);
  if (found == options.groups.end()) return;
  KERF_ASSERT(found->second != nullptr);
  if (found->second->loose.empty()) return;
  groups_ = found->second;
  auto group = static_cast<uint32_t>(groups_->middles.size());
  for (const PieceGroups::Loose& loose : groups_->loose) {
    PieceLook look = of(loose.piece);
    look.offset = of(loose.goes_with).offset;
    look.turn = of(loose.goes_with).turn;
    if (look.number == 0) look.number = loose.piece;
    if (const auto set = came_off_.find(loose.piece); set != came_off_.end())
      came_off_.emplace(group, set->second);
    by_group_.emplace(group++, look);
  }
}

void BodyLooks::record_separation(BodyId id, const ViewOptions& options) {
  if (!options.stage) return;
  for (const PieceId& piece : options.stage->stayed) {
    if (piece.body == id) came_off_[piece.label] = false;
  }
  for (const PieceId& piece : options.stage->came_off) {
    if (piece.body == id) came_off_[piece.label] = true;
  }
}

const PieceLook& BodyLooks::of(uint32_t group) const {
  static const PieceLook plain;
  const auto found = by_group_.find(group);
  return found == by_group_.end() ? plain : found->second;
}

std::span<const uint32_t> labels_of(const std::shared_ptr<const PieceGroups>& groups) {
  return groups ? std::span(groups->of_face) : std::span<const uint32_t>();
}

namespace {

const glm::vec4 kNotTurned(0, 0, 0, 1);
// Numbers beyond those of pieces, for the colours of the sets of a separation; same values in body.vert.
constexpr float kStayed = 65536, kCameOff = 65537;
constexpr int kTextureUnit = 3;  // of the textures; programs that draw bodies use it for nothing else

// The position to which the look moves the origin of the frame, which is the eye.
Vec3 moved_origin(const PieceLook& look, const FrameSpace& space) {
  return look.is_turned() ? look.turn * space.eye - space.eye + look.offset : look.offset;
}

glm::vec4 packed_turn(const PieceLook& look, const FrameSpace& space) {
  const Vec3 axis = space.turned({look.turn.x, look.turn.y, look.turn.z});
  return {glm::vec3(axis), static_cast<float>(look.turn.w)};
}

// With a number, the colour follows from it and not from the group.
glm::vec4 packed(const PieceLook& look, std::optional<uint32_t> number, const FrameSpace& space) {
  const float shown_number = number ? static_cast<float>(packed_piece(*number)) + 1.0f : 0.0f;
  const float shown = (look.selected ? 1.0f : 0.0f) + 2.0f * shown_number;
  return {glm::vec3(space.turned(moved_origin(look, space)) / space.unit), look.hidden ? -1.0f : shown};
}

// Returns the groups of parts that no cut separated, including loose parts next to a piece.
std::set<uint32_t> groups_of_parts(const Body& body, const BodyLooks& looks) {
  std::set<uint32_t> parts;
  for (uint32_t label = 1; label < body.pieces.size(); ++label) {
    if (is_loaded_part(body, label)) parts.insert(label);
  }
  if (!looks.groups() || parts.empty()) return parts;
  auto group = static_cast<uint32_t>(looks.groups()->middles.size());
  for (const PieceGroups::Loose& loose : looks.groups()->loose) {
    if (parts.contains(loose.piece)) parts.insert(group);
    ++group;
  }
  return parts;
}

constexpr double kEndless = std::numeric_limits<double>::max();

// Returns the distinct offsets at which pieces of a body are drawn, including zero.
std::vector<Vec3> offsets_of(const BodyLooks& looks) {
  std::vector<Vec3> offsets{Vec3(0)};
  for (const auto& [group, look] : looks.by_group()) {
    if (std::find(offsets.begin(), offsets.end(), look.offset) == offsets.end())
      offsets.push_back(look.offset);
  }
  return offsets;
}

bool shows_front(const Body& body, FaceId f, const Vec3& direction) {
  const Triangle t = body.mesh.triangle(f);
  return glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), direction) < 0;
}

constexpr size_t kPaints = 256;
constexpr size_t kPieceColours = 32;  // as in body.vert

}  // namespace

void PieceLooks::add_row(std::vector<glm::vec4>& table, size_t row) {
  while (table.size() <= 2 * row) table.insert(table.end(), {glm::vec4(0), kNotTurned});
}

bool PieceLooks::update(const Body& body, const BodyLooks& looks, const FrameSpace& space) {
  std::set<uint32_t> parts = groups_of_parts(body, looks);
  const bool changed =
      looks.by_group() != looks_ || looks.came_off() != came_off_ || parts != parts_ || up_ != space.up;
  if (!changed && !any_turned_) return false;
  up_ = space.up;
  looks_ = looks.by_group();
  came_off_ = looks.came_off();
  parts_ = std::move(parts);
  any_away_ = any_turned_ = any_selected_ = false;
  std::vector<glm::vec4> table;
  const size_t pieces = looks.groups() ? looks.groups()->middles.size() : SIZE_MAX;
  for (const uint32_t part : parts_) {
    const size_t row = packed_piece(part);
    add_row(table, row);
    table[2 * row] = packed(PieceLook(), 0, space);
  }
  for (const auto& [group, look] : looks_) {
    const size_t row = packed_piece(group);
    add_row(table, row);
    std::optional<uint32_t> number;
    if (look.number > 0 || group >= pieces) number = look.number;
    if (parts_.contains(group)) number = 0;
    table[2 * row] = packed(look, number, space);
    table[2 * row + 1] = packed_turn(look, space);
    any_away_ = any_away_ || look.hidden || look.is_away();
    any_turned_ = any_turned_ || look.is_turned();
    any_selected_ = any_selected_ || (look.selected && !look.hidden);
  }
  for (const auto& [group, came_off] : came_off_) {
    const size_t row = packed_piece(group);
    add_row(table, row);
    float& shown = table[2 * row].w;
    const bool selected = looks.of(group).selected;
    if (shown >= 0) shown = (selected ? 1.0f : 0.0f) + 2.0f * (1.0f + (came_off ? kCameOff : kStayed));
  }
  count_ = static_cast<int>(table.size() / 2);
  gl::fill_buffer(GL_TEXTURE_BUFFER, buffer_, table.size() * sizeof(glm::vec4), table.data());
  return changed;
}

void PieceLooks::bind(const gl::Program& program) const {
  program.set("looks", count_);
  program.set("piece_looks", kTextureUnit);
  if (count_ == 0) return;
  glActiveTexture(GL_TEXTURE0 + kTextureUnit);
  glBindTexture(GL_TEXTURE_BUFFER, table_.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer_.name());
  glActiveTexture(GL_TEXTURE0);
}

std::optional<Pick> pick(const World& world, const ViewOptions& options, const Pose& ray) {
  KERF_ASSERT(is_unit(ray.direction));
  std::optional<Pick> nearest;
  const SectionPlane* section = shown_section(options);
  const Interval seen = section != nullptr ? section->kept_along(ray) : Interval{0, kEndless};
  std::vector<RayHit> hits;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.hidden) continue;
    const BodyLooks looks(id, body, options);
    for (const Vec3& offset : offsets_of(looks)) {
      const Pose through = body.placement.to_body(Pose{ray.origin - offset, ray.direction});
      const double most = nearest ? nearest->length : seen.high;
      hits.clear();
      body.tree.crossings(body.mesh, through, {seen.low, most}, hits);
      for (const RayHit& hit : hits) {
        const PieceLook& look = looks.of(body.mesh, hit.face);
        if (look.hidden || look.offset != offset) continue;
        if (options.cull_backs && !shows_front(body, hit.face, through.direction)) continue;
        if (!nearest || hit.length < nearest->length) nearest = Pick{id, hit.face, hit.length};
        break;
      }
    }
  }
  return nearest;
}

Shaders::Shaders() : folder_(assets_folder() / "shaders") {}

gl::Program Shaders::load(const gl::ProgramFiles& files) {
  if (!status_) return {};
  Result<gl::Program> program = gl::Program::load(folder_, files);
  if (!program) {
    status_ = program.error();
    return {};
  }
  program->bind_block("Frame", kFrameBlock);
  program->bind_block("Paints", kPaintBlock);
  program->bind_block("Surfaces", kSurfaceBlock);
  return std::move(*program);
}

bool is_frame_bound() {
  GLint buffer = 0;
  glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, kFrameBlock, &buffer);
  return buffer != 0;
}

std::vector<glm::vec4> paint_table(const std::vector<std::string>& materials,
                                   const std::map<std::string, Paint>& paints,
                                   std::span<const std::optional<SurfaceLook>> looks) {
  const Paint plain;
  std::vector<glm::vec4> table(kPaints, glm::vec4(glm::vec3(plain.colour), plain.gloss));
  for (size_t m = 0; m < std::min(kPaints, materials.size()); ++m) {
    const auto found = paints.find(materials[m]);
    if (found != paints.end()) {
      table[m] = glm::vec4(glm::vec3(found->second.colour), found->second.gloss);
    } else if (m < looks.size() && looks[m]) {
      table[m] = glm::vec4(glm::vec3(looks[m]->base), kDescribed + 1 - looks[m]->roughness);
    }
  }
  return table;
}

std::vector<glm::dvec3> piece_colours(const std::vector<std::string>& materials,
                                      const std::map<std::string, Paint>& paints) {
  std::vector<glm::dvec3> there;
  for (const glm::vec4& paint : paint_table(materials, paints)) there.emplace_back(glm::vec3(paint));
  there.resize(std::clamp<size_t>(materials.size(), 1, there.size()));
  return piece_palette(there, kPieceColours);
}

BodyPicture::BodyPicture(const Body& body, const std::map<std::string, Paint>& paints, PreparedBody prepared,
                         std::shared_ptr<const SurfaceTextures> textures, double glow_width)
    : faces_(body.mesh, prepared.frame, std::move(prepared.bases), glow_width),
      textures_(std::move(textures)) {
  std::span<const std::optional<SurfaceLook>> looks;
  if (textures_) looks = textures_->looks();
  std::vector<glm::vec4> table = paint_table(body.material_names, paints, looks);
  for (const glm::dvec3& colour : piece_colours(body.material_names, paints))
    table.emplace_back(glm::vec3(colour), 0);
  gl::fill_buffer(GL_UNIFORM_BUFFER, paints_, table.size() * sizeof(glm::vec4), table.data(), GL_STATIC_DRAW);
}

void BodyPicture::bind(const gl::Program& program, const FrameSpace& space,
                       const Placement& placement) const {
  program.set("frame_from_body", space.from_body(placement, faces_.frame()));
  program.set("turn", glm::mat3(space.turn_from(placement.orientation)));
  program.set("terminator", faces_.deviation());
  program.set("heated", faces_.heat().any() ? 1 : 0);
  glBindBufferBase(GL_UNIFORM_BUFFER, kPaintBlock, paints_.name());
  looks_.bind(program);
  if (is_textured()) textures_->bind(program, faces_.has_uvs());
}

void BodyPicture::draw(const gl::Program& program, const FrameSpace& space,
                       const Placement& placement) const {
  bind(program, space, placement);
  faces_.draw();
}

}  // namespace kerf
