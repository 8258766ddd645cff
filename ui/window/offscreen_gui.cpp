#include "ui/window/offscreen_gui.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <backends/imgui_impl_opengl3.h>

#include "core/base/assert.h"
#include "ui/window/theme.h"

namespace kerf {

OffscreenGui::OffscreenGui(const GuiLook& look) {
  KERF_ASSERT(ImGui::GetCurrentContext() == nullptr);
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  apply_theme(look);
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

OffscreenGui::~OffscreenGui() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void OffscreenGui::draw(const gl::Framebuffer& over, const std::function<void()>& paint) {
  KERF_ASSERT(!ImGui::GetCurrentContext()->WithinFrameScope);
  const gl::Framebuffer::Shape& shape = over.shape();
  ImGui::GetIO().DisplaySize = {static_cast<float>(shape.width), static_cast<float>(shape.height)};
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  paint();
  ImGui::Render();
  over.bind();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace kerf
