#include <gtest/gtest.h>

#include "core/document/journal.h"

namespace kerf {
namespace {

TEST(EnvironmentText, in_millimetres_round_trips) {
  const Command metres = SetEnvironment{{.gravity = {0, -9.81, 0}, .ground = 0}};
  const Command millimetres = SetEnvironment{{.gravity = {0, -9810, 0}, .ground = 5, .metre = 1000}};
  for (const Command& command : {metres, millimetres}) {
    const auto text = command_text(command, {});
    ASSERT_TRUE(text.ok());
    const nlohmann::json json = nlohmann::json::parse(*text);
    const auto read = parse_command(JsonValue(json, "test"), {}, std::nullopt);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(std::get<SetEnvironment>(*read).around, std::get<SetEnvironment>(command).around);
  }
  const nlohmann::json wrong = {{"do", "environment"}, {"gravity", {0, -1, 0}}, {"metre", 0}};
  EXPECT_FALSE(parse_command(JsonValue(wrong, "test"), {}, std::nullopt).ok());
}

}  // namespace
}  // namespace kerf
