#pragma once

#include <map>
#include <span>
#include <string>

#include "ui/editor/shared/user_input.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shell/catalogue.h"

namespace kerf {

// An item of the header: an option of a feature, or an action as a button with this label.
struct HeaderItem {
  const char* id;
  const char* label = nullptr;  // null: an option
};

// The items of a tool, from left to right, the most important ones first.
struct HeaderLayout {
  const char* tool;
  std::vector<HeaderItem> items;
};
std::span<const HeaderLayout> header_layout();

// The header of the viewport: one line with the icon, the name and the options of the active tool.
class ToolHeader {
 public:
  // Collects the options of the features, which must outlive it.
  void gather(const Features& features);
  // Draws the header over the upper left corner of the viewport and returns the area that it covers.
  // Landmarks have the prefix "header ". Items that do not fit are omitted. Draws nothing in a split or small
  // viewport.
  Area draw(const Layout& layout, const std::string& tool, std::span<const UserAction> actions) const;

 private:
  void draw_items(const HeaderLayout& header, float right, std::span<const UserAction> actions) const;
  std::map<std::string, ToolOption> options_;  // by their ids
};

}  // namespace kerf
