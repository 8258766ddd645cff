#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <filesystem>
#include <fstream>

#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"
#include "ui/editor/shared/file_browser.h"
#include "ui/window/layout.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

TEST(FileBrowser, lists_folders_and_supported_files) {
  const fs::path folder = fs::path(testing::TempDir()) / "kerf-file-browser";
  fs::create_directories(folder / "Zoo");
  fs::create_directories(folder / ".hidden");
  for (const char* name :
       {"b.OBJ", "a.stl", "cut.kerf", "cut.kerf~", "note.txt", "scene.json", ".secret.obj"})
    std::ofstream(folder / name);
  std::string fault;
  std::vector<std::string> names;
  for (const auto& entry : list_folder(folder, fault)) names.push_back(entry.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"Zoo", "a.stl", "b.OBJ", "cut.kerf", "cut.kerf~", "scene.json"}));
  EXPECT_EQ(fault, "");
  EXPECT_TRUE(list_folder(folder / "none", fault).empty());
  EXPECT_NE(fault, "");
  EXPECT_TRUE(passes_filter("Car-Cut.OBJ", "cut.o"));
  EXPECT_TRUE(passes_filter("cut.kerf", "kerf"));
  EXPECT_FALSE(passes_filter("car.obj", "stl"));
  fs::remove_all(folder);
}

TEST(FileBrowser, lists_files_by_kind_and_creates_folders_with_free_names) {
  for (const auto& [name, kind] :
       {std::pair{"a.OBJ", FileKind::kMeshes}, std::pair{"b.json", FileKind::kScenes},
        std::pair{"c.kerf", FileKind::kJournals}, std::pair{"d.SVG", FileKind::kDrawings}}) {
    for (const FileKind other :
         {FileKind::kMeshes, FileKind::kScenes, FileKind::kJournals, FileKind::kDrawings})
      EXPECT_EQ(is_of_kind(name, other), other == kind) << name;
    EXPECT_TRUE(is_of_kind(name, FileKind::kAll)) << name;
  }
  const auto folder = std::filesystem::path(testing::TempDir()) / "kerf-new-folders";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  EXPECT_EQ(make_new_folder(folder)->filename(), "New Folder");
  EXPECT_EQ(make_new_folder(folder)->filename(), "New Folder 2");
  EXPECT_FALSE(make_new_folder(folder / "missing"));
  std::filesystem::remove_all(folder);
}

// The dialog that saves to a folder.
class SaveDialog : public testing::Test {
 protected:
  SaveDialog() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1000, 700};
    io.Fonts->Build();
    keep_landmarks(&landmarks);
  }
  ~SaveDialog() override { ImGui::DestroyContext(); }

  void draw(int frames = 2) {
    for (int frame = 0; frame < frames; ++frame) {
      ImGui::NewFrame();
      draw_file_browser(browser);
      ImGui::Render();
    }
  }
  void open(const std::string& name) {
    browse(browser,
           {.title = "Save",
            .verb = "Save",
            .hint = "",
            .endings = {".kerf", ".json"},
            .take =
                [this](const fs::path& file) {
                  taken = file;
                  return std::string();
                }},
           folder.path(), name);
    draw();
  }
  void enter() {
    browser_key(browser, GLFW_KEY_ENTER);
    draw();
  }

  void click(const std::string& part) {
    const Area area = landmarks.find(part).value();
    const Vec2 middle = area.at + 0.5 * area.size;
    ImGui::GetIO().MousePos = {static_cast<float>(middle.x), static_cast<float>(middle.y)};
    for (const bool down : {false, true, false}) {
      ImGui::GetIO().MouseDown[0] = down;
      draw();
    }
  }

  const test::TemporaryFolder folder;
  Landmarks landmarks{std::nullopt};
  FileBrowser browser;
  fs::path taken;
};

TEST_F(SaveDialog, only_a_tilde_before_a_slash_is_the_home_folder) {
  const test::EnvironmentVariable home("HOME", "/no/such/home");
  open("~draft");
  enter();
  EXPECT_EQ(taken, browser.folder / "~draft.kerf");
  open("~/draft");
  enter();
  EXPECT_EQ(taken, "/no/such/home/draft.kerf");
}

TEST_F(SaveDialog, a_name_with_a_slash_at_its_end_is_a_folder) {
  fs::create_directory(folder / "parts");
  open("parts/");
  enter();
  EXPECT_EQ(browser.folder, fs::canonical(folder / "parts"));
  browser_key(browser, GLFW_KEY_ESCAPE);
  draw(3);
  open("..");
  enter();
  EXPECT_EQ(browser.folder, fs::canonical(folder.path()).parent_path());
  EXPECT_EQ(taken, fs::path());
}

TEST_F(SaveDialog, another_name_ends_the_question_about_an_existing_file) {
  for (const char* name : {"mine.kerf", "other.kerf"}) std::ofstream(folder / name);
  for (const char* part : {"type .json", "entry other.kerf"}) {
    open("mine");
    enter();
    EXPECT_FALSE(browser.replace.empty());
    EXPECT_NE(browser.fault, "");
    click(part);
    EXPECT_TRUE(browser.replace.empty());
    EXPECT_EQ(browser.fault, "");
    browser_key(browser, GLFW_KEY_ESCAPE);
    draw(3);
  }
  EXPECT_EQ(taken, fs::path());
}

}  // namespace
}  // namespace kerf
