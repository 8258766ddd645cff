#include <gtest/gtest.h>

#include <set>

#include "tests/support/checkout.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/golden.h"
#include "ui/figures/draw_figure.h"

namespace kerf {
namespace {

std::string name_of(const Figure& figure) {
  const std::string digits = std::to_string(figure.number);
  return "fig" + std::string(digits.size() < 2 ? "0" : "") + digits + ".png";
}

// The pictures of assets/README.md are the goldens. They are made with KERF_MAKE_GOLDEN=1.
TEST(FiguresGolden, the_figures_of_the_paper_match_the_readme) {
  const auto list = read_figures(test::checkout() / "assets/figures.json");
  ASSERT_TRUE(list) << list.error().message;
  const test::TemporaryFolder folder;
  for (const Figure& figure : list->figures) {
    const auto png = folder / name_of(figure);
    const Status drawn = draw_figure(figure, {640, 380}, png);
    ASSERT_TRUE(drawn) << drawn.error().message;
    const Pixels picture = read_png(png).value_or(Pixels{});
    ASSERT_EQ(picture.width, 640);
    ASSERT_EQ(picture.height, 380);
    const bool remake = std::getenv("KERF_MAKE_GOLDEN") != nullptr;
    // Where pieces of a match fly follows from the last bits of the machine's libm, and from every change of
    // the rules.
    if (figure.match.empty() || remake)
      test::expect_golden(test::checkout() / "assets/pictures/figures" / name_of(figure), picture);
    std::set<std::tuple<int, int, int>> colours;
    for (size_t i = 0; i + 2 < picture.rgb.size(); i += 3)
      colours.insert({picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]});
    EXPECT_GT(colours.size(), 100u) << figure.number;
  }
}

TEST(FiguresGolden, there_are_thirteen_in_order) {
  const auto list = read_figures(test::checkout() / "assets/figures.json");
  ASSERT_TRUE(list) << list.error().message;
  ASSERT_EQ(list->figures.size(), 13u);
  for (size_t i = 0; i < list->figures.size(); ++i) {
    EXPECT_EQ(list->figures[i].number, i + 1);
    EXPECT_NE(list->figures[i].caption.find("Figure " + std::to_string(i + 1) + "."), std::string::npos);
  }
}

}  // namespace
}  // namespace kerf
