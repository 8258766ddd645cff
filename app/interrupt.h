#pragma once

namespace kerf {

// From this call on Ctrl-C and SIGTERM set a flag instead of ending the program. Long computations check the
// flag and stop.
void catch_interrupts();
// Whether the flag is set.
bool interrupted();
// Lets both signals end the program again, for work that does not check the flag.
void let_interrupts_end();

}  // namespace kerf
