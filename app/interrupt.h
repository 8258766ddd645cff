#pragma once

namespace kerf {

// From now on Ctrl-C and SIGTERM do not end the program but are remembered; long work asks and stops.
void catch_interrupts();
bool interrupted();
// Work that does not ask is to be ended by them again.
void let_interrupts_end();

}  // namespace kerf
