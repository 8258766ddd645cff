#include "core/base/json.h"
#include "ui/editor/path/emitter.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(EmitterEntry, restores_the_emitter_switched_off) {
  Emitter emitter;
  emitter.place({1, 2, 3}, {0.1, 0, -0.2});
  emitter.in_shots = true;
  emitter.pace.set(7);
  emitter.firing = true;
  const Emitter read = emitter_of_entry(nlohmann::json::parse(emitter_entry(emitter).dump()));
  ASSERT_TRUE(read.placed());
  EXPECT_EQ(read.at(), emitter.at());
  EXPECT_EQ(read.target(), emitter.target());
  EXPECT_TRUE(read.in_shots);
  EXPECT_EQ(read.pace.per_second(), 7);
  EXPECT_FALSE(read.firing);
}

TEST(EmitterEntry, is_null_without_an_emitter_and_ignored_if_invalid) {
  EXPECT_TRUE(emitter_entry(Emitter()).is_null());
  EXPECT_FALSE(emitter_of_entry(nullptr).placed());
  EXPECT_FALSE(emitter_of_entry({{"at", {0, 0, 0}}, {"target", {0, 0, 0}}}).placed());
  EXPECT_FALSE(emitter_of_entry({{"at", "there"}, {"target", {0, 0, 1}}}).placed());
}

}  // namespace
}  // namespace kerf
