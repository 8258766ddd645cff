#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/shadow/shadow_volume.h"
#include "ui/editor/shared/viewport.h"
#include "ui/screen/live_picture.h"
#include "ui/window/layout.h"

namespace kerf {

// A shadow method as people are told of it.
struct MethodWords {
  ShadowMethod method;
  const char* name;
  const char* meaning;
};
std::span<const MethodWords> shadow_methods();

const char* method_name(ShadowMethod method);

// What the colours of a view mean.
struct Legend {
  struct Row {
    uint32_t colour = 0;  // 0xrrggbb
    std::string meaning;
    bool swatch = true;   // false: a sentence alone
    bool dotted = false;  // as the lines of the view are
  };
  std::string title;
  std::vector<Row> rows;
};

// The legends of all views with colours that are switched on, in the order of view_switches().
std::vector<Legend> legends_of(const ViewOptions& look, const ShadowStatistics& shadows);

// Draws the legends one below the other, from the upper left corner of a picture downward, each as long as
// there is room. Returns the area that they take.
Area draw_legends(const std::vector<Legend>& legends, const Area& picture);

}  // namespace kerf
