#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/document/commands.h"

namespace kerf::test {

// Settings of a stroke, any that a journal may hold.
CutSettings random_settings(Random& random);

// A command of any kind with any numbers that a journal may hold, where the beam of the last stroke is at
// `beam`.
Command random_command(Random& random, const BeamAt& beam);

// So many of them, as a journal may hold them one after the other.
std::vector<Command> random_commands(Random& random, size_t count);

// Whether two commands are equal to the bit.
bool same_bits(const Command& a, const Command& b);

}  // namespace kerf::test
