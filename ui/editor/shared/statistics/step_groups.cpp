#include "ui/editor/shared/statistics/step_groups.h"

#include <algorithm>
#include <variant>

namespace kerf {

// Any command other than Undo and Redo may replace the steps that were undone when it was applied. After one,
// `position` is the least that the position of the history can be.
void StepGroups::follow(const Document& document) {
  const std::vector<Command>& journal = document.journal();
  size_t position = position_, kept = document.history().size();
  if (journal.size() < commands_) kept = std::min(kept, document.history().position());
  for (size_t i = std::min(commands_, journal.size()); i < journal.size(); ++i) {
    if (std::holds_alternative<Undo>(journal[i])) {
      position -= std::min<size_t>(position, 1);
    } else if (std::holds_alternative<Redo>(journal[i])) {
      ++position;
    } else {
      kept = std::min(kept, position);
    }
  }
  std::erase_if(groups_, [&](const Group& group) { return group.to > kept; });
  position_ = document.history().position();
  commands_ = journal.size();
}

void StepGroups::add(size_t from, const Document& document, std::string name, bool is_one_row) {
  follow(document);
  const size_t to = document.history().position();
  if (to > from + 1) groups_.push_back({from, to, std::move(name), is_one_row});
}

bool StepGroups::has_row(size_t position) const {
  return std::none_of(groups_.begin(), groups_.end(),
                      [&](const Group& g) { return g.is_one_row && g.from < position && position < g.to; });
}

const StepGroups::Group* StepGroups::at(const Document& document, bool back) const {
  const size_t position = document.history().position();
  const auto group = std::find_if(groups_.begin(), groups_.end(),
                                  [&](const Group& g) { return position == (back ? g.to : g.from); });
  return group != groups_.end() ? &*group : nullptr;
}

}  // namespace kerf
