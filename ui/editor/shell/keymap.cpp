#include "ui/editor/shell/keymap.h"

#include "core/base/json.h"
#include "core/document/text/json.h"

namespace kerf {

namespace {

constexpr int kKeymapVersion = 1;
constexpr const char* kKeymapKey = "keymap";
constexpr const char* kBindingsKey = "bindings";

// Returns the first two actions that share a key, as a sentence; empty if there are none.
std::string clash_in(std::span<const UserAction> actions) {
  for (const UserAction& action : actions) {
    const KeyChord chord{action.key, action.mods};
    if (const UserAction* other = clash_of(actions, action, chord))
      return action.shortcut + " is assigned to both \"" + action.name + "\" and \"" + other->name + "\"";
  }
  return "";
}

}  // namespace

Result<std::string> keymap_text(std::span<const UserAction> usual, const Bindings& bindings) {
  nlohmann::ordered_json keys = nlohmann::ordered_json::object();
  for (const UserAction& action : bind_keys({usual.begin(), usual.end()}, bindings)) {
    if (!action.items) keys[action.id] = action.shortcut;
  }
  auto text = dump_json({{kKeymapKey, kKeymapVersion}, {kBindingsKey, std::move(keys)}}, 2);
  if (text) *text += '\n';
  return text;
}

Result<Bindings> parse_keymap(const std::string& text, const std::string& file,
                              std::span<const UserAction> usual) {
  const auto json = parse_json(text, file);
  if (!json) return json.error();
  if (!json->is_object() || json->value(kKeymapKey, nlohmann::json()) != kKeymapVersion)
    return bad_input(file + ": not a keymap of Kerf");
  const nlohmann::json keys = json->value(kBindingsKey, nlohmann::json());
  if (!keys.is_object()) return bad_input(file + ": \"bindings\" is not an object");
  Bindings bindings;
  for (const auto& [id, key] : keys.items()) {
    const UserAction* action = find_action(usual, id);
    if (action == nullptr || action->items) continue;
    const std::string name = key.is_string() ? key.get<std::string>() : key.dump();
    const auto chord = parse_chord(name);
    if (!key.is_string() || (!chord && !name.empty()))
      return bad_input(file + ": unknown key " + name + " of " + id);
    bindings[id] = chord ? chord_text(*chord) : "";
  }
  drop_default_keys(bindings, usual);
  const std::string clash = clash_in(bind_keys({usual.begin(), usual.end()}, bindings));
  return clash.empty() ? Result<Bindings>(std::move(bindings)) : bad_input(file + ": " + clash);
}

}  // namespace kerf
