#include "ui/window/gui.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

namespace kerf {

namespace {
constexpr float kDoubleClickSeconds = 0.3f;

// Whether the left button was pressed twice at about one place. ImGui takes all presses of a frame for one.
bool has_double_click(std::span<const InputEvent> events, double most_pixels) {
  std::optional<Vec2> first;
  for (const InputEvent& event : events) {
    if (event.kind != InputEvent::Kind::kPress || event.button != GLFW_MOUSE_BUTTON_LEFT) continue;
    if (first && glm::length(event.at - *first) <= most_pixels) return true;
    first = event.at;
  }
  return false;
}
}  // namespace

Gui::Gui(const Window& window) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

Gui::~Gui() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void Gui::dress(const GuiLook& look) {
  if (look_ == look) return;
  apply_theme(look);
  // Before the first frame the backend has no texture yet, and makes it by itself.
  if (look_) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }
  look_ = look;
}

void Gui::begin_frame(std::span<const InputEvent> events) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  // ImGui takes the time of a click from the frame that sees it. A press, its release and the next press are seen by
  // three frames at least, so that slow frames would keep two quick clicks apart.
  ImGuiIO& io = ImGui::GetIO();
  io.MouseDoubleClickTime = kDoubleClickSeconds + last_frame_seconds_ + io.DeltaTime;
  last_frame_seconds_ = io.DeltaTime;
  ImGui::NewFrame();
  if (!has_double_click(events, io.MouseDoubleClickMaxDist)) return;
  io.MouseClickedCount[ImGuiMouseButton_Left] = 2;
  io.MouseDoubleClicked[ImGuiMouseButton_Left] = true;
}

void Gui::end_frame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace kerf
