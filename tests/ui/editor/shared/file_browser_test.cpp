#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "ui/editor/shared/file_browser.h"

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

}  // namespace
}  // namespace kerf
