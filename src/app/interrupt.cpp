#include "app/interrupt.h"

#include <csignal>

namespace flatray {
namespace {

// The one global of the program: a signal handler has no other way to say anything.
volatile std::sig_atomic_t stop = 0;

void ask_to_stop(int) { stop = 1; }

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = &ask_to_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

void survive_file_limits() { std::signal(SIGXFSZ, SIG_IGN); }

bool interrupted() { return stop != 0; }

}  // namespace flatray
