#include "base/in_flight.h"

#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>

namespace flatray {
namespace {

// A signal handler may neither lock nor allocate: files stand in places that are always there. As
// many as there can be threads; a file without a place would only be left for remove_leftovers().
std::array<std::atomic<const InFlight*>, 1024> files{};
std::atomic<bool> ending{false};
std::atomic<int> program{-1};
static_assert(std::atomic<const InFlight*>::is_always_lock_free &&
              std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

bool is_same_file(int file, const char* path) {
  struct stat open {
  }, named{};
  return ::fstat(file, &open) == 0 && ::stat(path, &named) == 0 && open.st_ino == named.st_ino &&
         open.st_dev == named.st_dev;
}

}  // namespace

InFlight::InFlight(const std::filesystem::path& temporary, int locked)
    : path_(temporary.string()), locked_(locked), slot_(0) {
  for (; slot_ < files.size(); ++slot_) {
    const InFlight* none = nullptr;
    if (files[slot_].compare_exchange_strong(none, this)) return;
  }
}

// A handler that took the file before it was gone from its place has set `ending` before, and needs
// its name until the program ends.
InFlight::~InFlight() {
  if (slot_ < files.size()) files[slot_] = nullptr;
  while (ending) ::pause();
}

void InFlight::remove() const {
  if (locked_ >= 0 &&
      (::flock(locked_, LOCK_EX | LOCK_NB) != 0 || !is_same_file(locked_, path_.c_str())))
    return;
  ::unlink(path_.c_str());
}

void set_program_in_flight(int process) { program = process; }

void remove_in_flight() {
  ending = true;
  if (const int process = program; process > 0) ::kill(process, SIGKILL);
  for (const std::atomic<const InFlight*>& one : files)
    if (const InFlight* file = one) file->remove();
}

}  // namespace flatray
