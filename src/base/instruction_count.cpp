#include "base/instruction_count.h"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace flatray {

InstructionCount::InstructionCount() {
  perf_event_attr wanted{};
  wanted.size = sizeof wanted;
  wanted.type = PERF_TYPE_HARDWARE;
  wanted.config = PERF_COUNT_HW_INSTRUCTIONS;
  wanted.pinned = 1;  // all the time, or not at all: what is counted in part is scaled, a guess
  wanted.exclude_kernel = 1;
  wanted.exclude_hv = 1;
  constexpr int kThisThread = 0, kAnyProcessor = -1, kNoGroup = -1;
  counter_ = static_cast<int>(syscall(SYS_perf_event_open, &wanted, kThisThread, kAnyProcessor,
                                      kNoGroup, PERF_FLAG_FD_CLOEXEC));
}

InstructionCount::~InstructionCount() {
  if (counter_ >= 0) close(counter_);
}

std::optional<std::uint64_t> InstructionCount::read() const {
  std::uint64_t count = 0;
  if (counter_ < 0 || ::read(counter_, &count, sizeof count) != sizeof count) return std::nullopt;
  return count > 0 ? std::optional(count) : std::nullopt;
}

}  // namespace flatray
