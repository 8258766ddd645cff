#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/document/commands.h"
#include "core/document/journal.h"
#include "core/document/text/json.h"

namespace kerf {

// A command as one line of a journal, without the line's end: {"do": "move-beam", "origin": [..],
// "direction":
// [..]}. Numbers are exact. `folder` is the folder of the journal; mesh files are named as path_text does.
// Bad input where a name or a path is not UTF-8.
Result<std::string> command_text(const Command& command, const std::filesystem::path& folder);

// Reads that line. `beam` says where the beam of the last stroke is, if there was one: a move must not turn
// it straight round. Numbers come back to the bit. Numbers out of range, keys that are missing and keys that
// the command does not have are bad input with a JSON pointer.
Result<Command> parse_command(const JsonValue& value, const std::filesystem::path& folder,
                              const std::optional<BeamAt>& beam);

class Fields;

// A mark of a journal. Where bodies have moved it has "machine", "clock" and
//   "bodies": [{"body": [slot, generation], "position", "orientation", "velocity", "spin", "quiet",
//   "asleep"}] "pairs": [[slot, generation, slot, generation, touching, crossed]], without the second body
//   for the ground:
//     1 where the two touch, and for how many ticks they have intersected. They are read back sorted.
// Numbers come back to the bit.
void describe(Fields& f, StateMark& mark);

}  // namespace kerf
