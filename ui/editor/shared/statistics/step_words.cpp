#include "ui/editor/shared/statistics/step_words.h"

#include <algorithm>
#include <vector>

#include "core/base/assert.h"
#include "core/document/commands/command_words.h"
#include "core/mesh/files/length_label.h"

namespace kerf {

namespace {

constexpr size_t kMostNames = 2;

// What the beam took most from comes first.
std::string names_of(const HistoryStep& step) {
  std::vector<std::pair<std::string, size_t>> names(step.cut_names().begin(), step.cut_names().end());
  if (names.empty()) return step.done() ? "nothing, " : "";
  std::stable_sort(names.begin(), names.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (size_t i = 0; i < std::min(names.size(), kMostNames); ++i) text += names[i].first + ", ";
  if (names.size() > kMostNames) text += std::to_string(names.size() - kMostNames) + " more, ";
  return text;
}

std::string how(const CutSettings& settings, FileUnit unit) {
  return "radius " + length_label(settings.laser.radius, unit) +
         (settings.laser.pattern == Pattern::kRays4 ? ", four rays" : "");
}

std::string how_again(const Resolution& resolution, FileUnit unit) {
  switch (resolution.rule) {
    case Resolution::Rule::kTargetEdge:
      return "edges of " + length_label(resolution.target_edge, unit);
    case Resolution::Rule::kTolerance:
      return "within " + length_label(resolution.tolerance, unit);
    case Resolution::Rule::kDepth:
      return std::to_string(resolution.depth) + (resolution.depth == 1 ? " level" : " levels");
  }
  return "";
}

// The number of the stroke among all of the history, from 1.
size_t number_of(const History& history, size_t stroke) {
  size_t number = 0;
  for (size_t i = 0; i <= stroke; ++i) number += history.step(i).kind() == HistoryStep::Kind::kStroke;
  return number;
}

}  // namespace

std::string step_words(const History& history, size_t step, FileUnit unit) {
  KERF_ASSERT(step < history.size());
  const HistoryStep& of = history.step(step);
  if (!history.cuts(step)) return words(of.commands().front(), unit, of.piece_name);
  const std::string cut = "Cut " + std::to_string(number_of(history, history.base_of(step)));
  const CutSettings& settings = history.settings_of(step);
  if (of.kind() == HistoryStep::Kind::kStroke) return cut + ": " + names_of(of) + how(settings, unit);
  return cut + " again: " + names_of(of) + how_again(settings.resolution, unit);
}

}  // namespace kerf
