#include "app/interrupts.hpp"

#include <unistd.h>

#include <csignal>

namespace frit::app {
namespace {

volatile std::sig_atomic_t received = 0, checkpoints_asked = 0;

extern "C" void remember_signal(int signal) {
  if (received != 0) ::_exit(128 + signal);
  received = signal;
}

extern "C" void remember_request(int) { checkpoints_asked = 1; }

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = remember_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  action.sa_handler = remember_request;
  sigaction(SIGUSR1, &action, nullptr);
}

int interrupt_received() { return received; }

bool checkpoint_asked() {
  if (checkpoints_asked == 0) return false;
  checkpoints_asked = 0;
  return true;
}

}  // namespace frit::app
