#include "ui/render/piece_looks.h"

#include "ui/render/face_slots.h"

namespace kerf {

namespace {

constexpr int kUnit = 3;  // of the textures; no program that draws bodies uses it for another

glm::vec4 packed(const PieceLook& look, const FrameSpace& space) {
  const float shown = (look.selected ? 1.0f : 0.0f) + 2.0f * static_cast<float>(packed_piece(look.number));
  return {glm::vec3(space.turned(look.offset) / space.unit), look.hidden ? -1.0f : shown};
}

}  // namespace

bool PieceLooks::update(BodyId body, const std::map<PieceId, PieceLook>& looks, const FrameSpace& space) {
  std::map<uint32_t, PieceLook> mine;
  for (auto i = looks.lower_bound({body, 0}); i != looks.end() && i->first.body == body; ++i) {
    if (!(i->second == PieceLook{})) mine.emplace(i->first.label, i->second);
  }
  if (mine == looks_ && up_ == space.up) return false;
  up_ = space.up;
  looks_ = std::move(mine);
  any_away_ = any_selected_ = false;
  std::vector<glm::vec4> table;
  for (const auto& [piece, look] : looks_) {
    const uint32_t label = packed_piece(piece);
    if (table.size() <= label) table.resize(label + 1, glm::vec4(0));
    table[label] = packed(look, space);
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
