#include "app/cut_summary.h"

#include <cmath>

#include "core/base/count_text.h"
#include "ui/window/number_text.h"

namespace kerf {

std::string cut_summary(const CutJob& job, size_t strokes, size_t pieces, const std::string& folder) {
  const auto count = [](size_t number, const char* noun) {
    return grouped(number) + " " + noun + (number == 1 ? "" : "s");
  };
  std::string text;
  if (strokes == 0) {
    text = "nothing was cut, because there is no stroke";
  } else if (job.removed_faces == 0 && job.thermal && job.statistics.met_s > 0) {
    text = count(strokes, "stroke") + " removed nothing, because the beam got through " +
           std::to_string(std::lround(100 * job.depth_fraction())) + " % of the thickness";
  } else if (job.removed_faces == 0) {
    text = count(strokes, "stroke") + " met nothing";
  } else {
    text = count(strokes, "stroke") + " removed " + count(job.removed_faces, "face") + " (" +
           area_text(job.removed_area) + ")";
  }
  return text + "; " + count(pieces, "piece") + " and report.json are in " + folder;
}

std::string missed_text(const CutJob& job, const std::string& file) {
  constexpr size_t kMostNamed = 8;
  const size_t count = job.missed.size(), named = count > kMostNamed ? kMostNamed - 1 : count;
  std::string text = file + ": ";
  for (size_t i = 0; i < named; ++i) {
    if (i > 0) text += i + 1 == count ? " and " : ", ";
    text += "/strokes/" + std::to_string(job.missed[i]);
  }
  if (named < count) text += " and " + std::to_string(count - named) + " more";
  return text + " met nothing: no mesh is where the beam goes";
}

}  // namespace kerf
