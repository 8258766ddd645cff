#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/document/commands.h"
#include "core/document/journal.h"
#include "core/document/text/json.h"

namespace kerf {

// Returns a command as one line of a journal, without the line break: {"do": "move-beam", "origin": [..],
// "direction": [..]}. Numbers are exact. `folder` is the folder of the journal; mesh files are named as in
// path_text. Bad input if a name or a path is not UTF-8.
Result<std::string> command_text(const Command& command, const std::filesystem::path& folder);

// Parses such a line; numbers are restored to the bit. `beam` is the beam of the last stroke, if any: a
// move must not reverse its direction. Numbers out of range, missing keys and unknown keys are bad input
// with a JSON pointer.
Result<Command> parse_command(const JsonValue& value, const std::filesystem::path& folder,
                              const std::optional<BeamAt>& beam);

class Fields;

// A mark of a journal. If bodies have moved it has "machine", "clock" and
//   "bodies": [{"body": [slot, generation], "position", "orientation", "velocity", "spin", "quiet",
//              "asleep"}],
//   "pairs": [[slot, generation, slot, generation, touching, crossed]], without the second body for the
//            ground: 1 if the two touch, and for how many ticks they have intersected. Read sorted.
// Numbers are restored to the bit.
void describe(Fields& f, StateMark& mark);

}  // namespace kerf
