#include "core/physics/physics.h"

#include <gtest/gtest.h>

#include <regex>

namespace kerf {
namespace {

TEST(MachineKind, names_processor_c_library_solver_and_revision) {
  const std::regex form(R"([A-Za-z0-9_]+ glibc-\d+\.\d+ bullet-[23]\.\d+ motion-\d+)");
  EXPECT_TRUE(std::regex_match(machine_kind(), form)) << machine_kind();
  EXPECT_EQ(machine_kind(), machine_kind());
}

}  // namespace
}  // namespace kerf
