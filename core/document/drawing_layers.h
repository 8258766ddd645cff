#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/stroke_path.h"
#include "core/laser/drawing.h"

namespace kerf {

// How the lines of a layer of a drawing are cut.
struct LayerSettings {
  std::optional<double> radius;  // of the beam, m
  std::optional<double> speed;   // of the beam, m/s
  std::optional<double> power;   // W
  int64_t order = 0;             // layers with lower numbers come first, in 0 .. 1000
  bool skip = false;             // the lines are left out
};

// Settings by the name of a layer of DXF or the colour of a stroke of SVG (see DrawnLine::layer):
//
//   {"layers": {"HOLES": {"radius": 0.0001, "speed": 0.02, "power": 2000, "order": 1},
//               "#ff0000": {"skip": true}}}
//
// All keys of a layer are optional. Lines of other layers have the order 0.
struct LayerTable {
  std::map<std::string, LayerSettings> layers;
};

// Reads a file; fails with bad input that names the first wrong key.
Result<LayerTable> read_layers(const std::filesystem::path& file);

// Removes the lines of skipped layers and sorts the others by the order of their layers, else in their order.
// Appends a note for each layer of the table that has no lines. O(n log n).
void arrange_layers(const LayerTable& table, std::vector<DrawnLine>& lines, std::vector<std::string>& notes);

// Gives strokes the radius, the power and the speed of the layers of the lines that they were made from, one
// each, at kDrawingSpeed (see drawing_strokes()).
void set_lasers(const LayerTable& table, std::span<const DrawnLine> lines, std::span<StrokePath> strokes);

}  // namespace kerf
