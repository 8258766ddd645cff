#include <gtest/gtest.h>

#include "tests/support/environment.h"
#include "ui/editor/laser/laser_feature.h"
#include "ui/editor/path/path_tool.h"
#include "ui/editor/shared/document_session.h"
#include "ui/editor/shared/laser_controls.h"
#include "ui/editor/shared/statistics.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/view_options.h"
#include "ui/window/layout.h"

namespace kerf {
namespace {

// Preconditions that headers of ui name, each broken once: the assertion has to fire.
class PreconditionDeathTest : public testing::Test {
 protected:
  test::EnvironmentVariable asserts_{"KERF_ASSERTS", "fatal"};
};

TEST_F(PreconditionDeathTest, of_a_layout) {
  const Layout whole = lay_out({800, 600}, 16, 26, 26);
  EXPECT_DEATH(split_in_two(whole, 1.5), "assertion failed");
  EXPECT_DEATH(split_in_two(split_in_two(whole, 0.5), 0.5), "assertion failed");
}

TEST_F(PreconditionDeathTest, of_a_view) {
  EXPECT_DEATH(look_at({0, 0, 1}, {0, 0, 0}, 0), "assertion failed");
  EXPECT_DEATH(CameraView().pulled(0), "assertion failed");
  ViewOptions look;
  EXPECT_DEATH(spread_pieces(World(), -1, look), "assertion failed");
}

TEST_F(PreconditionDeathTest, of_the_hints) {
  EXPECT_DEATH(meets_hull({{0, 0}, {1, 1}}, {}), "assertion failed");
}

TEST_F(PreconditionDeathTest, of_the_laser) {
  EXPECT_DEATH(ResolutionControls().of(0), "assertion failed");
  Document document{World()};
  EXPECT_DEATH(LaserTool().fire(document, Pose{{0, 0, 0}, {0, 0, 2}}, 1, {}, 0), "assertion failed");
}

TEST_F(PreconditionDeathTest, of_opening_a_file) {
  EXPECT_DEATH(FileLoader().order(), "assertion failed");
  Opening opening;
  Message message;
  EXPECT_DEATH(cancel_opening(opening, message), "assertion failed");
}

TEST_F(PreconditionDeathTest, of_the_figures_and_the_path) {
  EXPECT_DEATH(FrameStatistics().percentile(2), "assertion failed");
  EXPECT_DEATH(PathWork().undo(), "assertion failed");
}

}  // namespace
}  // namespace kerf
