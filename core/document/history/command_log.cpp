#include "core/document/history/command_log.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

void append_ticks(std::vector<Command>& commands, const AdvanceTime& advance, size_t first) {
  Ticks left = advance.ticks;
  if (commands.size() > first) {
    auto* last = std::get_if<AdvanceTime>(&commands.back());
    if (last && last->bodies == advance.bodies && last->joins == advance.joins) {
      const Ticks taken = std::min(left, AdvanceTime::kMostInALine - last->ticks);
      last->ticks += taken;
      left -= taken;
    }
  }
  for (; left > 0; left -= std::min(left, AdvanceTime::kMostInALine))
    commands.emplace_back(
        AdvanceTime{std::min(left, AdvanceTime::kMostInALine), advance.bodies, advance.joins});
}

void CommandLog::append(const Command& command) {
  if (const auto* advance = std::get_if<AdvanceTime>(&command)) {
    append_ticks(commands_, *advance, sealed_);
  } else {
    commands_.push_back(command);
  }
}

void CommandLog::shrink(size_t size) {
  KERF_ASSERT(size <= commands_.size());
  commands_.erase(commands_.begin() + static_cast<std::ptrdiff_t>(size), commands_.end());
  sealed_ = std::min(sealed_, size);
}

size_t CommandLog::final_size() const {
  if (commands_.size() <= sealed_) return commands_.size();
  const auto* last = std::get_if<AdvanceTime>(&commands_.back());
  return commands_.size() - (last && last->ticks < AdvanceTime::kMostInALine ? 1 : 0);
}

}  // namespace kerf
