#pragma once

namespace kerf {

// All tolerances of Kerf. None is a length: each is relative to the numbers that it guards.

// Slack of a box test, relative to the largest number in it. A dot product of three terms in double errs by
// less than 4e-16 of them; boxes only cull, so a little more costs a few needless triangle tests and no more.
inline constexpr double kBoxSlack = 1e-14;

}  // namespace kerf
