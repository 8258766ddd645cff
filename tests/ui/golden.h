#pragma once

#include <filesystem>

#include "ui/gl/image.h"

namespace kerf::test {

// Compares a picture with a golden one, with a tolerance: versions of the software renderer round
// differently. With KERF_MAKE_GOLDEN=1 the golden one is made anew; look at it then.
void expect_golden(const std::filesystem::path& golden, const Pixels& drawn);

}  // namespace kerf::test
