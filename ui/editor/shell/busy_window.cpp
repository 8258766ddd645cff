#include "ui/editor/shell/busy_window.h"

#include <imgui.h>

#include <GLFW/glfw3.h>

#include <utility>

#include "core/base/assert.h"
#include "ui/window/gui.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/progress_bar.h"

namespace kerf {

namespace {
constexpr std::chrono::seconds kSoon{1};
constexpr std::chrono::milliseconds kUnseen{300};  // a bar that comes and goes only disturbs
}  // namespace

void BusyWindow::keep(const Vec2& pixels) {
  began_ = Clock::now();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glBindTexture(GL_TEXTURE_2D, kept_.name());
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 0, 0, static_cast<GLsizei>(pixels.x),
                   static_cast<GLsizei>(pixels.y), 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glBindTexture(GL_TEXTURE_2D, 0);
}

bool BusyWindow::hear(const Input& input, ChangeThread& change) {
  KERF_ASSERT(change.busy());
  for (const InputEvent& event : input.events) {
    if (event.kind == InputEvent::Kind::kKey && event.button == GLFW_KEY_ESCAPE) {
      change.stop();
    } else {
      heard_.push_back(event);
    }
  }
  if (input.close) change.stop();
  return input.close;
}

void BusyWindow::draw(const Vec2& window, const Area& picture, ChangeThread& change) const {
  keep_active_item();
  const auto texture = to_im_texture(kept_.name());
  ImGui::GetBackgroundDrawList()->AddImage(
      texture, {0, 0}, {static_cast<float>(window.x), static_cast<float>(window.y)}, {0, 1}, {1, 0});
  const bool lasts = Clock::now() - began_ > kUnseen;
  if (lasts && draw_progress(picture, change.title(), change.fraction(), change.can_stop())) change.stop();
}

std::vector<InputEvent> BusyWindow::take_heard() {
  std::vector<InputEvent> heard = std::exchange(heard_, {});
  if (heard.empty() || Clock::now() - began_ < kSoon) return heard;
  std::erase_if(heard, [](const InputEvent& event) {
    return event.kind == InputEvent::Kind::kPress || event.kind == InputEvent::Kind::kWheel;
  });
  return heard;
}

}  // namespace kerf
