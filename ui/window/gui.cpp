#include "ui/window/gui.h"

#include <backends/imgui_impl_opengl3.h>
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <algorithm>
#include <cfloat>
#include <set>
#include <utility>

#include "core/base/assert.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

using Kind = InputEvent::Kind;

constexpr int kMaxHeldFrames = 8;

bool is_key(int key) { return key >= 0 && key <= GLFW_KEY_LAST; }

// Returns true if a character accompanies the press of a key, and ImGui uses only the former.
bool types(const InputEvent& event) {
  constexpr int kCommands = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  const bool character = (event.button >= GLFW_KEY_SPACE && event.button <= GLFW_KEY_WORLD_2) ||
                         (event.button >= GLFW_KEY_KP_0 && event.button <= GLFW_KEY_KP_ADD) ||
                         event.button == GLFW_KEY_KP_EQUAL;
  return character && (event.mods & kCommands) == 0;
}

bool is_shift(int key) { return key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT; }

bool is_escape(const InputEvent& event) {
  return (event.kind == Kind::kKey || event.kind == Kind::kKeyUp) && event.button == GLFW_KEY_ESCAPE;
}

bool is_of_keyboard(const InputEvent& event) {
  return event.kind == Kind::kKey || event.kind == Kind::kKeyUp || event.kind == Kind::kText;
}

// The content of a frame so far; decides if it can show another event in order.
class Frame {
 public:
  explicit Frame(bool typing) : typing_(typing) {}

  bool ends_before(const InputEvent& event) const {
    switch (event.kind) {
      case Kind::kMove:
      case Kind::kRelease:
      case Kind::kWheel:
        return false;
      case Kind::kPress:
        return command_ || text_ || pressed_.contains(event.button);
      case Kind::kKey:
        if (event.again) return false;
        if (is_modifier(event.button)) return ends_before_modifier(event.button);
        if (typing_ && types(event)) return command_ || clicked_;
        return command_ || text_ || clicked_ || changed_.contains(event.button);
      case Kind::kKeyUp:
        return is_modifier(event.button) ? ends_before_modifier(event.button)
                                         : changed_.contains(event.button);
      case Kind::kText:
        return !typed_last_ && (command_ || clicked_);
    }
    return false;
  }

  void add(const InputEvent& event) {
    typed_last_ = event.kind == Kind::kKey && types(event);
    switch (event.kind) {
      case Kind::kPress:
        pressed_.insert(event.button);
        clicked_ = true;
        break;
      case Kind::kRelease:
        clicked_ = true;
        break;
      case Kind::kKey:
      case Kind::kKeyUp:
        add_key(event);
        break;
      case Kind::kText:
        text_ = true;
        break;
      case Kind::kMove:
      case Kind::kWheel:
        break;
    }
  }

 private:
  // The modifiers of a frame apply to all its keys and clicks; characters do without Shift.
  bool ends_before_modifier(int key) const {
    return command_ || clicked_ || changed_.contains(key) || (text_ && !is_shift(key));
  }

  void add_key(const InputEvent& event) {
    if (event.again || (typing_ && types(event))) return;
    changed_.insert(event.button);
    if (event.kind == Kind::kKey && !is_modifier(event.button)) command_ = true;
  }

  bool typing_;
  bool command_ = false, text_ = false, clicked_ = false;
  bool typed_last_ = false;  // the last event is a key whose character follows
  std::set<int> changed_, pressed_;
};

constexpr float kDoubleClickSeconds = 0.3f;

// Returns true if the next frame gives the focus to a text field, by Tab or on request of the last frame. A
// focused field may repeat this request in each frame.
bool is_focus_about_to_move() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (!context.NavMoveSubmitted || (context.NavMoveFlags & ImGuiNavMoveFlags_Tabbing) == 0) return false;
  return (context.NavMoveFlags & ImGuiNavMoveFlags_FocusApi) == 0 || !is_text_field_active();
}

// Returns true if the last frame omitted the active item (see keep_active_item).
bool is_active_item_hidden() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.ActiveId != 0 && context.ActiveIdWindow != nullptr && !context.ActiveIdWindow->Active;
}

}  // namespace

bool is_text_field_active() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.ActiveId == 0 || context.ActiveId != context.InputTextState.ID) return false;
  // Within a frame the last one has set the flag; between frames, the next one is about to.
  return context.WithinFrameScope ? context.IO.WantTextInput : context.WantTextInputNextFrame == 1;
}

bool are_keys_free() {
  constexpr ImGuiPopupFlags kAny = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
  return !is_text_field_active() && !ImGui::IsPopupOpen(nullptr, kAny);
}

void GuiInput::add(std::span<const InputEvent> events) {
  queue_.insert(queue_.end(), events.begin(), events.end());
}

