#pragma once

#include <cstdint>

namespace kerf {

class Fields;

// Visits the keys of the format of a file that records what was done: "format", the number of its format, and
// "program", the version of Kerf that wrote it:
//
//   {"kerf": "journal", "format": 1, "program": "0.1.0", ...}
//
// Refuses a file of a format later than `newest`, and one without a format, as Kerf wrote it before 0.2.
void format_fields(Fields& f, uint64_t newest);

}  // namespace kerf
