#include "ui/editor/shell/mouse_input.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <glm/geometric.hpp>
#include <utility>

#include "core/base/assert.h"
#include "ui/editor/shared/user_input.h"
#include "ui/editor/shared/viewport_pointer.h"

namespace kerf {

bool is_popup_open() {
  constexpr ImGuiPopupFlags kAny = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
  return ImGui::IsPopupOpen(nullptr, kAny) && ImGui::GetTopMostPopupModal() == nullptr;
}

void close_popups() {
  KERF_ASSERT(ImGui::GetCurrentContext()->WithinFrameScope);
  ImGui::ClosePopupToLevel(0, true);
}

bool pointer_is_over_panel() {
  KERF_ASSERT(ImGui::GetCurrentContext()->WithinFrameScope);
  return ImGui::IsWindowHovered(ImGuiHoveredFlags_AnyWindow | ImGuiHoveredFlags_AllowWhenBlockedByPopup |
                                ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
}

std::optional<InputEvent> DeferredPress::press_of(const InputEvent& event) {
  if (!held_) return std::nullopt;
  switch (event.kind) {
    case InputEvent::Kind::kMove:
      if (glm::length(event.at - held_->at) <= kClickReach) return std::nullopt;
      return std::exchange(held_, std::nullopt);
    case InputEvent::Kind::kPress:
    case InputEvent::Kind::kRelease:
      held_.reset();
      break;
    case InputEvent::Kind::kWheel:
    case InputEvent::Kind::kKey:
    case InputEvent::Kind::kKeyUp:
    case InputEvent::Kind::kText:
      break;
  }
  return std::nullopt;
}

namespace {

std::unique_ptr<Interaction> begin(Workspace& workspace, const Features& features, const InputEvent& event) {
  const bool alt = (event.mods & GLFW_MOD_ALT) != 0, left = event.button == GLFW_MOUSE_BUTTON_LEFT;
  const Press press{event, (event.mods & GLFW_MOD_SHIFT) != 0, (event.mods & GLFW_MOD_CONTROL) != 0};
  if (event.button == GLFW_MOUSE_BUTTON_RIGHT) return std::make_unique<Pan>(workspace);
  if (event.button == GLFW_MOUSE_BUTTON_MIDDLE && press.shift) return std::make_unique<Pan>(workspace);
  if (event.button == GLFW_MOUSE_BUTTON_MIDDLE || (left && alt)) return std::make_unique<Orbit>(workspace);
  for (size_t i = 0; left && i < features.size(); ++i) {
    if (auto claimed = features[i]->begin_interaction(press)) return claimed;
  }
  return nullptr;
}

}  // namespace

void handle_mouse(Workspace& workspace, const Features& features, const InputEvent& event, bool free) {
  PointerInput& input = workspace.input;
  input.pointer = event.at;
  input.viewport_hovered = free && workspace.view.layout.viewport.contains(event.at);
  if (!input.held) workspace.view.in_second = workspace.view.layout.second.contains(event.at);
  switch (event.kind) {
    case InputEvent::Kind::kPress:
      if (!input.held && input.viewport_hovered) input.held = begin(workspace, features, event);
      break;
    case InputEvent::Kind::kMove:
      if (input.held) input.held->move(event);
      break;
    case InputEvent::Kind::kRelease:
      if (!input.held) break;
      input.held->release(event);
      if (!input.held->cuts()) input.held.reset();
      break;
    case InputEvent::Kind::kWheel:
      if (input.viewport_hovered && !(input.held && input.held->cuts())) zoom(workspace, event.wheel);
      break;
    case InputEvent::Kind::kKey:
    case InputEvent::Kind::kKeyUp:
    case InputEvent::Kind::kText:
      break;
  }
  if (input.held && input.held->over()) input.held.reset();
}

}  // namespace kerf
