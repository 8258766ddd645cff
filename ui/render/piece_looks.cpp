#include "ui/render/piece_looks.h"

#include "ui/render/face_slots.h"

namespace kerf {

namespace {

const glm::vec4 kNotTurned(0, 0, 0, 1);
// Numbers beyond those of pieces, whose colours are those of the sets of a separation; body.vert knows them.
constexpr float kStayed = 65536, kCameOff = 65537;
constexpr int kUnit = 3;  // of the textures; no program that draws bodies uses it for another

// Where the look moves the origin of the frame, which is the eye.
Vec3 moved_origin(const PieceLook& look, const FrameSpace& space) {
  return look.is_turned() ? look.turn * space.eye - space.eye + look.offset : look.offset;
}

glm::vec4 packed_turn(const PieceLook& look, const FrameSpace& space) {
  const Vec3 axis = space.turned({look.turn.x, look.turn.y, look.turn.z});
  return {glm::vec3(axis), static_cast<float>(look.turn.w)};
}

// `numbered`: the colour follows from the number of the look, not from the group.
glm::vec4 packed(const PieceLook& look, bool numbered, const FrameSpace& space) {
  const float number = numbered ? static_cast<float>(packed_piece(look.number)) + 1.0f : 0.0f;
  const float shown = (look.selected ? 1.0f : 0.0f) + 2.0f * number;
  return {glm::vec3(space.turned(moved_origin(look, space)) / space.unit), look.hidden ? -1.0f : shown};
}

}  // namespace

void PieceLooks::add_row(std::vector<glm::vec4>& table, size_t row) {
  while (table.size() <= 2 * row) table.insert(table.end(), {glm::vec4(0), kNotTurned});
}

bool PieceLooks::update(const BodyLooks& looks, const FrameSpace& space) {
  const bool changed = looks.by_group() != looks_ || looks.came_off() != came_off_ || up_ != space.up;
  if (!changed && !any_turned_) return false;
  up_ = space.up;
  looks_ = looks.by_group();
  came_off_ = looks.came_off();
  any_away_ = any_turned_ = any_selected_ = false;
  std::vector<glm::vec4> table;
  const size_t pieces = looks.groups() ? looks.groups()->middles.size() : SIZE_MAX;
  for (const auto& [group, look] : looks_) {
    const size_t row = packed_piece(group);
    add_row(table, row);
    table[2 * row] = packed(look, look.number > 0 || group >= pieces, space);
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
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(table.size() * sizeof(glm::vec4)), table.data(),
               GL_DYNAMIC_DRAW);
  return changed;
}

void PieceLooks::bind(const gl::Program& program) const {
  program.set("looks", count_);
  program.set("piece_looks", kUnit);
  if (count_ == 0) return;
  glActiveTexture(GL_TEXTURE0 + kUnit);
  glBindTexture(GL_TEXTURE_BUFFER, table_.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer_.name());
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace kerf
