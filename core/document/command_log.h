#pragma once

#include <span>
#include <vector>

#include "core/document/commands.h"

namespace kerf {

// Appends an AdvanceTime to commands of one step of the history. It is merged with the AdvanceTime commands
// at the end of the list, from number `first` on, so that each but the last of them is a whole line of a
// journal (AdvanceTime::kMaxInALine).
void append_ticks(std::vector<Command>& commands, const AdvanceTime& advance, size_t first = 0);

// The commands that were applied to a document, in their order, as its journal holds them. Consecutive
// Advance commands of one kind belong to one step of the history and are merged, a second at most to each, so
// that whoever writes the journal down while time passes is never more than a second behind.
class CommandLog {
 public:
  const std::vector<Command>& commands() const { return commands_; }
  size_t size() const { return commands_.size(); }

  void append(const Command& command);
  // Removes all but the first `size` commands. Precondition: size <= size().
  void shrink(size_t size);

  // How many of the commands are final: all, or all but the last, which is time that may grow.
  size_t final_size() const;
  // Makes all of them final: time that passes from here on is a command of its own.
  void seal() { sealed_ = commands_.size(); }

 private:
  std::vector<Command> commands_;
  size_t sealed_ = 0;
};

// Which commands of a journal have an effect that lasts to its end: those of the steps of the history that
// are neither undone nor, being a stroke, replaced by a recut. Undo and redo themselves do not count, and of
// a step that was undone and done again the commands that did it first do. Returns one flag per command.
// Exact for the commands of a Document's journal, each of which did something; others, as a changed file may
// hold them, are taken to have done something, too. Linear time.
std::vector<bool> lasting_commands(std::span<const Command> journal);

}  // namespace kerf
