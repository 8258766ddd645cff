#pragma once

namespace kerf {

// Returns true if a failed assertion ends the program: KERF_ASSERTS=fatal is set, as in tests.
bool asserts_are_fatal();

// Reports a failed assertion on standard error, once for consecutive failures of the same one. Aborts if
// assertions are fatal, otherwise returns.
[[gnu::cold]] void report_failed_assertion(const char* condition, const char* file, int line);

}  // namespace kerf

// Asserts a precondition or the postcondition of another function, in every build. Code whose checks would
// show up in benchmarks uses assert() of <cassert>, which only debug builds check.
#define KERF_ASSERT(...)                   \
  (static_cast<bool>(__VA_ARGS__) ? void() \
                                  : ::kerf::report_failed_assertion(#__VA_ARGS__, __FILE__, __LINE__))
