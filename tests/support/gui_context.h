#pragma once

#include <imgui.h>

namespace kerf::test {

// A context of ImGui in which widgets are drawn and operated without pixels.
class GuiContext {
 public:
  GuiContext() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {400, 300};
    io.DeltaTime = 0.5f;
    io.Fonts->Build();
  }
  ~GuiContext() { ImGui::DestroyContext(); }
  GuiContext(const GuiContext&) = delete;
  GuiContext& operator=(const GuiContext&) = delete;

  // Draws a frame with one window that fills the display.
  template <typename Draw>
  void frame(const Draw& draw) {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({400, 300});
    ImGui::Begin("widgets", nullptr, ImGuiWindowFlags_NoDecoration);
    draw();
    ImGui::End();
    ImGui::Render();
  }
};

}  // namespace kerf::test
