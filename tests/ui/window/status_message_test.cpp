#include "ui/window/status_message.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(ErrorSentence, ends_with_a_full_stop_and_names_files_without_their_folder) {
  EXPECT_EQ(error_sentence("/home/a b/part.stl: cannot be read"), "part.stl: cannot be read.");
  EXPECT_EQ(error_sentence("Autosave failed: /var/x.kerf: the disk is full."),
            "Autosave failed: x.kerf: the disk is full.");
  EXPECT_EQ(error_sentence("Speed stays 3 mm/s: 1 / 0 is no number"),
            "Speed stays 3 mm/s: 1 / 0 is no number.");
  EXPECT_EQ(error_sentence("Is part.stl in /home/a?"), "Is part.stl in /home/a?");
  EXPECT_EQ(error_sentence(""), "");
}

TEST(Message, formats_errors_in_the_status_bar_and_in_the_log) {
  Message message;
  message.error("/a/part.stl: is empty");
  message.note("/a/part.obj: is empty", true);
  message.note("Saved: /a/part.kerf", false);
  EXPECT_EQ(message.text, "part.stl: is empty.");
  ASSERT_EQ(message.log.size(), 3u);
  EXPECT_EQ(message.log[0].text, "part.stl: is empty.");
  EXPECT_EQ(message.log[1].text, "part.obj: is empty.");
  EXPECT_EQ(message.log[2].text, "Saved: /a/part.kerf");
}

}  // namespace
}  // namespace kerf
