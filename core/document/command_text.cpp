#include "core/document/command_text.h"

#include <algorithm>

namespace kerf {

namespace {

template <typename C>
Status check_keys(const JsonValue& line) {
  const auto is_key = [](const std::string& key) {
    const auto same = [&](const char* k) { return key == k; };
    return key == "do" || std::any_of(C::kKeys.begin(), C::kKeys.end(), same) ||
           std::any_of(C::kOptionalKeys.begin(), C::kOptionalKeys.end(), same);
  };
  for (const char* key : C::kKeys) {
    if (!line.has(key)) return line.wrong(std::string("needs \"") + key + "\"");
  }
  for (const auto& item : line.json().items()) {
    if (!is_key(item.key()))
      return line[item.key()].wrong(std::string("\"") + C::kName + "\" has no such key");
  }
  return Done{};
}

template <typename C>
Result<Command> read_command(const JsonValue& line, const CommandReader& reader) {
  if (const auto keys = check_keys<C>(line); !keys) return keys.error();
  Result<C> command = C::read(reader);
  if (!command) return command.error();
  return Command(std::move(*command));
}

// The command of the kind with this name; none where no kind of the variant has it.
template <typename... Kinds>
std::optional<Result<Command>> read_named(std::variant<Kinds...>*, const std::string& name,
                                          const JsonValue& line, const CommandReader& reader) {
  std::optional<Result<Command>> found;
  const auto try_kind = [&]<typename C>(std::type_identity<C>) {
    if (name == C::kName) found = read_command<C>(line, reader);
  };
  (try_kind(std::type_identity<Kinds>()), ...);
  return found;
}

}  // namespace

Result<std::string> command_text(const Command& command, const std::filesystem::path& folder) {
  return std::visit(
      [&](const auto& c) {
        CommandWriter line(c.kName, folder);
        c.write(line);
        return line.end();
      },
      command);
}

Result<Command> parse_command(const JsonValue& value, const std::filesystem::path& folder,
                              const std::optional<BeamAt>& beam) {
  if (!value.has("do")) return value.wrong("needs \"do\"");
  const auto name = value["do"].text();
  if (!name) return name.error();
  const CommandReader reader(value, folder, beam);
  auto found = read_named(static_cast<Command*>(nullptr), *name, value, reader);
  if (!found) return value["do"].wrong("is no command that this version has");
  return std::move(*found);
}

}  // namespace kerf
