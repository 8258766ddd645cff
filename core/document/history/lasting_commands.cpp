#include "core/document/history/lasting_commands.h"

#include "core/document/history/history_step.h"

namespace kerf {

namespace {

// The steps of a history (see HistoryStep), each with the numbers of its commands.
class Timeline {
 public:
  void take(size_t number, const Command& command) {
    if (std::holds_alternative<Undo>(command)) {
      position_ -= position_ > 0;
    } else if (std::holds_alternative<Redo>(command)) {
      position_ += position_ < steps_.size();
    } else if (const auto kind = begun_by(command, last())) {
      steps_.resize(position_, Step{});
      steps_.push_back({*kind, {number}});
      ++position_;
    } else if (position_ > 0) {
      const bool is_time = begun_by(command, std::nullopt).has_value();
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
