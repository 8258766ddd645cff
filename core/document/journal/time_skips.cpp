#include "core/document/journal/time_skips.h"

#include <algorithm>
#include <optional>

#include "core/document/history/document.h"

namespace kerf {

namespace {

bool moves_bodies(const Command& command) {
  const auto* advance = std::get_if<AdvanceTime>(&command);
  return advance != nullptr && advance->bodies;
}

// Whether a command may be a part of a run after its first one.
bool goes_on(const Command& command) {
  return moves_bodies(command) || std::holds_alternative<DragBody>(command) ||
         std::holds_alternative<ReleaseBody>(command);
}

// Whether the beam is on after a command.
bool is_beam_on(const Command& command, bool before) {
  if (std::holds_alternative<BeginStroke>(command)) return true;
  const bool stays =
      std::holds_alternative<MoveBeam>(command) || std::holds_alternative<AdvanceTime>(command) ||
      std::holds_alternative<DragBody>(command) || std::holds_alternative<ReleaseBody>(command);
  return before && stays;
}

// Where the run ends that begins with a command.
size_t end_of_run(const std::vector<Command>& commands, size_t first) {
  size_t end = first + 1;
  while (end < commands.size() && goes_on(commands[end])) ++end;
  return end;
}

// The last mark after `first` commands from which bodies go on to the bit.
std::optional<size_t> last_mark(const Journal& journal, size_t first, size_t end) {
  std::optional<size_t> last;
  for (size_t i = 0; i < journal.marks.size() && journal.marks[i].commands <= end; ++i) {
    const StateMark& mark = journal.marks[i];
    const bool whole_minute = mark.clock > 0 && mark.clock % Execution::kTicksToForget == 0;
    if (mark.commands > first && !mark.bodies.empty() && (mark.commands == end || whole_minute)) last = i;
  }
  return last;
}

Ticks ticks_of(const std::vector<Command>& commands, size_t first, size_t end) {
  Ticks ticks = 0;
  for (size_t i = first; i < end; ++i) {
    if (const auto* advance = std::get_if<AdvanceTime>(&commands[i])) ticks += advance->ticks;
  }
  return ticks;
}

}  // namespace

std::vector<TimeSkip> time_skips(const Journal& journal, Ticks least) {
  std::vector<TimeSkip> skips;
  bool beam = false;
  for (size_t i = 0; i < journal.commands.size();) {
    const Command& command = journal.commands[i];
    beam = is_beam_on(command, beam);
    const bool begins = !beam && (std::holds_alternative<Play>(command) || goes_on(command));
    const size_t end = begins ? end_of_run(journal.commands, i) : i + 1;
    const std::optional<size_t> mark = begins ? last_mark(journal, i, end) : std::nullopt;
    const Ticks ticks = mark ? ticks_of(journal.commands, i, journal.marks[*mark].commands) : 0;
    if (mark && ticks >= std::max<Ticks>(least, 1)) skips.push_back({i, *mark, ticks});
    i = end;
  }
  return skips;
}

}  // namespace kerf
