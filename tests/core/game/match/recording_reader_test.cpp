#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/game/match/recording.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

const std::string kHead =
    R"({"kerf":"match","format":4,"program":"0.2.0","rules":"rules.json","files":"0123456789abcdef","seed":7,)"
    R"("difficulty":"hard"})";
const std::string kInputs = R"({"inputs":[[2,100,-5,0,1,30,-200,17]]})";

class RecordingFile : public testing::Test {
 protected:
  Result<Recording> read(const std::string& text) {
    test::write_text(file(), text);
    return read_recording(file());
  }
  std::filesystem::path file() const { return folder_ / "match.kerf"; }

  test::TemporaryFolder folder_;
};

TEST_F(RecordingFile, reads_every_field) {
  const auto read_back =
      read(kHead + "\n" + kInputs + "\n" + R"({"hash":"00000000000000ff","machine":"here"})" + "\n");
  ASSERT_TRUE(read_back) << read_back.error().message;
  EXPECT_EQ(read_back->rules, folder_ / "rules.json");
  EXPECT_EQ(read_back->files, 0x0123456789abcdefu);
  EXPECT_EQ(read_back->seed, 7u);
  EXPECT_EQ(read_back->difficulty, Difficulty::kHard);
  ASSERT_EQ(read_back->controls.size(), 2u);
  const Controls& c = read_back->controls[1];
  EXPECT_TRUE(c.throttle == 100 && c.steer == -5 && !c.handbrake && c.fire);
  EXPECT_TRUE(c.width == 30 && c.heading == -200 && c.pitch == 17);
  EXPECT_EQ(read_back->hash, 0xffu);
  EXPECT_EQ(read_back->machine, "here");
  EXPECT_EQ(read_back->damage, "");
}

TEST_F(RecordingFile, random_controls_round_trip) {
  Random random(3);
  Recording recording;
  recording.rules = folder_ / "rules.json";
  for (int t = 0; t < 1000; ++t) {
    Controls& c = recording.controls.emplace_back();
    const auto within = [&](int most) {
      return static_cast<int>(random.below(2 * static_cast<uint64_t>(most) + 1)) - most;
    };
    c.throttle = static_cast<int8_t>(within(Controls::kFull));
    c.steer = static_cast<int8_t>(within(Controls::kFull));
    c.handbrake = random.below(2) == 0;
    c.fire = random.below(2) == 0;
    c.boost = random.below(2) == 0;
    c.upgrade = static_cast<uint8_t>(random.below(Controls::kUpgrades + 1));
    c.width = static_cast<uint8_t>(random.below(Controls::kFull + 1));
    c.heading = within(31'416);
    c.pitch = within(15'708);
  }
  const auto text = recording_text(recording, folder_.path());
  ASSERT_TRUE(text);
  const auto read_back = read(*text);
  ASSERT_TRUE(read_back) << read_back.error().message;
  EXPECT_EQ(read_back->controls, recording.controls);
  EXPECT_FALSE(read_back->hash);
}

TEST_F(RecordingFile, reads_up_to_an_invalid_line) {
  for (const char* damaged :
       {R"({"inputs":[[0,0,0,0,0,0,0,0]]})", R"({"inputs":[[121,0,0,0,0,0,0,0]]})",
        R"({"inputs":[[1,101,0,0,0,0,0,0]]})", R"({"inputs":[[1,0,0,64,0,0,0,0]]})",
        R"({"inputs":[[1,18446744073709551615,0,0,0,0,0,0]]})", R"({"inputs":[[1,0,0,0,0,0,0]]})",
        R"({"inputs":[[1,0,0,0,0,0,0.5,0]]})", R"({"hash":"12"})", "[]", "{}", "{\"inputs\":"}) {
    const auto read_back = read(kHead + "\n" + kInputs + "\n" + damaged + "\n" + kInputs + "\n");
    ASSERT_TRUE(read_back) << damaged;
    EXPECT_EQ(read_back->controls.size(), 2u) << damaged;
    EXPECT_NE(read_back->damage.find("line 3"), std::string::npos) << read_back->damage;
  }
}

TEST_F(RecordingFile, with_a_truncated_last_line_reports_it) {
  const auto read_back = read(kHead + "\n" + kInputs);
  ASSERT_TRUE(read_back);
  EXPECT_NE(read_back->damage, "");
}

TEST_F(RecordingFile, rejects_an_invalid_header) {
  const auto refused = [&](const std::string& part, const std::string& other) {
    std::string head = kHead;
    head.replace(head.find(part), part.size(), other);
    return !read(head + "\n" + kInputs + "\n");
  };
  EXPECT_TRUE(refused("\"match\"", "\"scene\""));
  EXPECT_TRUE(refused("\"seed\":7", "\"seed\":-7"));
  EXPECT_TRUE(refused("\"seed\":7", "\"seed\":7.5"));
  EXPECT_TRUE(refused("abcdef", "abcdxf"));
  EXPECT_TRUE(refused("\"hard\"", "\"lethal\""));
  EXPECT_TRUE(refused(",\"seed\":7", ""));
  EXPECT_TRUE(refused("\"format\":4", "\"format\":" + std::to_string(kRecordingFormat + 1)));
  EXPECT_FALSE(read(""));
}

TEST_F(RecordingFile, rejects_files_of_older_formats_and_without_one) {
  const std::string format = R"("format":4,"program":"0.2.0")";
  for (const auto& [older, words] : {std::pair{R"("version":5)", "before Kerf 0.2"},
                                     {R"("format":3,"program":"0.2.0")", "by an earlier build of Kerf"}}) {
    std::string head = kHead;
    head.replace(head.find(format), format.size(), older);
    const auto recording = read(head + "\n" + kInputs + "\n");
    ASSERT_FALSE(recording);
    EXPECT_EQ(recording.error().code, ErrorCode::kBadInput);
    EXPECT_NE(recording.error().message.find(words), std::string::npos) << recording.error().message;
  }
}

TEST_F(RecordingFile, is_identified_by_its_first_bytes) {
  test::write_text(file(), kHead);
  EXPECT_TRUE(is_recording(file()));
  test::write_text(file(), "{\"bodies\": []}");
  EXPECT_FALSE(is_recording(file()));
  EXPECT_FALSE(is_recording(folder_ / "gone.kerf"));
}

}  // namespace
}  // namespace kerf
