#include "core/document/stroke_path.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace kerf::test {
namespace {

class PathFile : public ::testing::Test {
 protected:
  Result<std::vector<StrokePath>> read(const std::string& text) {
    const auto file = std::filesystem::path(::testing::TempDir()) /
                      (std::string("path_file_") +
                       ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".json");
    std::ofstream(file) << text;
    return read_path_file(file);
  }

  // One stroke with these keys.
  static std::string keys(const std::string& list) { return R"({"strokes": [{"keys": [)" + list + "]}]}"; }

  void expect_refused(const std::string& text, const std::string& where, const std::string& what) {
    const auto strokes = read(text);
    ASSERT_FALSE(strokes.ok()) << text;
    EXPECT_EQ(strokes.error().code, ErrorCode::kBadInput);
    EXPECT_NE(strokes.error().message.find(where), std::string::npos) << strokes.error().message;
    EXPECT_NE(strokes.error().message.find(what), std::string::npos) << strokes.error().message;
    EXPECT_EQ(strokes.error().message.find('\n'), std::string::npos);
  }
};

TEST_F(PathFile, a_number_that_is_too_large_is_refused_with_its_line) {
  expect_refused("{\"strokes\":\n [{\"laser\": {\"radius\": 1e999}}]}",
                 ": line 2: ", "the number 1e999 is too large");
}

TEST_F(PathFile, a_read_error_is_not_the_end_of_the_file) {
  const auto strokes = read_path_file("/proc/self/mem");  // nothing can be read at its start
  ASSERT_FALSE(strokes.ok());
  EXPECT_EQ(strokes.error().code, ErrorCode::kFailed);
  EXPECT_EQ(strokes.error().message, "/proc/self/mem: reading failed before the end");
}

TEST_F(PathFile, reads_strokes_and_normalises_directions) {
  const auto strokes = read(
      R"({"strokes": [{"laser": {"radius": 0.004, "range": [0, 10], "power": 2000},
          "keys": [{"t": 0, "origin": [0,1,0], "direction": [0,-5,0]},
                   {"t": 1, "origin": [0.5,1,0], "direction": [0,-1e300,0]}]}]})");
  ASSERT_TRUE(strokes.ok()) << strokes.error().message;
  ASSERT_EQ(strokes->size(), 1u);
  const StrokePath& stroke = strokes->front();
  EXPECT_EQ(stroke.radius, 0.004);
  EXPECT_EQ(stroke.range->high, 10);
  ASSERT_EQ(stroke.keys.size(), 2u);
  EXPECT_EQ(stroke.keys[0].direction, Vec3(0, -1, 0));
  EXPECT_EQ(stroke.keys[1].direction, Vec3(0, -1, 0));
}

TEST_F(PathFile, reads_a_single_key_as_a_stationary_beam) {
  const auto strokes = read(keys(R"({"t": 0, "origin": [0,1,0], "direction": [1,0,0]})"));
  ASSERT_TRUE(strokes.ok());
  EXPECT_EQ(strokes->front().keys.size(), 1u);
  EXPECT_FALSE(strokes->front().radius.has_value());
}

TEST_F(PathFile, rejects_invalid_strokes_with_their_location) {
  const std::string good = R"({"t": 0, "origin": [0,1,0], "direction": [0,-1,0]})";
  expect_refused(keys(""), "/strokes/0/keys", "one key");
  expect_refused(keys(R"({"t": 0, "origin": [0,1,0], "direction": [0,0,0]})"), "/strokes/0/keys/0/direction",
                 "zero");
  expect_refused(keys(R"({"t": 0, "origin": [0,1], "direction": [0,1,0]})"), "/strokes/0/keys/0/origin",
                 "three");
  expect_refused(keys(R"({"t": 0, "origin": [0,1,"x"], "direction": [0,1,0]})"), "/strokes/0/keys/0/origin/2",
                 "number");
  expect_refused(keys(R"({"t": 0, "origin": [0,1,0]})"), "/strokes/0/keys/0", "direction");
  expect_refused(keys(good + "," + good), "/strokes/0/keys/1/t", "ascend");
  expect_refused(keys(good + R"(,{"t": 1, "origin": [0,1,0], "direction": [0,1,0]})"),
                 "/strokes/0/keys/1/direction", "opposite");
  expect_refused(R"({"strokes": [{"laser": {"radius": -1}, "keys": []}]})", "/strokes/0/laser/radius",
                 "must not be negative");
  expect_refused(R"({"strokes": [{"laser": {"range": [2, 1]}, "keys": []}]})", "/strokes/0/laser/range",
                 "range");
  expect_refused(R"({"strokes": 7})", "/strokes", "array");
  expect_refused("[]", "json", "object");
  expect_refused("{\n \"strokes\": [\n", "line", "JSON");
  expect_refused("", "line 1", "JSON");
}

TEST_F(PathFile, rejects_numbers_beyond_the_range_of_double) {
  const auto strokes = read(keys(R"({"t": 0, "origin": [0,1e999,0], "direction": [0,-1,0]})"));
  EXPECT_FALSE(strokes.ok());
}

TEST(ReadPathFile, names_a_missing_file_in_the_error) {
  const auto strokes = read_path_file("no-such-path.json");
  ASSERT_FALSE(strokes.ok());
  EXPECT_NE(strokes.error().message.find("no-such-path.json"), std::string::npos);
}

}  // namespace
}  // namespace kerf::test
