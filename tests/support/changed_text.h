#pragma once

#include <gtest/gtest.h>

#include <string>

namespace kerf::test {

// The text with one part replaced, which must be there.
inline std::string with(std::string text, const std::string& part, const std::string& other) {
  const size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return at == std::string::npos ? text : text.replace(at, part.size(), other);
}

// A change that makes a file invalid, and the expected part of the error.
struct Wrong {
  const char *part, *other, *expected;
};

}  // namespace kerf::test
