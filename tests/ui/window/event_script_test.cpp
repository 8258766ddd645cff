#include "ui/window/scripted_window.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <sstream>
#include <vector>

namespace kerf {
namespace {

EventScript script(const std::string& steps, Vec2 size = {640, 480}) {
  return EventScript(std::make_unique<std::istringstream>(steps), "steps", size);
}

std::optional<std::string> no_answer(const std::string&) { return std::nullopt; }

// How many frames a script has while `moving` says of each whether it left something to do.
int frames_of(EventScript& script, const std::function<bool(int)>& moving) {
  int frames = 0;
  for (;; ++frames) {
    const auto next = script.begin_frame(frames > 0 && moving(frames - 1), no_answer);
    EXPECT_TRUE(next) << next.error().message;
    if (!next || !*next) return frames;
  }
}

int frames_of(const std::string& steps) {
  EventScript events = script(steps);
  return frames_of(events, [](int) { return true; });
}

TEST(EventScript, draws_a_frame_after_each_event_but_not_after_settings) {
  EXPECT_EQ(frames_of(""), 0);
  EXPECT_EQ(frames_of("\n  \n\r\n"), 0);
  EXPECT_EQ(frames_of(R"({"move": [1, 2]}
                         {"press": "left"}
                         {"frame": 0.5}
                         {"draws": false}
                         {"release": "left"})"),
            3);
  EXPECT_EQ(frames_of(R"({"together": [{"move": [1, 2]}, {"press": "left"}, {"release": "left"}]})"), 1);
}

TEST(EventScript, measures_time_in_frames) {
  EventScript events = script(R"({"frame": 0.25}
                                {"wait": 2}
                                {"move": [3, 4]})");
  EXPECT_EQ(frames_of(events, [](int) { return false; }), 9);
  EXPECT_EQ(events.seconds(), 9 * 0.25);
  EXPECT_EQ(events.frame_seconds(), 0.25);
}

TEST(EventScript, settles_a_few_frames_after_motion_ends_or_at_its_timeout) {
  const std::string steps = R"({"frame": 0.25}
                              {"settle": 10})";
  EventScript still = script(steps), moves = script(steps), stops = script(steps);
  const int at_least = frames_of(still, [](int) { return false; });
  EXPECT_GT(at_least, 1);
  EXPECT_LT(at_least, 10);
  EXPECT_EQ(frames_of(moves, [](int) { return true; }), 40);
  EXPECT_EQ(frames_of(stops, [](int frame) { return frame < 20; }), 21);
}

TEST(EventScript, executes_the_steps_of_one_frame_in_order) {
  EventScript steps = script(R"({"together": [{"move": [10, 20]}, {"press": "left"}, {"move": [30, 40]}]})");
  ASSERT_TRUE(*steps.begin_frame(false, no_answer));
  const auto& events = steps.input().input_state().events;
  ASSERT_EQ(events.size(), 3u);
  EXPECT_EQ(events[0].kind, InputEvent::Kind::kMove);
  EXPECT_EQ(events[1].kind, InputEvent::Kind::kPress);
  EXPECT_EQ(events[1].at, Vec2(10, 20));
  EXPECT_EQ(events[2].at, Vec2(30, 40));
}

TEST(EventScript, prints_the_screen_response_and_the_title) {
  EventScript events = script(R"({"answer": "report"}
                                {"answer": "title"}
                                {"move": [0, 0]})");
  events.set_title("a \"title\" \xfc");
  std::vector<std::string> requests;
  testing::internal::CaptureStdout();
  const auto frame = events.begin_frame(false, [&](const std::string& what) -> std::optional<std::string> {
    requests.push_back(what);
    if (what == "report") return "{}";
    return std::nullopt;
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "{}\n\"a \\\"title\\\" \xef\xbf\xbd\"\n");
  EXPECT_TRUE(*frame);
  EXPECT_EQ(requests, (std::vector<std::string>{"report", "title"}));
}

TEST(EventScript, fails_at_an_invalid_line_and_names_it) {
  for (const char* wrong : {"move",
                            "[1]",
                            "{}",
                            R"({"move": [1, 2], "press": "left"})",
                            R"({"jump": 1})",
                            R"({"move": [1]})",
                            R"({"move": "there"})",
                            R"({"press": "thumb"})",
                            R"({"key_down": "Ctrl+Z"})",
                            R"({"key_down": "No such key"})",
                            R"({"wheel": "up"})",
                            R"({"type": 3})",
                            R"({"drop": "file"})",
                            R"({"drop": [1]})",
                            R"({"size": [0, 10]})",
                            R"({"size": [9000, 10]})",
                            R"({"focus": 1})",
                            R"({"close": "yes"})",
                            R"({"together": {}})",
                            R"({"together": [1]})",
                            R"({"together": [{"wait": 1}]})",
                            R"({"wait": -1})",
                            R"({"settle": "long"})",
                            R"({"frame": 0})",
                            R"({"draws": 1})",
                            R"({"picture": 1})",
                            R"({"answer": "weather"})"}) {
    EventScript events = script(std::string(R"({"move": [1, 2]})") + "\n\n" + wrong);
    ASSERT_TRUE(*events.begin_frame(false, no_answer));
    const auto next = events.begin_frame(false, no_answer);
    ASSERT_FALSE(next) << wrong;
    EXPECT_TRUE(next.error().message.starts_with("steps:3")) << wrong << ": " << next.error().message;
  }
}

TEST(EventScript, fails_to_open_a_missing_file) {
  const auto none = EventScript::open("/no/such/file", {100, 100});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("/no/such/file"), std::string::npos);
}

}  // namespace
}  // namespace kerf
