#include "app/interrupt.h"

#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "base/in_flight.h"

namespace flatray {
namespace {

constexpr double kGrace = 0.6;
constexpr int kAskToStop[] = {SIGINT, SIGTERM, SIGHUP};

// The globals of the program: a signal handler has no other way to hear or say anything.
std::atomic<int> stop{0};  // the signal that asked for it
std::atomic<const char*> what_is_kept{nullptr};
std::atomic<bool> told{false};  // somebody has said it, or is about to

const char* word_of_stop() {
  if (stop == SIGALRM) return "the time of --max-seconds is over";
  if (stop == SIGHUP) return "hung up";
  return stop == SIGTERM ? "terminated" : "interrupted";
}

void say(const char* text) {
  if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;  // nobody listens
}

[[noreturn]] void end() {
  remove_in_flight();
  if (told.exchange(true)) ::_exit(interrupted_code());
  const char* kept = what_is_kept;
  say(::isatty(STDERR_FILENO) == 1 ? "\nflatray: " : "flatray: ");  // below a bar of progress
  say(word_of_stop());
  say("; ");
  say(kept != nullptr ? kept : "files written are whole");
  say("\n");
  ::_exit(interrupted_code());
}

// SIGALRM is the end of time, and of the grace after any other.
void ask_to_stop(int signal) {
  const int error = errno;
  const bool again = stop != 0;
  if (!again) stop = signal;
  if (again || what_is_kept == nullptr) end();
  limit_seconds(kGrace);
  errno = error;
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

void take(int signal) {
  struct sigaction action {};
  action.sa_handler = &ask_to_stop;
  action.sa_flags = SA_RESTART;
  for (const int other : kAskToStop) ::sigaddset(&action.sa_mask, other);
  ::sigaddset(&action.sa_mask, SIGALRM);
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_interrupts(const char* kept) {
  what_is_kept = kept;
  for (const int signal : kAskToStop)
    if (!is_ignored(signal)) take(signal);
  take(SIGALRM);
}

void limit_seconds(double seconds) {
  const double whole = std::floor(seconds);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - whole) * 1e6);
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

void survive_file_limits() { ::signal(SIGXFSZ, SIG_IGN); }

void survive_closed_pipes() { ::signal(SIGPIPE, SIG_IGN); }

void expect_crashes_of_gl() {
  constexpr int kUnavailable = 5;
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT})
    ::signal(signal, [](int) {
      remove_in_flight();
      say("flatray: the GL library crashed, as it does where memory ends; --backend software draws "
          "without it\n");
      ::_exit(kUnavailable);
    });
}

bool interrupted() { return stop != 0; }

int interrupted_code() { return stop == SIGALRM ? kOverLimit : 128 + stop; }

const char* interruption() {
  told = true;
  return word_of_stop();
}

}  // namespace flatray
