#include "core/document/drawing_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/assert.h"
#include "core/document/job_files.h"
#include "core/document/text/fields.h"

namespace kerf {

namespace {

const LayerSettings* settings_of(const LayerTable& table, const DrawnLine& line) {
  const auto found = table.layers.find(line.layer);
  return found == table.layers.end() ? nullptr : &found->second;
}

}  // namespace

static void describe(Fields& f, LayerSettings& layer) {
  constexpr NumberRange kSpeed{1e-9, 1e6, "m/s"};
  constexpr uint64_t kMaxOrder = 1000;
  f.number("radius", layer.radius, kPositive);
  f.number("speed", layer.speed, kSpeed);
  f.number("power", layer.power, kPositive);
  f.whole("order", layer.order, 0, kMaxOrder, uint64_t{0});
  f.flag("skip", layer.skip, false);
}

static void describe(Fields& f, LayerTable& table) { f.by_name("layers", table.layers); }

Result<LayerTable> read_layers(const std::filesystem::path& file) { return read_described<LayerTable>(file); }

void arrange_layers(const LayerTable& table, std::vector<DrawnLine>& lines, std::vector<std::string>& notes) {
  std::set<std::string> drawn;
  for (const DrawnLine& line : lines) drawn.insert(line.layer);
  for (const auto& [name, settings] : table.layers) {
    if (!drawn.contains(name)) notes.push_back("no line has the layer or colour \"" + name + "\"");
  }
  const auto order = [&](const DrawnLine& line) {
    const LayerSettings* const settings = settings_of(table, line);
    return settings ? settings->order : 0;
  };
  std::erase_if(lines, [&](const DrawnLine& line) {
    const LayerSettings* const settings = settings_of(table, line);
    return settings && settings->skip;
  });
  std::ranges::stable_sort(lines, {}, order);
}

void set_lasers(const LayerTable& table, std::span<const DrawnLine> lines, std::span<StrokePath> strokes) {
  KERF_ASSERT(lines.size() == strokes.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    const LayerSettings* const settings = settings_of(table, lines[i]);
    if (!settings) continue;
    if (settings->radius) strokes[i].radius = settings->radius;
    if (settings->power) strokes[i].power = settings->power;
    if (!settings->speed) continue;
    // Rounding must not make the times of two keys equal.
    double before = std::numeric_limits<double>::lowest();
    for (double& time : strokes[i].times) {
      time = std::max(time * (kDrawingSpeed / *settings->speed),
                      std::nextafter(before, std::numeric_limits<double>::max()));
      before = time;
    }
  }
}

}  // namespace kerf
