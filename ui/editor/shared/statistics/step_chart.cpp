#include "ui/editor/shared/statistics/step_chart.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace kerf {

void StepChart::note_step(const StepResult& step) {
  const StepStatistics& f = step.statistics;
  const bool cuts = step.moves > 0 || !step.delta.bodies.empty() || f.separate_s > 0;
  if (!cuts) return;  // only time passed
  size_t born = 0, gone = 0;
  for (const BodyDelta& body : step.delta.bodies) {
    born += body.born.size();
    gone += body.gone.size();
  }
  const std::array<std::pair<Line, double>, 7> now{{{kFind, 1e3 * f.query_s},
                                                    {kRefine, 1e3 * f.refine_s},
                                                    {kRemove, 1e3 * f.remove_s},
                                                    {kTree, 1e3 * f.update_tree_s},
                                                    {kSeparate, 1e3 * f.separate_s},
                                                    {kBorn, static_cast<double>(born)},
                                                    {kGone, static_cast<double>(gone)}}};
  for (const auto& [line, value] : now) add(line, value);
}

void StepChart::note_sent(size_t bytes) { add(kSent, static_cast<double>(bytes) / 1024); }

float StepChart::largest(Line line) const {
  const auto& values = lines_[line];
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

void StepChart::add(Line line, double value) {
  std::vector<float>& values = lines_[line];
  if (values.size() == kKept) values.erase(values.begin());
  values.push_back(static_cast<float>(value));
}

size_t process_bytes() {
  std::ifstream file("/proc/self/statm");
  size_t all = 0, resident = 0;
  if (!(file >> all >> resident)) return 0;
  return resident * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace kerf
