#pragma once
#include <cstdint>
#include <optional>

namespace flatray {

/// Instructions that the calling thread runs outside the system's kernel, counted from here on: they
/// tell the work of a piece of code on a machine that is busy with other things, which times do not.
///
/// Needs   Linux that lets a program count its own instructions (perf_event_paranoid up to 2), and a
///         processor that shows its counters; virtual machines mostly hide them.
class InstructionCount {
 public:
  InstructionCount();
  ~InstructionCount();
  InstructionCount(const InstructionCount&) = delete;
  InstructionCount& operator=(const InstructionCount&) = delete;

  /// So far; nothing where this machine does not count them, or has not counted all.
  std::optional<std::uint64_t> read() const;

 private:
  int counter_ = -1;
};

}  // namespace flatray
