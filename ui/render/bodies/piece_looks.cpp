#include "ui/render/bodies/piece_looks.h"

#include "core/base/assert.h"
#include "core/joints/joined_parts.h"
#include "ui/gl/buffers.h"
#include "ui/render/bodies/face_slots.h"
#include "ui/render/bodies/overlay_marks.h"

namespace kerf {

BodyLooks::BodyLooks(BodyId id, const ViewOptions& options) {
  for (auto i = options.pieces.lower_bound({id, 0}); i != options.pieces.end() && i->first.body == id; ++i) {
    if (!(i->second == PieceLook{})) by_group_.emplace(i->first.label, i->second);
  }
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

}  // namespace kerf