bool GuiInput::shows_pressed(int button) const {
  return button >= 0 && button < static_cast<int>(kButtons) && shown_[static_cast<size_t>(button)];
}

std::vector<InputEvent> GuiInput::take_frame(bool typing, KeyboardHold hold) {
  if (hold == KeyboardHold::kForWork) return take_while_working();
  const bool waits = hold == KeyboardHold::kForFocus && held_frames_ < kMaxHeldFrames;
  held_frames_ = hold == KeyboardHold::kForFocus ? held_frames_ + 1 : 0;
  Frame frame(typing);
  std::vector<InputEvent> taken;
  while (!queue_.empty()) {
    const InputEvent& next = queue_.front();
    if (waits && (next.kind == Kind::kKey || next.kind == Kind::kText)) break;
    // ImGui must first see the button released.
    if (next.kind == Kind::kPress && shows_pressed(next.button)) break;
    if (frame.ends_before(next)) break;
    frame.add(next);
    taken.push_back(next);
    queue_.pop_front();
  }
  return taken;
}

// The mouse and Esc overtake other keys, which wait.
std::vector<InputEvent> GuiInput::take_while_working() {
  const auto passes = [](const InputEvent& event) { return is_escape(event) || !is_of_keyboard(event); };
  std::vector<InputEvent> taken;
  Frame frame(false);
  std::deque<InputEvent> left;
  bool over = false;
  for (const InputEvent& event : queue_) {
    over = over || (passes(event) && (frame.ends_before(event) ||
                                      (event.kind == Kind::kPress && shows_pressed(event.button))));
    if (over || !passes(event)) {
      left.push_back(event);
      continue;
    }
    frame.add(event);
    taken.push_back(event);
  }
  queue_ = std::move(left);
  return taken;
}

void GuiInput::feed(std::span<const InputEvent> events, ImGuiIO& io) {
  std::array<bool, kButtons> pressed{};
  const InputEvent* first_press = nullptr;
  for (const InputEvent& event : events) {
    const auto button = static_cast<size_t>(event.button);
    switch (event.kind) {
      case Kind::kPress:
        if (first_press == nullptr) first_press = &event;
        if (button < kButtons) down_[button] = pressed[button] = true;
        break;
      case Kind::kRelease:
        if (button < kButtons) down_[button] = false;
        break;
      case Kind::kWheel:
        io.MouseWheel += static_cast<float>(event.wheel);
        io.MouseWheelH += static_cast<float>(event.wheel_aside);
        break;
      case Kind::kKey:
      case Kind::kKeyUp:
        if (is_key(event.button)) io.KeysDown[event.button] = event.kind == Kind::kKey;
        break;
      case Kind::kText:
        io.AddInputCharacter(event.character);
        break;
      case Kind::kMove:
        break;
    }
  }
  for (size_t button = 0; button < kButtons; ++button)
    io.MouseDown[button] = shown_[button] = down_[button] || pressed[button];
  const auto held = [&](int left, int right) { return io.KeysDown[left] || io.KeysDown[right]; };
  io.KeyCtrl = held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
  io.KeyShift = held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
  io.KeyAlt = held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
  io.KeySuper = held(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
  if (!events.empty()) pointer_ = events.back().at;
  // The pointer may have left the place of the press, but the item hovered at that place must receive it.
  const std::optional<Vec2> at = first_press != nullptr ? first_press->at : waits() ? pointer_ : std::nullopt;
  if (at) io.MousePos = {static_cast<float>(at->x), static_cast<float>(at->y)};
}

void begin_gui_frame_with_keys(std::span<const InputEvent> events) {
  ImGuiIO& io = ImGui::GetIO();
  KERF_ASSERT(!ImGui::GetCurrentContext()->WithinFrameScope);
  for (const InputEvent& event : events) {
    if (event.kind == Kind::kKey && event.again && is_key(event.button) && io.KeysDown[event.button])
      io.KeysDownDuration[event.button] = -1;
  }
  const float delay = std::exchange(io.KeyRepeatDelay, FLT_MAX);
  ImGui::NewFrame();
  io.KeyRepeatDelay = delay;
  for (float& duration : io.KeysDownDuration) duration = std::min(duration, 0.5f * delay);
}

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
  // Before the first frame the backend has no texture yet, and creates it itself.
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
  // ImGui times a click by the frame that sees it. A press, its release and the next press take at least
  // three frames, so slow frames would separate two quick clicks.
  io.MouseDoubleClickTime = kDoubleClickSeconds + last_frame_seconds_ + io.DeltaTime;
  last_frame_seconds_ = io.DeltaTime;
  hold_release(events);
  begin_gui_frame_with_keys(events);
  return events;
}

// The first frame that draws the item again shows it at the place of the release; the next frame passes the
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
