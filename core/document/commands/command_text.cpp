#include "core/document/commands/command_text.h"

#include "core/base/unit_vector.h"
#include "core/document/text/fields.h"
#include "core/document/text/json_text.h"
#include "core/document/text/nearest_name.h"

namespace kerf {

namespace {

// A move goes on from where the beam is, if it is anywhere.
void check_follows(Fields& f, const MoveBeam& move, const std::optional<BeamAt>& beam) {
  const BeamAt before = beam.value_or(BeamAt{move.pose, 0});
  f.check(!are_opposite(before.pose.direction, move.pose.direction), "direction",
          "is opposite to the one before");
  f.check(!f.present("t", false) || move.time >= before.time, "t", "must not be before the pose before");
}

// The fields of a command with its name, which was read.
template <typename C>
void fields_of(Fields& f, C& command, const std::optional<BeamAt>& beam) {
  std::string name = C::kName;
  f.text("do", name);
  if constexpr (!std::is_empty_v<C>) describe(f, command);
  if constexpr (std::is_same_v<C, MoveBeam>) check_follows(f, command, beam);
  f.end();
}

template <typename C>
Result<Command> read_command(const JsonValue& line, const std::filesystem::path& folder,
                             const std::optional<BeamAt>& beam) {
  C command;
  Fields::Pass pass{folder};
  Fields fields(line, pass);
  fields_of(fields, command, beam);
  if (!pass.status) return pass.status.error();
  return Command(std::move(command));
}

// The reader of the kind of command with this name; null where no kind of the variant has it.
template <typename... Kinds>
auto reader_of(std::variant<Kinds...>*, const std::string& name) {
  decltype(&read_command<Undo>) found = nullptr;
  ((name == Kinds::kName ? void(found = read_command<Kinds>) : void()), ...);
  return found;
}

template <typename... Kinds>
std::vector<std::string> names_of(std::variant<Kinds...>*) {
  return {Kinds::kName...};
}

}  // namespace

Result<std::string> command_text(const Command& command, const std::filesystem::path& folder) {
  return std::visit(
      [&](auto c) {
        return exact_text(visited_json(folder, [&](Fields& f) { fields_of(f, c, std::nullopt); }));
      },
      command);
}

Result<Command> parse_command(const JsonValue& value, const std::filesystem::path& folder,
                              const std::optional<BeamAt>& beam) {
  if (!value.has("do")) return value.wrong("needs \"do\"");
  const auto name = value["do"].text();
  if (!name) return name.error();
  const auto read = reader_of(static_cast<Command*>(nullptr), *name);
  if (read == nullptr)
    return value["do"].wrong("\"" + *name + "\" is no command that this version has" +
                             nearest_name_hint(*name, names_of(static_cast<Command*>(nullptr))));
  return read(value, folder, beam);
}

}  // namespace kerf
