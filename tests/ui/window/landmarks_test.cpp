#include "core/base/json.h"
#include "ui/window/layout.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

class LandmarksFile : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "landmarks.json";

  nlohmann::json read() const { return nlohmann::json::parse(std::ifstream(file_)); }
};

TEST_F(LandmarksFile, contains_only_the_rectangles_of_the_last_frame) {
  Landmarks landmarks(file_);
  landmarks.mark("gone in the next frame", {{1, 2}, {3, 4}});
  ASSERT_TRUE(landmarks.finish(false, Vec2(0)));
  EXPECT_EQ(read().at("parts").size(), 1u);

  landmarks.begin_frame();
  landmarks.mark(lay_out({800, 600}, 16, 26, 26));
  ASSERT_TRUE(landmarks.finish(false, Vec2(0)));
  EXPECT_EQ(read().at("parts").at("status"), nlohmann::json::array({0.0, 574.0, 800.0, 26.0}));
  EXPECT_FALSE(read().at("parts").contains("gone in the next frame"));
}

TEST_F(LandmarksFile, is_not_written_while_nothing_changes) {
  Landmarks landmarks(file_);
  landmarks.mark("a", {{1, 2}, {3, 4}});
  ASSERT_TRUE(landmarks.finish(false, Vec2(0)));
  std::filesystem::remove(file_);
  landmarks.begin_frame();
  landmarks.mark("a", {{1, 2}, {3, 4}});
  ASSERT_TRUE(landmarks.finish(false, Vec2(0)));
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(LandmarksFile, reports_the_pointer_position_and_pending_frames) {
  Landmarks landmarks(file_);
  for (const bool busy : {true, false}) {
    ASSERT_TRUE(landmarks.finish(busy, {3, 4}));
    EXPECT_EQ(read().at("busy"), busy);
    EXPECT_EQ(read().at("pointer"), nlohmann::json::array({3.0, 4.0}));
  }
}

TEST_F(LandmarksFile, contains_widgets_at_their_drawn_position) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {800, 600};
  io.Fonts->Build();
  Landmarks landmarks(file_);
  for (Landmarks* const kept : {static_cast<Landmarks*>(nullptr), &landmarks}) {
    keep_landmarks(kept);
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({100, 50});
    ImGui::Begin("window", nullptr, ImGuiWindowFlags_NoDecoration);
    ImGui::SetCursorScreenPos({120, 70});
    ImGui::Button("button", {30, 20});
    mark_last_item("button", 7);
    ImGui::End();
    ImGui::Render();
  }
  ImGui::DestroyContext();
  ASSERT_TRUE(landmarks.finish(false, Vec2(0)));
  EXPECT_EQ(read().at("parts"), nlohmann::json({{"button 7", {120.0, 70.0, 30.0, 20.0}}}));
}

TEST(Landmarks, may_have_names_that_are_not_utf8) {
  Landmarks landmarks(std::nullopt);
  landmarks.mark("piece T\xfcr", {{1, 2}, {3, 4}});
  const nlohmann::json parts = nlohmann::json::parse(landmarks.text()).at("parts");
  EXPECT_EQ(parts, nlohmann::json({{"piece T\xef\xbf\xbdr", {1.0, 2.0, 3.0, 4.0}}}));
}

TEST(Landmarks, report_why_they_cannot_be_written) {
  Landmarks landmarks("/no such folder/landmarks.json");
  landmarks.mark("a", {});
  const Status written = landmarks.finish(false, Vec2(0));
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message.find("landmarks.json"), std::string::npos);
}

}  // namespace
}  // namespace kerf
