#include "ui/editor/frozen_window.h"

#include <imgui.h>

namespace kerf {

void FrozenWindow::take(const Vec2& pixels) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glBindTexture(GL_TEXTURE_2D, picture_.name());
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 0, 0, static_cast<GLsizei>(pixels.x),
                   static_cast<GLsizei>(pixels.y), 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void FrozenWindow::draw(const Vec2& size) const {
  const auto texture = reinterpret_cast<ImTextureID>(static_cast<uintptr_t>(picture_.name()));
  ImGui::GetBackgroundDrawList()->AddImage(
      texture, {0, 0}, {static_cast<float>(size.x), static_cast<float>(size.y)}, {0, 1}, {1, 0});
}

}  // namespace kerf
