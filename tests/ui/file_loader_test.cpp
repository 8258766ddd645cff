#include "ui/editor/file_loader.h"

#include <gtest/gtest.h>

#include <thread>

namespace kerf::test {
namespace {

const std::filesystem::path kMeshes = std::filesystem::path(KERF_ASSETS) / "meshes";

LoadOrder files(const std::vector<std::string>& names) {
  LoadOrder order;
  for (const std::string& name : names) order.files.push_back(kMeshes / name);
  return order;
}

Result<LoadedFiles> wait_for(FileLoader& loader) {
  for (;;) {
    if (auto loaded = loader.take()) return std::move(*loaded);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(FileLoader, hands_over_what_it_read_once) {
  FileLoader loader;
  EXPECT_FALSE(loader.take());
  loader.start(files({"knot.obj", "bracket.obj"}));
  EXPECT_TRUE(loader.busy());
  EXPECT_EQ(loader.order().name(), "knot.obj and 1 more");
  const Result<LoadedFiles> loaded = wait_for(loader);
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded->document.world().ids().size(), 2u);
  EXPECT_EQ(loaded->prepared.size(), 2u);
  EXPECT_FALSE(loader.busy());
  EXPECT_FALSE(loader.take());
}

TEST(FileLoader, says_why_a_file_cannot_be_read) {
  FileLoader loader;
  loader.start(files({"no_such_file.obj"}));
  const Result<LoadedFiles> loaded = wait_for(loader);
  ASSERT_FALSE(loaded.ok());
  EXPECT_NE(loaded.error().message.find("no_such_file.obj"), std::string::npos);
}

TEST(FileLoader, what_was_given_up_never_comes) {
  FileLoader loader;
  loader.start(files({"knot.obj"}));
  loader.start(files({"bracket.obj"}));
  const Result<LoadedFiles> loaded = wait_for(loader);
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded->order.files.front().filename(), "bracket.obj");
  loader.start(files({"knot.obj"}));
  loader.cancel();
  EXPECT_FALSE(loader.busy());
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(loader.take());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace
}  // namespace kerf::test
