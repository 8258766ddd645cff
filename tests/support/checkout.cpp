#include "tests/support/checkout.h"

namespace kerf::test {

std::filesystem::path checkout() { return KERF_CHECKOUT; }

}  // namespace kerf::test
