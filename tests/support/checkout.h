#pragma once

#include <filesystem>

namespace kerf::test {

// The folder of the checkout that the tests were compiled from.
std::filesystem::path checkout();

}  // namespace kerf::test
