#include "core/document/history/lasting_commands.h"

#include "core/document/history/history_step.h"

namespace kerf {

namespace {

// The steps of a history (see HistoryStep), each with the numbers of its commands.
class Timeline {
 public:
  void take(size_t command, const Command& c) {
    std::visit(Overloaded{
                   [&](const BeginStroke&) { begin(Kind::kStroke, command); },
                   [&](const MoveStroke&) { append(command); },
                   [&](const EndStroke&) { append(command); },
                   [&](const StopStroke&) { append(command); },
                   [&](const Recut&) { begin(Kind::kRecut, command); },
                   [&](const HappensInTime auto&) { pass_time(command, c); },
                   [&](const Play&) { begin(Kind::kTime, command); },
                   [&](const HappensAtOnce auto&) { begin(Kind::kEdit, command); },
                   [&](const Undo&) { position_ -= position_ > 0; },
                   [&](const Redo&) { position_ += position_ < steps_.size(); },
               },
               c);
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

  void begin(Kind kind, size_t command) {
    steps_.resize(position_, Step{});
    steps_.push_back({kind, {command}});
    ++position_;
  }
  void append(size_t command) {
    if (position_ > 0) steps_[position_ - 1].commands.push_back(command);
  }
  void pass_time(size_t command, const Command& c) {
    if (position_ == 0 || !belongs_to(steps_[position_ - 1].kind, c)) return begin(Kind::kTime, command);
    steps_.resize(position_, Step{});
    append(command);
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
