#pragma once

#include <span>
#include <vector>

#include "core/document/commands/command.h"

namespace kerf {

// Which commands of a journal have an effect that lasts to its end: those of the steps of the history that
// are neither undone nor, being a stroke, replaced by a recut. Undo and redo themselves do not count, and of
// a step that was undone and done again the commands that did it first do. Returns one flag per command.
// Exact for the commands of a Document's journal, each of which did something; others, as a changed file may
// hold them, are taken to have done something, too. Linear time.
std::vector<bool> lasting_commands(std::span<const Command> journal);

}  // namespace kerf
