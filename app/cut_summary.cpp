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

}  // namespace kerf
