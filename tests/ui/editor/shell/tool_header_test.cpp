#include "ui/editor/shell/tool_header.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <set>

#include "tests/support/editor_features.h"

namespace kerf {
namespace {

// The header over viewports of several sizes, as landmarks.
class Header : public testing::Test {
 protected:
  Header() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {2000, 1000};
    io.Fonts->Build();
    keep_landmarks(&landmarks);
    header.gather(editor.features);
  }
  ~Header() override { ImGui::DestroyContext(); }

  Area draw(const std::string& tool, Vec2 viewport, double second = 0) {
    Layout layout;
    layout.viewport = layout.first = {{0, 26}, viewport};
    layout.second.size.x = second;
    Area covered;
    for (int frame = 0; frame < 3; ++frame) {  // until the window has the size of its content
      landmarks.begin_frame();
      ImGui::NewFrame();
      covered = header.draw(layout, tool, editor.catalogue.actions);
      ImGui::Render();
    }
    return covered;
  }
  size_t items_of(const std::string& tool) const {
    for (const HeaderLayout& layout : header_layout()) {
      if (layout.tool != tool) continue;
      return static_cast<size_t>(std::ranges::count_if(layout.items, [&](const HeaderItem& item) {
        return landmarks.find(std::string("header ") + item.id).has_value();
      }));
    }
    return 0;
  }

  test::EditorFeatures editor;
  ToolHeader header;
  Landmarks landmarks{std::nullopt};
};

TEST_F(Header, lists_each_option_once_and_otherwise_actions) {
  std::multiset<std::string> options, listed;
  for (const auto& feature : editor.features) {
    for (const ToolOption& option : feature->tool_options()) options.insert(option.id);
  }
  for (const HeaderLayout& layout : header_layout()) {
    for (const HeaderItem& item : layout.items) {
      if (item.label == nullptr) listed.insert(item.id);
      if (item.label != nullptr) {
        EXPECT_NE(find_action(editor.catalogue.actions, item.id), nullptr) << item.id;
      }
    }
  }
  EXPECT_EQ(listed, options);
}

TEST_F(Header, shows_the_options_of_each_tool_in_one_line) {
  for (const char* tool : {kLaserTool, kPickTool, kInspectTool, kRulerTool, kPathTool, kKnifeTool}) {
    const Area covered = draw(tool, {1900, 900});
    EXPECT_GT(items_of(tool), 0u) << tool;
    EXPECT_LT(covered.size.y, 3 * ImGui::GetFontSize()) << tool;
    EXPECT_LE(covered.size.x, 1900) << tool;
  }
  EXPECT_EQ(items_of(kKnifeTool), 2u);
  EXPECT_FALSE(landmarks.find("header laser.radius"));
}

TEST_F(Header, omits_items_that_do_not_fit_and_is_hidden_in_small_or_split_viewports) {
  const double em = ImGui::GetIO().Fonts->Fonts[0]->FontSize;
  draw(kLaserTool, {100 * em, 50 * em});
  EXPECT_EQ(items_of(kLaserTool), 3u);
  const double narrow = 42 * em;
  const Area covered = draw(kLaserTool, {narrow, 50 * em});
  EXPECT_EQ(items_of(kLaserTool), 1u);
  EXPECT_LT(covered.size.x, narrow);
  for (const Vec2 small : {Vec2(35, 50), Vec2(100, 20)}) {
    EXPECT_EQ(draw(kLaserTool, small * em).size, Vec2(0));
    EXPECT_FALSE(landmarks.find("header bar"));
  }
  EXPECT_EQ(draw(kLaserTool, {100 * em, 50 * em}, 10).size, Vec2(0));
}

}  // namespace
}  // namespace kerf
