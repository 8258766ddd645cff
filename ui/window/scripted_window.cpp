#include "ui/window/scripted_window.h"

#include <epoxy/gl.h>
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

namespace kerf {

namespace {

constexpr double kReading = 0.001;  // s, which a reading of the clock lasts

// ImGui's keys that are not characters, and those of its shortcuts in text fields.
void name_keys(ImGuiIO& io) {
  const std::pair<ImGuiKey, int> keys[] = {{ImGuiKey_Tab, GLFW_KEY_TAB},
                                           {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                                           {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
                                           {ImGuiKey_UpArrow, GLFW_KEY_UP},
                                           {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                                           {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
                                           {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
                                           {ImGuiKey_Home, GLFW_KEY_HOME},
                                           {ImGuiKey_End, GLFW_KEY_END},
                                           {ImGuiKey_Insert, GLFW_KEY_INSERT},
                                           {ImGuiKey_Delete, GLFW_KEY_DELETE},
                                           {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
                                           {ImGuiKey_Space, GLFW_KEY_SPACE},
                                           {ImGuiKey_Enter, GLFW_KEY_ENTER},
                                           {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
                                           {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
                                           {ImGuiKey_A, GLFW_KEY_A},
                                           {ImGuiKey_C, GLFW_KEY_C},
                                           {ImGuiKey_V, GLFW_KEY_V},
                                           {ImGuiKey_X, GLFW_KEY_X},
                                           {ImGuiKey_Y, GLFW_KEY_Y},
                                           {ImGuiKey_Z, GLFW_KEY_Z}};
  for (const auto& [name, key] : keys) io.KeyMap[name] = key;
}

}  // namespace

double ScriptedWindow::Clock::seconds() const {
  if (std::exchange(frame_, script_.seconds()) != script_.seconds()) readings_ = 0;
  latest_ = std::max(latest_, frame_ + kReading * readings_++);
  return latest_;
}

Result<std::unique_ptr<Window>> ScriptedWindow::open(const std::filesystem::path& events, int width,
                                                     int height) {
  auto script = EventScript::open(events, {width, height});
  if (!script) return script.error();
  auto context = gl::OffscreenContext::create_with_surface(width, height);
  if (!context) return context.error();
  return std::unique_ptr<Window>(new ScriptedWindow(std::move(*script), std::move(*context)));
}

ScriptedWindow::ScriptedWindow(EventScript script, gl::OffscreenContext context)
    : script_(std::move(script)), context_(std::move(context)), clock_(script_), surface_(size()) {}

std::vector<InputEvent> ScriptedWindow::take_events() {
  std::vector<InputEvent> events = std::exchange(script_.input().heard().events, {});
  spread_times(events, script_.seconds() - script_.frame_seconds(), script_.seconds());
  return events;
}

std::vector<std::filesystem::path> ScriptedWindow::take_drops() {
  return std::exchange(script_.input().heard().drops, {});
}

bool ScriptedWindow::take_close() { return std::exchange(script_.input().heard().close, false); }

void ScriptedWindow::attach_gui() { name_keys(ImGui::GetIO()); }

void ScriptedWindow::begin_gui_frame() {
  (script_.draws() ? glDisable : glEnable)(GL_RASTERIZER_DISCARD);
  const VirtualInput& input = script_.input();
  if (std::exchange(surface_, size()) != size())
    context_.resize_surface(static_cast<int>(size().x), static_cast<int>(size().y));
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(size().x), static_cast<float>(size().y)};
  io.DeltaTime = static_cast<float>(script_.frame_seconds());
  io.MousePos = {static_cast<float>(input.pointer().x), static_cast<float>(input.pointer().y)};
}

}  // namespace kerf
