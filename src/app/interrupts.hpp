// SIGINT and SIGTERM: the first asks the run to end after its step, the second ends the program at once.
#pragma once

namespace frit::app {

void catch_interrupts();

// The signal that came, or 0.
int interrupt_received();

}  // namespace frit::app
