#include "ui/window/virtual_input.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <optional>

#include "ui/window/key_chord.h"

namespace kerf {

namespace {

constexpr double kLargestWindow = 8192;  // pixels

// A modifier: its name, the key that is held and what other events carry meanwhile.
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

}  // namespace

Status VirtualInput::hear(const std::string& name, const JsonValue& value) {
  if (name == "move") return move(value);
  if (name == "press" || name == "release") return hold_button(value, name == "press");
  if (name == "key_down" || name == "key_up") return hold_key(value, name == "key_down");
  if (name == "wheel") return turn_wheel(value);
  if (name == "type") return type(value);
  if (name == "drop") return drop(value);
  if (name == "size") return resize(value);
  if (name == "focus") return focus(value);
  if (name == "close") return close(value);
  return value.wrong("there is no such step");
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
  event.button = button;
  event.mods = mods();
  return heard_.events.emplace_back(event);
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
  if (!key) return value.wrong("there is no key \"" + *name + "\"");
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
  heard_.drops = std::move(files);
  return Done{};
}

Status VirtualInput::resize(const JsonValue& value) {
  const auto read = value.pair();
  if (!read) return read.error();
  const Vec2 size{read->low, read->high};
  if (!(size.x >= 1 && size.y >= 1 && size.x <= kLargestWindow && size.y <= kLargestWindow))
    return value.wrong("must be from 1 to 8192 pixels");
  size_ = glm::floor(size);
  return Done{};
}

Status VirtualInput::focus(const JsonValue& value) { return assign(value.flag(), focus_); }

Status VirtualInput::close(const JsonValue& value) { return assign(value.flag(), heard_.close); }

}  // namespace kerf
