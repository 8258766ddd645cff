#include "core/document/command_log.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/document/undo_stack.h"

namespace kerf {

void append_ticks(std::vector<Command>& commands, const AdvanceTime& advance, size_t first) {
  Ticks left = advance.ticks;
  if (commands.size() > first) {
    auto* last = std::get_if<AdvanceTime>(&commands.back());
    if (last && last->bodies == advance.bodies && last->joins == advance.joins) {
      const Ticks taken = std::min(left, AdvanceTime::kMaxInALine - last->ticks);
      last->ticks += taken;
      left -= taken;
    }
  }
  for (; left > 0; left -= std::min(left, AdvanceTime::kMaxInALine))
    commands.emplace_back(
        AdvanceTime{std::min(left, AdvanceTime::kMaxInALine), advance.bodies, advance.joins});
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
  return commands_.size() - (last && last->ticks < AdvanceTime::kMaxInALine ? 1 : 0);
}

namespace {

// The steps of a history (see HistoryStep), each with the indices of its commands.
class Timeline {
 public:
  void take(size_t number, const Command& command) {
    if (std::holds_alternative<Undo>(command)) {
      position_ -= position_ > 0;
    } else if (std::holds_alternative<Redo>(command)) {
      position_ += position_ < steps_.size();
    } else if (const auto kind = history_step_kind(command, last())) {
      steps_.resize(position_, Step{});
      steps_.push_back({*kind, {number}});
      ++position_;
    } else if (position_ > 0) {
      const bool is_time = history_step_kind(command, std::nullopt).has_value();
      if (is_time) steps_.resize(position_, Step{});
      steps_[position_ - 1].commands.push_back(number);
    }
  }

  void mark(std::vector<bool>& lasting) const {
    for (size_t i = 0; i < position_; ++i) {
      if (i + 1 < position_ && steps_[i + 1].kind == Kind::kRecut) continue;
      for (const size_t command : steps_[i].commands) lasting[command] = true;
    }
  }

 private:
  using Kind = HistoryStep::Kind;
  struct Step {
    Kind kind;
    std::vector<size_t> commands;
  };

  std::optional<Kind> last() const {
    return position_ > 0 ? std::optional(steps_[position_ - 1].kind) : std::nullopt;
  }

  std::vector<Step> steps_;
  size_t position_ = 0;
};

}  // namespace

std::vector<bool> lasting_commands(std::span<const Command> journal) {
  Timeline timeline;
  for (size_t i = 0; i < journal.size(); ++i) timeline.take(i, journal[i]);
  std::vector<bool> lasting(journal.size());
  timeline.mark(lasting);
  return lasting;
}

}  // namespace kerf
