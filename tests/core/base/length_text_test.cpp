#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <string>

#include "core/base/number_format.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

TEST(LengthText, selects_the_unit) {
  EXPECT_EQ(length_text(0.01225), "12.2 mm");
  EXPECT_EQ(length_text(3), "3 m");
  EXPECT_EQ(length_text(0.9994), "999 mm");
  EXPECT_EQ(length_text(0.9996), "1 m");
  EXPECT_EQ(length_text(-9.997e-4), "-1 mm");
}

TEST(LengthText, has_a_decimal_point_in_every_locale) {
  const test::TemporaryFolder folder;
  const std::string make = "localedef -c -i de_DE -f UTF-8 '" + (folder / "de_DE").string() + "' 2>/dev/null";
  if (std::system(make.c_str()) != 0) GTEST_SKIP() << "needs the package locales";
  ::setenv("LOCPATH", folder.path().c_str(), 1);
  const locale_t german = ::newlocale(LC_ALL_MASK, "de_DE", nullptr);
  ::unsetenv("LOCPATH");
  ASSERT_NE(german, nullptr);
  const locale_t before = ::uselocale(german);
  const std::string length = length_text(0.01225);
  const std::string numbers = general_text(0.05, 10) + ' ' + general_text(1e-9, 10);
  ::uselocale(before);
  ::freelocale(german);
  EXPECT_EQ(length, "12.2 mm");
  EXPECT_EQ(numbers, "0.05 1e-09");
}

}  // namespace
}  // namespace kerf
