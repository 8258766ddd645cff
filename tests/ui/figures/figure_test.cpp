#include "ui/figures/figure.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/checkout.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

Result<FigureList> read(const std::string& text) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "figures.json", text);
  return read_figures(folder / "figures.json");
}

TEST(Figure, a_file_describes_the_content_and_caption_of_each_figure) {
  const auto list = read(R"({"figures": [
    {"number": 3, "caption": "A hole.", "scene": "hole.json", "beam": true, "spread": 0.5,
     "rulers": [{"from": [0, 1, 2], "to": [3, 4, 5], "text": "beam"}]},
    {"number": 10, "caption": "A fight.", "match": "fight.kerf", "tick": 240},
    {"number": 4, "caption": "A split.", "diagram": "one-to-four"}],
    "films": {"cut": "falls.kerf"}})");
  ASSERT_TRUE(list) << list.error().message;
  EXPECT_EQ(list->films.cut.filename(), "falls.kerf");
  EXPECT_TRUE(list->films.shadow.empty());
  const std::vector<Figure>& figures = list->figures;
  ASSERT_EQ(figures.size(), 3u);
  const Figure& hole = figures[0];
  EXPECT_EQ(hole.scene.filename(), "hole.json");
  EXPECT_TRUE(hole.beam);
  EXPECT_EQ(hole.spread, 0.5);
  ASSERT_EQ(hole.rulers.size(), 1u);
  EXPECT_EQ(hole.rulers[0].to, Vec3(3, 4, 5));
  EXPECT_EQ(figures[1].tick, 240u);
  EXPECT_EQ(figures[2].diagram, "one-to-four");
}

TEST(Figure, errors_name_the_invalid_value) {
  for (const auto& [text, named] :
       {std::pair{R"({"figures": [{"caption": "x", "scene": "a.json"}]})", "number"},
        {R"({"figures": [{"number": 1, "caption": "x"}]})", "/figures/0: must have one of"},
        {R"({"figures": [{"number": 1, "caption": "x", "scene": "a", "match": "b"}]})", "must have one of"},
        {R"({"figures": [{"number": 1, "caption": "x", "diagram": "y"}]})", "/diagram: must be"},
        {R"({"figures": [{"number": 1, "caption": "x", "scene": "a", "rulers": [{"from": [0, 0, 0]}]}]})",
         "rulers/0"},
        {"{", "figures.json"}}) {
    const auto figures = read(text);
    ASSERT_FALSE(figures) << text;
    EXPECT_NE(figures.error().message.find(named), std::string::npos) << figures.error().message;
  }
}

}  // namespace
}  // namespace kerf
