#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/shadow/shadow_volume.h"
#include "ui/editor/shared/viewport.h"
#include "ui/screen/live_picture.h"
#include "ui/window/layout.h"

namespace kerf {

struct Legend {
  struct Row {
    uint32_t colour = 0;  // 0xrrggbb
    std::string meaning;
    bool swatch = true;  // false: text only
  };
  std::string title;
  std::vector<Row> rows;
};

// Returns the legends of all enabled views with colours, in the order of view_switches().
std::vector<Legend> legends_of(const ViewOptions& look, const ShadowStatistics& shadows);

// Returns the scale of the temperature view, from the ambient to `hottest` [K], the largest first.
// Precondition: `hottest` is above the ambient.
Legend legend_of_heat(double hottest);

// Draws the legends below each other from the upper left corner of a viewport, as many as fit. Returns the
// covered area.
Area draw_legends(const std::vector<Legend>& legends, const Area& picture);

}  // namespace kerf
