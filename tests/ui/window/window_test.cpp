#include "ui/window/window.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(InputEvents, of_one_frame_have_increasing_times_within_it) {
  std::vector<InputEvent> events(4);
  spread_times(events, 2, 3);
  EXPECT_EQ(events[0].seconds, 2.25);
  EXPECT_EQ(events[1].seconds, 2.5);
  EXPECT_EQ(events[2].seconds, 2.75);
  EXPECT_EQ(events[3].seconds, 3);
}

TEST(InputEvents, are_empty_without_input) { spread_times({}, 2, 3); }

TEST(CharacterKey, follows_the_layout_of_the_keyboard) {
  EXPECT_EQ(character_key(GLFW_KEY_Q, "a"), GLFW_KEY_A);  // AZERTY
  EXPECT_EQ(character_key(GLFW_KEY_SEMICOLON, "m"), GLFW_KEY_M);
  EXPECT_EQ(character_key(GLFW_KEY_M, ","), GLFW_KEY_COMMA);
  EXPECT_EQ(character_key(GLFW_KEY_Y, "z"), GLFW_KEY_Z);  // QWERTZ
  EXPECT_EQ(character_key(GLFW_KEY_SLASH, "-"), GLFW_KEY_MINUS);
}

TEST(CharacterKey, is_the_place_if_the_character_has_no_key) {
  EXPECT_EQ(character_key(GLFW_KEY_Z, "\xD1\x8F"), GLFW_KEY_Z);  // Cyrillic
  EXPECT_EQ(character_key(GLFW_KEY_SLASH, "!"), GLFW_KEY_SLASH);
  EXPECT_EQ(character_key(GLFW_KEY_EQUAL, nullptr), GLFW_KEY_EQUAL);
  EXPECT_EQ(character_key(GLFW_KEY_A, ""), GLFW_KEY_A);
}

TEST(CharacterKey, keeps_other_keys_and_the_digit_row) {
  EXPECT_EQ(character_key(GLFW_KEY_SPACE, "a"), GLFW_KEY_SPACE);
  EXPECT_EQ(character_key(GLFW_KEY_KP_1, "1"), GLFW_KEY_KP_1);
  EXPECT_EQ(character_key(GLFW_KEY_UNKNOWN, nullptr), GLFW_KEY_UNKNOWN);
  EXPECT_EQ(character_key(GLFW_KEY_4, "'"), GLFW_KEY_4);  // AZERTY
  EXPECT_EQ(character_key(GLFW_KEY_6, "-"), GLFW_KEY_6);
}

}  // namespace
}  // namespace kerf
