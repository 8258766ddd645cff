#include "ui/window/scripted_window.h"

#include <epoxy/gl.h>
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <utility>

#include "core/base/assert.h"
#include "ui/gl/image.h"

namespace kerf {

namespace {

// Frames until the opening or closing of a widget is complete.
constexpr int kFramesToSettle = 4;

constexpr double kMaxWindow = 8192;  // pixels

// A modifier: its name, its key and its flag in other events.
struct Modifier {
  const char* name;
  int key, mod;
};
constexpr std::array kModifiers{Modifier{"Ctrl", GLFW_KEY_LEFT_CONTROL, GLFW_MOD_CONTROL},
                                Modifier{"Shift", GLFW_KEY_LEFT_SHIFT, GLFW_MOD_SHIFT},
                                Modifier{"Alt", GLFW_KEY_LEFT_ALT, GLFW_MOD_ALT}};

std::optional<int> key_named(const std::string& name) {
  for (const Modifier& modifier : kModifiers) {
    if (name == modifier.name) return modifier.key;
  }
  if (name == "Esc") return GLFW_KEY_ESCAPE;
  if (name == "Num Enter") return GLFW_KEY_KP_ENTER;
  if (name.size() == 5 && name.starts_with("Num ") && name[4] >= '0' && name[4] <= '9')
    return GLFW_KEY_KP_0 + (name[4] - '0');
  const auto chord = parse_chord(name);
  if (!chord || chord->mods != 0) return std::nullopt;
  return chord->key;
}

std::optional<int> button_named(const std::string& name) {
  if (name == "left") return GLFW_MOUSE_BUTTON_LEFT;
  if (name == "right") return GLFW_MOUSE_BUTTON_RIGHT;
  if (name == "middle") return GLFW_MOUSE_BUTTON_MIDDLE;
  return std::nullopt;
}

constexpr double kReading = 0.001;  // s, duration of a clock reading

// Sets the indices of ImGui's keys that are not characters, and of its shortcuts in text fields.
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

Result<EventScript> EventScript::open(const std::filesystem::path& file, Vec2 size) {
  if (file == "-") return EventScript(nullptr, "standard input", size);
  auto steps = std::make_unique<std::ifstream>(file);
  if (!*steps) return bad_input(file.string() + ": cannot be read; expected one step per line");
  return EventScript(std::move(steps), file.string(), size);
}

EventScript::EventScript(std::unique_ptr<std::istream> steps, std::string name, Vec2 size)
    : own_steps_(std::move(steps)), name_(std::move(name)), input_(size) {}

std::optional<std::string> EventScript::next_line() {
  std::istream& steps = own_steps_ ? *own_steps_ : std::cin;
  std::string line;
  while (std::getline(steps, line)) {
    ++line_;
    if (line.find_first_not_of(" \t\r") != std::string::npos) return line;
  }
  return std::nullopt;
}

Result<bool> EventScript::begin_frame(bool moving, const Answer& answer) {
  KERF_ASSERT(answer);
  if (is_still_waiting(moving)) {
    pass_frame();
    return true;
  }
  while (const auto line = next_line()) {
    const std::string where = name_ + ":" + std::to_string(line_);
    const auto step = nlohmann::json::parse(*line, nullptr, false);
    if (!step.is_object() || step.size() != 1)
      return bad_input(where + ": a step must be an object with one key, such as {\"move\": [100, 200]}");
    const auto next = take(step.begin().key(), JsonValue(step, where)[step.begin().key()], answer);
    if (!next) return next.error();
    if (*next == Next::kStep) continue;
    pass_frame();
    return true;
  }
  return false;
}

bool EventScript::is_still_waiting(bool moving) {
  if (seconds_ >= wait_until_ || (until_rest_ && !moving && still_ >= kFramesToSettle)) {
    wait_until_ = 0;
    return false;
  }
  ++still_;
  return true;
}

Result<EventScript::Next> EventScript::take(const std::string& name, const JsonValue& value,
                                            const Answer& answer) {
  const auto then = [](Next next, const Status& status) -> Result<Next> {
    if (!status) return status.error();
    return next;
  };
  if (name == "wait" || name == "settle") return wait(value, name == "settle");
  if (name == "picture") return then(Next::kStep, take_picture(value));
  if (name == "answer") return then(Next::kStep, print_answer(value, answer));
  if (name == "together") return then(Next::kFrame, run_simultaneously(value));
  if (name == "frame") return then(Next::kStep, assign(value.positive_number(), frame_seconds_));
  if (name == "draws") return then(Next::kStep, assign(value.flag(), draws_));
  return then(Next::kFrame, input_.apply(name, value));
}

Result<EventScript::Next> EventScript::wait(const JsonValue& value, bool until_rest) {
  const auto seconds = value.positive_number();
  if (!seconds) return seconds.error();
  wait_until_ = seconds_ + *seconds;
  until_rest_ = until_rest;
  still_ = 1;
  return Next::kFrame;
}

Status EventScript::run_simultaneously(const JsonValue& steps) {
  if (const Status list = steps.array("steps"); !list) return list;
  for (size_t i = 0; i < steps.json().size(); ++i) {
    const JsonValue step = steps[i];
    if (!step.json().is_object() || step.json().size() != 1)
      return step.wrong("must be an object with one key");
    const std::string name = step.json().begin().key();
    if (const Status status = input_.apply(name, step[name]); !status) return status;
  }
  return Done{};
}

Status EventScript::take_picture(const JsonValue& value) const {
  const auto file = value.text();
  if (!file) return file.error();
  const Vec2 size = input_.size();
  return write_png(read_pixels(0, static_cast<int>(size.x), static_cast<int>(size.y)), *file);
}

Status EventScript::print_answer(const JsonValue& value, const Answer& answer) const {
  const auto what = value.text();
  if (!what) return what.error();
  std::optional<std::string> text = answer(*what);
  // Names of files may hold any bytes.
  if (*what == "title")
    text = nlohmann::json(title_).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (!text) return value.wrong("the current screen has no such answer");
  std::printf("%s\n", text->c_str());
  std::fflush(stdout);
  return Done{};
}

Status VirtualInput::apply(const std::string& name, const JsonValue& value) {
  if (name == "move") return move(value);
  if (name == "press" || name == "release") return hold_button(value, name == "press");
  if (name == "key_down" || name == "key_up") return hold_key(value, name == "key_down");
  if (name == "wheel") return turn_wheel(value);
  if (name == "type") return type(value);
  if (name == "drop") return drop(value);
  if (name == "size") return resize(value);
  if (name == "focus") return focus(value);
  if (name == "close") return close(value);
  return value.wrong("unknown step");
}

int VirtualInput::mods() const {
  int mods = 0;
  for (const Modifier& modifier : kModifiers) mods |= keys_.contains(modifier.key) ? modifier.mod : 0;
  return mods;
}

InputEvent& VirtualInput::put(InputEvent::Kind kind, int button) {
  InputEvent event;
  event.kind = kind;
  event.at = pointer_;
  event.button = event.place = button;
  event.mods = mods();
  return input_state_.events.emplace_back(event);
}

Status VirtualInput::move(const JsonValue& value) {
  const auto at = value.pair();
  if (!at) return at.error();
  pointer_ = {at->low, at->high};
  put(InputEvent::Kind::kMove);
  return Done{};
}

Status VirtualInput::hold_button(const JsonValue& value, bool down) {
  const auto name = value.text();
  if (!name) return name.error();
  const auto button = button_named(*name);
  if (!button) return value.wrong("must be left, right or middle");
  if (down == buttons_.contains(*button)) return Done{};
  if (down) {
    buttons_.insert(*button);
  } else {
    buttons_.erase(*button);
  }
  put(down ? InputEvent::Kind::kPress : InputEvent::Kind::kRelease, *button);
  return Done{};
}

Status VirtualInput::hold_key(const JsonValue& value, bool down) {
  const auto name = value.text();
  if (!name) return name.error();
  const auto key = key_named(*name);
  if (!key) return value.wrong("unknown key \"" + *name + "\"");
  if (down) {
    keys_.insert(*key);
    put(InputEvent::Kind::kKey, *key);
  } else if (keys_.erase(*key) > 0) {
    put(InputEvent::Kind::kKeyUp, *key);
  }
  return Done{};
}

Status VirtualInput::turn_wheel(const JsonValue& value) {
  const auto notches = value.number();
  if (!notches) return notches.error();
  put(InputEvent::Kind::kWheel).wheel = *notches;
  return Done{};
}

Status VirtualInput::type(const JsonValue& value) {
  const auto text = value.text();
  if (!text) return text.error();
  const char* end = text->data() + text->size();
  for (const char* at = text->data(); at < end;) {
    unsigned character = 0;
    at += ImTextCharFromUtf8(&character, at, end);
    put(InputEvent::Kind::kText).character = character;
  }
  return Done{};
}

Status VirtualInput::drop(const JsonValue& value) {
  if (const Status list = value.array("files"); !list) return list;
  std::vector<std::filesystem::path> files;
  for (size_t i = 0; i < value.json().size(); ++i) {
    const auto file = value[i].text();
    if (!file) return file.error();
    files.emplace_back(*file);
  }
  input_state_.drops = std::move(files);
  return Done{};
}

Status VirtualInput::resize(const JsonValue& value) {
  const auto read = value.pair();
  if (!read) return read.error();
  const Vec2 size{read->low, read->high};
  if (!(size.x >= 1 && size.y >= 1 && size.x <= kMaxWindow && size.y <= kMaxWindow))
    return value.wrong("must be from 1 to 8192 pixels");
  size_ = glm::floor(size);
  return Done{};
}

Status VirtualInput::focus(const JsonValue& value) { return assign(value.flag(), focus_); }

Status VirtualInput::close(const JsonValue& value) { return assign(value.flag(), input_state_.close); }

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
  std::vector<InputEvent> events = std::exchange(script_.input().input_state().events, {});
  spread_times(events, script_.seconds() - script_.frame_seconds(), script_.seconds());
  return events;
}

std::vector<std::filesystem::path> ScriptedWindow::take_drops() {
  return std::exchange(script_.input().input_state().drops, {});
}

bool ScriptedWindow::take_close() { return std::exchange(script_.input().input_state().close, false); }

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
