#include "ui/render/piece_looks.h"

#include "ui/render/face_slots.h"

namespace kerf {

namespace {

constexpr int kUnit = 3;  // of the textures; no program that draws bodies uses it for another

// `numbered`: the colour follows from the number of the look, not from the group.
glm::vec4 packed(const PieceLook& look, bool numbered, const FrameSpace& space) {
  const float number = numbered ? static_cast<float>(packed_piece(look.number)) + 1.0f : 0.0f;
  const float shown = (look.selected ? 1.0f : 0.0f) + 2.0f * number;
  return {glm::vec3(space.turned(look.offset) / space.unit), look.hidden ? -1.0f : shown};
}

}  // namespace

bool PieceLooks::update(const BodyLooks& looks, const FrameSpace& space) {
  if (looks.by_group() == looks_ && up_ == space.up) return false;
  up_ = space.up;
  looks_ = looks.by_group();
  any_away_ = any_selected_ = false;
  std::vector<glm::vec4> table;
  const size_t pieces = looks.groups() ? looks.groups()->middles.size() : SIZE_MAX;
  for (const auto& [group, look] : looks_) {
    const uint32_t row = packed_piece(group);
    if (table.size() <= row) table.resize(row + 1, glm::vec4(0));
    table[row] = packed(look, look.number > 0 || group >= pieces, space);
    any_away_ = any_away_ || look.hidden || look.offset != Vec3(0);
    any_selected_ = any_selected_ || (look.selected && !look.hidden);
  }
  count_ = static_cast<int>(table.size());
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(table.size() * sizeof(glm::vec4)), table.data(),
               GL_DYNAMIC_DRAW);
  return true;
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
