#pragma once

#include <span>
#include <vector>

#include "core/document/commands.h"

namespace kerf {

// Appends an AdvanceTime to the commands of one history step. It is merged with the AdvanceTime commands at
// the end of the list, from index `first` on, so that each but the last of them fills a line of a journal
// (AdvanceTime::kMaxInALine).
void append_ticks(std::vector<Command>& commands, const AdvanceTime& advance, size_t first = 0);

// The commands applied to a document, in order, as its journal stores them. Consecutive AdvanceTime
// commands of one kind in one history step are merged, up to a second each, so that a journal written while
// time passes is never more than a second behind.
class CommandLog {
 public:
  const std::vector<Command>& commands() const { return commands_; }
  size_t size() const { return commands_.size(); }

  void append(const Command& command);
  // Removes all but the first `size` commands. Precondition: size <= size().
  void shrink(size_t size);

  // The number of final commands: all, or all but the last if that is an AdvanceTime that may still grow.
  size_t final_size() const;
  // Makes all commands final: later ticks start a new AdvanceTime.
  void seal() { sealed_ = commands_.size(); }

 private:
  std::vector<Command> commands_;
  size_t sealed_ = 0;
};

// Finds the commands of a journal whose effect lasts to its end: those of history steps that are not undone
// and, for strokes, not replaced by a recut. Undo and Redo do not count; for a step that was redone, its
// original commands do. Returns one flag per command. Exact for the journal of a Document, which contains
// only commands with an effect; commands in an edited file are assumed to have one. Linear time.
std::vector<bool> lasting_commands(std::span<const Command> journal);

}  // namespace kerf
