#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/document/command.h"
#include "core/document/json_value.h"

namespace kerf {

// A command as one line of a journal, without the line's end: {"do": "move", "origin": [..], "direction":
// [..]}. Numbers are exact. `folder` is the journal's; mesh files are named as path_text does. Bad input
// where a name or a path is not UTF-8.
Result<std::string> command_text(const Command& command, const std::filesystem::path& folder);

// Takes that line. `last` is where the beam of a running stroke stands, which a move must not turn straight
// round from. Numbers come back to the bit, out-of-range ones and keys that a command does not have are bad
// input with a JSON pointer.
Result<Command> parse_command(const JsonValue& value, const std::filesystem::path& folder,
                              const std::optional<Pose>& last);

}  // namespace kerf
