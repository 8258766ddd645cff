#include "ui/window/gui.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <backends/imgui_impl_opengl3.h>

#include "core/base/assert.h"

namespace kerf {

namespace {
constexpr float kDoubleClickSeconds = 0.3f;

// Whether the next frame gives the focus to a text field, by Tab or because the last frame asked for it. A
// field that has it already may ask for it in each frame.
bool is_focus_about_to_move() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (!context.NavMoveSubmitted || (context.NavMoveFlags & ImGuiNavMoveFlags_Tabbing) == 0) return false;
  return (context.NavMoveFlags & ImGuiNavMoveFlags_FocusApi) == 0 || !is_text_field_active();
}

// Whether the last frame left out the item that the mouse holds (see keep_active_item).
bool is_active_item_hidden() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.ActiveId != 0 && context.ActiveIdWindow != nullptr && !context.ActiveIdWindow->Active;
}
}  // namespace

void keep_active_item() {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  KERF_ASSERT(context.WithinFrameScope);
  if (context.ActiveId == 0) return;
  ImGui::KeepAliveID(context.ActiveId);
  context.ActiveIdNoClearOnFocusLoss = true;
}

Gui::Gui(Window& window) : window_(window) {
  KERF_ASSERT(ImGui::GetCurrentContext() == nullptr);
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  window_.attach_gui();
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

Gui::~Gui() {
  ImGui_ImplOpenGL3_Shutdown();
  window_.detach_gui();
  ImGui::DestroyContext();
}

void Gui::dress(const GuiLook& look) {
  KERF_ASSERT(!ImGui::GetCurrentContext()->WithinFrameScope);
  if (look_ == look) return;
  apply_theme(look);
  // Before the first frame the backend has no texture yet, and makes it by itself.
  if (look_) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }
  look_ = look;
}

std::vector<InputEvent> Gui::begin_frame(KeyboardHold hold) {
  KERF_ASSERT(!ImGui::GetCurrentContext()->WithinFrameScope);
  ImGui_ImplOpenGL3_NewFrame();
  window_.begin_gui_frame();
  input_.add(window_.take_events());
  if (hold == KeyboardHold::kNone && is_focus_about_to_move()) hold = KeyboardHold::kForFocus;
  std::vector<InputEvent> events = input_.take_frame(is_text_field_active(), hold);
  ImGuiIO& io = ImGui::GetIO();
  input_.feed(events, io);
  // ImGui takes the time of a click from the frame that sees it. A press, its release and the next press are
  // seen by three frames at least, so that slow frames would keep two quick clicks apart.
  io.MouseDoubleClickTime = kDoubleClickSeconds + last_frame_seconds_ + io.DeltaTime;
  last_frame_seconds_ = io.DeltaTime;
  hold_release(events);
  begin_gui_frame_with_keys(events);
  return events;
}

// The first frame that draws the item again shows it where the button was released; the frame after that, the
// release.
void Gui::hold_release(std::span<const InputEvent> events) {
  if (!is_active_item_hidden()) return released_.reset();
  for (const InputEvent& event : events) {
    if (event.kind == InputEvent::Kind::kRelease && event.button == GLFW_MOUSE_BUTTON_LEFT)
      released_ = event.at;
  }
  if (!released_) return;
  ImGuiIO& io = ImGui::GetIO();
  io.MouseDown[ImGuiMouseButton_Left] = true;
  io.MousePos = {static_cast<float>(released_->x), static_cast<float>(released_->y)};
}

void Gui::end_frame() {
  KERF_ASSERT(ImGui::GetCurrentContext()->WithinFrameScope);
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace kerf
