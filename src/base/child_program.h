#pragma once
#include <sys/types.h>

#include <span>
#include <string>
#include <vector>

#include "base/descriptor.h"

namespace flatray {

/// A program that was started, is fed by a pipe, and writes one file; ended by force where it is not
/// waited for. What it says is kept for when it fails. It has a process group of its own: Ctrl-C is its
/// starter's to hear.
class ChildProgram {
 public:
  /// Starts `words[0]`, found on PATH, with the others and "/dev/fd/3" as arguments: `output`, by
  /// whatever name it has or had. No shell reads them.
  /// Error   Trouble::unavailable where it cannot be started, with the system's reason, and with
  ///         `remedy` where there is no such program.
  static Result<ChildProgram> start(std::vector<std::string> words, const Descriptor& output,
                                    const char* remedy = "");
  ChildProgram(ChildProgram&& other) noexcept;
  ChildProgram& operator=(ChildProgram&&) = delete;
  ~ChildProgram();

  /// False where it does not read on. Needs   that SIGPIPE is ignored.
  bool feed(std::span<const std::byte> bytes) const { return write_all(input_, bytes); }
  /// Ends its input and waits for its end, which comes at once where `stop` says so.
  /// Error   Trouble::output: how it ended, and the last line that it said.
  Result<void> finish(bool (*stop)() = nullptr);
  /// The last line that it said; "" where it was silent.
  std::string last_words() const;

 private:
  ChildProgram(std::string name, Descriptor input, Descriptor said)
      : name_(std::move(name)), input_(std::move(input)), said_(std::move(said)) {}
  std::string name_;
  Descriptor input_;  ///< the end of its pipe
  Descriptor said_;   ///< a file without a name: its standard output and error
  pid_t process_ = -1;
};

}  // namespace flatray
