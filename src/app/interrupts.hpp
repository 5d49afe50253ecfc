// Signals: the first SIGINT or SIGTERM asks the run to end after its step, the second ends the program at
// once; SIGUSR1 asks for a checkpoint.
#pragma once

namespace frit::app {

void catch_interrupts();

// The signal that came, or 0.
int interrupt_received();

// Whether a checkpoint has been asked for since the last call.
bool checkpoint_asked();

}  // namespace frit::app
