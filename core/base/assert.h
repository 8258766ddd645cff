#pragma once

namespace kerf {

// Whether what is asserted has to hold: the environment asks for it by KERF_ASSERTS=fatal, as the tests do.
bool asserts_are_fatal();

// Says on standard error which assertion failed, and where, once for each place in a row. Ends the program by
// a signal where assertions are fatal; returns elsewhere.
[[gnu::cold]] void report_failed_assertion(const char* condition, const char* file, int line);

}  // namespace kerf

// States a precondition, or what another function left behind. It is checked in every build; what is called
// so often that the benchmarks feel it is stated by assert() of <cassert>, which only builds for debugging
// check.
#define KERF_ASSERT(...)                   \
  (static_cast<bool>(__VA_ARGS__) ? void() \
                                  : ::kerf::report_failed_assertion(#__VA_ARGS__, __FILE__, __LINE__))
