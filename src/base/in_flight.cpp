#include "base/in_flight.h"

#include <unistd.h>

#include <array>
#include <atomic>

namespace flatray {
namespace {

// A signal handler may neither lock nor allocate: names stand in places that are always there. As
// many as there can be threads; a file without a place would only be left for remove_leftovers().
std::array<std::atomic<const char*>, 1024> names{};
std::atomic<bool> ending{false};
static_assert(std::atomic<const char*>::is_always_lock_free &&
              std::atomic<bool>::is_always_lock_free);

}  // namespace

InFlight::InFlight(const std::filesystem::path& temporary) : path_(temporary.string()), slot_(0) {
  for (; slot_ < names.size(); ++slot_) {
    const char* none = nullptr;
    if (names[slot_].compare_exchange_strong(none, path_.c_str())) return;
  }
}

// A handler that took the name before it was gone from its place has set `ending` before, and needs
// the text until the program ends.
InFlight::~InFlight() {
  if (slot_ < names.size()) names[slot_] = nullptr;
  while (ending) ::pause();
}

void remove_in_flight() {
  ending = true;
  for (const std::atomic<const char*>& name : names)
    if (const char* path = name) ::unlink(path);
}

}  // namespace flatray
